#include <explore/simulation/door_passage.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace explore::simulation
{
namespace
{
constexpr double kRounding_m = 1e-9;

bool traversable(Verdict verdict)
{
	return verdict == Verdict::open || verdict == Verdict::ajar || verdict == Verdict::passage;
}

/** Across the opening, measured from its middle: what moving bodies cover of it. */
std::vector<std::pair<double, double>> coveredNow(const DoorLabel& label, const RayScene& scene)
{
	const Eigen::Vector3d normal = label.normal_in_map.normalized();
	const Eigen::Vector3d across = Eigen::Vector3d::UnitZ().cross(normal);
	const std::vector<Eigen::Isometry3d> map_from_body = scene.placement();
	std::vector<std::pair<double, double>> covered;
	for (std::size_t i = 0; i < map_from_body.size(); ++i)
	{
		const MovingBody& body = scene.world().moving[i];
		const Eigen::Vector3d offset = map_from_body[i].translation() - label.floor_center_in_map;
		if (std::abs(offset.dot(normal)) > 0.5 * label.depth_m + body.radius_m) continue;
		const double top = label.height_m.value_or(std::numeric_limits<double>::infinity());
		if (offset.z() >= top || offset.z() + body.height_m <= 0.0) continue;
		const double middle = offset.dot(across);
		covered.emplace_back(middle - body.radius_m, middle + body.radius_m);
	}
	std::sort(covered.begin(), covered.end());
	return covered;
}

/** The widest piece of the opening that nothing covers. */
double widestGap(const std::vector<std::pair<double, double>>& covered, double width_m)
{
	double widest = 0.0, free_from = -0.5 * width_m;
	for (const auto& [low, high] : covered)
	{
		widest = std::max(widest, std::min(low, 0.5 * width_m) - free_from);
		free_from = std::max(free_from, high);
	}
	return std::max(widest, 0.5 * width_m - free_from);
}

bool fitsInHeight(const DoorLabel& label, const RobotConfig& robot)
{
	const double top = label.height_m.value_or(std::numeric_limits<double>::infinity());
	if (robot.kind == RobotKind::ground)
		return label.sill_m <= kStepHeight_m + kRounding_m && robot.height_m + kPassingMargin_m <= top + kRounding_m;
	const double half = 0.5 * robot.height_m + kPassingMargin_m;
	const double lowest = std::max(robot.min_altitude_m, label.sill_m + half);
	const double highest = std::min(robot.max_altitude_m, top - half);
	return lowest <= highest + kRounding_m;
}
}  // namespace

Passage passageOf(const DoorLabel& label, const RayScene& scene, const RobotConfig& robot)
{
	const double needed_m = 2.0 * (robot.radius_m + kPassingMargin_m);
	const auto wide_enough = [&](double width_m) { return width_m + kRounding_m >= needed_m; };
	Passage passage{label.clear_width_m, label.verdict, false};
	const auto covered = coveredNow(label, scene);
	if (!covered.empty()) passage.clear_width_m = std::min(passage.clear_width_m, widestGap(covered, label.width_m));
	if (traversable(label.verdict) && wide_enough(label.clear_width_m) && !wide_enough(passage.clear_width_m))
		passage.verdict = Verdict::blocked;

	const bool over_the_sill =
	    robot.kind == RobotKind::mav && label.verdict == Verdict::blocked && label.sill_m > kStepHeight_m;
	passage.passable = (traversable(passage.verdict) || over_the_sill) && wide_enough(passage.clear_width_m) &&
	                   fitsInHeight(label, robot);
	return passage;
}
}  // namespace explore::simulation

#include <explore/simulation/corridor_truth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace explore::simulation
{
namespace
{
constexpr double kStation_m = 0.1, kBeforeWall_m = 0.02, kWall_m = 0.1, kHeightStep_m = 0.3;
constexpr double kNarrowest_m = 0.8, kWidest_m = 4.0, kCorridorWidths = 3.0, kScoredWidths = 1.3;
constexpr double kShareOfWall = 1.0 / 3.0;

using Stations = std::vector<bool>;  ///< seen, by station along the axis

Stations lookAtWall(const CorridorLabel& label, double side, const RayScene& scene, const TruthView& view)
{
	const Eigen::Vector2d axis = label.end_in_map - label.start_in_map;
	const Eigen::Vector2d along = axis.normalized(), left(-along.y(), along.x());
	const auto count = static_cast<std::size_t>(std::floor(axis.norm() / kStation_m));
	const double height = view.cameraInMap().z();
	const auto seen = [&](const Eigen::Vector2d& place, double z)
	{
		const Eigen::Vector3d point(place.x(), place.y(), z);
		return view.sightOf(point) == PointSight::clear && scene.clearance(point, kWall_m) < kWall_m;
	};
	Stations stations(count);
	for (std::size_t i = 0; i < count; ++i)
	{
		const Eigen::Vector2d place = label.start_in_map + (static_cast<double>(i) + 0.5) * kStation_m * along +
		                              side * (0.5 * label.width_m - kBeforeWall_m) * left;
		stations[i] = seen(place, height) || seen(place, height - kHeightStep_m) || seen(place, height + kHeightStep_m);
	}
	return stations;
}

/** Length [m] between the first and the last station seen of both walls; 0 where too little of one is seen. */
double commonLength(const Stations& left, const Stations& right)
{
	const auto first = [](const Stations& wall) { return std::find(wall.begin(), wall.end(), true) - wall.begin(); };
	const auto end = [](const Stations& wall) { return wall.rend() - std::find(wall.rbegin(), wall.rend(), true); };
	const auto from = std::max(first(left), first(right)), to = std::min(end(left), end(right));
	if (from >= to) return 0.0;
	for (const Stations* wall : {&left, &right})
		if (static_cast<double>(std::count(wall->begin() + from, wall->begin() + to, true)) <
		    kShareOfWall * static_cast<double>(to - from))
			return 0.0;
	return static_cast<double>(to - from) * kStation_m;
}

CorridorState stateOf(double length_m, double width_m)
{
	// A station more or less is within the rounding of the labels.
	const double widths = (length_m + 0.5 * kStation_m) / width_m;
	if (widths >= kCorridorWidths) return CorridorState::corridor;
	return widths >= kScoredWidths ? CorridorState::not_scored : CorridorState::none;
}

Eigen::Vector3d awayFromCamera(const CorridorLabel& label, const TruthView& view)
{
	const Eigen::Vector2d along = (label.end_in_map - label.start_in_map).normalized();
	const Eigen::Vector3d direction(along.x(), along.y(), 0.0);
	const Eigen::Vector3d camera = view.cameraInMap();
	return view.depthOf(camera + direction) < 0.0 ? Eigen::Vector3d(-direction) : direction;
}
}  // namespace

TruthCorridor corridorInView(const RayScene& scene, const TruthView& view)
{
	TruthCorridor best;
	double longest = 0.0;
	for (const CorridorLabel& label : scene.world().corridors)
	{
		if (label.width_m < kNarrowest_m || label.width_m > kWidest_m) continue;
		const double length = commonLength(lookAtWall(label, 1.0, scene, view), lookAtWall(label, -1.0, scene, view));
		const CorridorState state = stateOf(length, label.width_m);
		if (state < best.state || (state == best.state && length <= longest)) continue;
		longest = length;
		best = {state, awayFromCamera(label, view), label.width_m};
	}
	return best;
}
}  // namespace explore::simulation

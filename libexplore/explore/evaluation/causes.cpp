#include <explore/evaluation/cause_geometry.h>
#include <explore/evaluation/causes.h>

#include <algorithm>

namespace explore::evaluation
{
namespace
{
struct CauseText
{
	std::string_view name, sentence;
};
constexpr std::array<CauseText, 13> kTexts{{
    {"association", "one door, two reports: the second is no door of its own"},
    {"size_limit", "the door is narrower or wider than the method looks for, or hardly wide enough for the robot"},
    {"misplaced", "it was found, but its centre or width is outside the tolerance"},
    {"ground_wrong", "the floor was not found, or is not where it was found"},
    {"evidence_wrong", "floor, wall and view are right, and the place was judged wrongly"},
    {"wall_missed", "no wall was found in the plane of the door"},
    {"wall_split", "more than one wall was found in the plane of the door"},
    {"jamb_out_of_view", "the wall beside a jamb is outside the image"},
    {"occluded", "something stands before it"},
    {"noise_at_range", "a jamb is more than 4 m away, where the sensor is coarse"},
    {"door_hidden", "a door is there, but it is not visible from here"},
    {"undecided", "it was found, and reported as partial or unknown"},
    {"clearance_wrong", "it was found, and thought too narrow or too low for the robot"},
}};

constexpr double kFar_m = 4.0;           // the depth step of a structured-light camera reaches the plane tolerance
constexpr double kSeenLess = 0.15;       // share of the opening that something hides before it counts as occluded
constexpr double kRobotMargin_m = 0.10;  // beyond the robot's diameter: as fitsThrough()
constexpr double kWidthDoubt_m = 0.05;   // how far a width may be off
constexpr double kLooseCenter_m = kCenterTolerances_m.back();

bool far(const CauseGeometry& geometry, const std::array<Eigen::Vector2d, 2>& jambs)
{
	return std::ranges::any_of(jambs,
	                           [&](const Eigen::Vector2d& jamb) { return (jamb - geometry.camera()).norm() > kFar_m; });
}

/** Too narrow or too wide for the paper's gaps; for others too narrow to say that the robot fits through. */
bool outsideLimits(const TruthDoor& door, const CauseInput& input)
{
	const PerceptionConfig& config = input.perception;
	if (config.method != PerceptionMethod::paper)
		return door.clear_width_m < 2.0 * input.robot.radius_m + kRobotMargin_m + kWidthDoubt_m;
	const double blur_m = config.voxel_grid.voxel_size_m;
	return door.width_m < config.door_gaps.min_gap_m + blur_m || door.width_m > config.door_gaps.max_gap_m - blur_m;
}

/** A positive report that agrees with the door and was given to another, or has no door. */
bool wasFound(const CauseInput& input, const TruthDoor& door, double tolerance_m)
{
	return std::ranges::any_of(
	    input.reports, [&](const Report& report) { return report.positive && agrees(report, door, tolerance_m); });
}

/** Of a report that is not positive, at a door that should be passed. */
Cause causeOfRefusal(const Report& report)
{
	switch (report.door.verdict)
	{
		case Verdict::partial:
		case Verdict::unknown:
			return Cause::undecided;
		case Verdict::open:
		case Verdict::ajar:
		case Verdict::passage:
			return Cause::clearance_wrong;
		default:
			return Cause::evidence_wrong;
	}
}

Cause causeOfMiss(const CauseInput& input, const TruthDoor& door)
{
	const CauseGeometry geometry(input);
	const Eigen::Vector3d foot = footOf(door);
	const Eigen::Vector2d center = foot.head<2>(), normal = door.normal_in_map.head<2>();
	const auto jambs = jambsOf(center, normal, door.width_m);
	const auto near = [&](const Report& report) { return centerDistance(report, door) <= kLooseCenter_m; };

	if (wasFound(input, door, kCenterTolerances_m[kMainTolerance])) return Cause::association;
	if (std::ranges::any_of(input.reports, [&](const Report& report) { return report.positive && near(report); }))
		return Cause::misplaced;
	const auto there = std::ranges::find_if(input.reports, near);
	if (there != input.reports.end()) return causeOfRefusal(*there);
	if (outsideLimits(door, input)) return Cause::size_limit;
	if (geometry.groundWrong(foot)) return Cause::ground_wrong;
	if (geometry.besideImage(jambs, foot.z())) return Cause::jamb_out_of_view;
	if (door.visible_share < geometry.shareInImage(door) - kSeenLess || geometry.behindObstacle(jambs))
		return Cause::occluded;
	const int walls = geometry.wallsAt(center, normal);
	if (walls == 0) return far(geometry, jambs) ? Cause::noise_at_range : Cause::wall_missed;
	if (walls > 1) return Cause::wall_split;
	return far(geometry, jambs) ? Cause::noise_at_range : Cause::evidence_wrong;
}

/** The first true door, in the frame's order, for which `condition` holds. */
template <class Condition>
bool anyDoor(const CauseInput& input, const Condition& condition)
{
	return std::ranges::any_of(input.truth.doors, condition);
}

Cause causeOfFalseAlarm(const CauseInput& input, const Report& report)
{
	const CauseGeometry geometry(input);
	const Eigen::Vector2d& center = report.center_in_map;
	const auto jambs = jambsOf(center, report.normal_in_map, report.door.width_m);
	const double floor_m = geometry.floorNear(center);
	const auto near = [&](const TruthDoor& door) { return centerDistance(report, door) <= kLooseCenter_m; };

	if (anyDoor(input,
	            [&](const TruthDoor& door)
	            {
		            return isPositive(door) && door.visibility == Visibility::visible &&
		                   agrees(report, door, kCenterTolerances_m[kMainTolerance]);
	            }))
		return Cause::association;
	if (anyDoor(input, [&](const TruthDoor& door)
	            { return isPositive(door) && door.visibility == Visibility::visible && near(door); }))
		return Cause::misplaced;
	if (geometry.groundWrong({center.x(), center.y(), floor_m})) return Cause::ground_wrong;
	if (anyDoor(input, [&](const TruthDoor& door) { return !isPositive(door) && near(door); }))
		return Cause::evidence_wrong;
	if (anyDoor(input, near)) return Cause::door_hidden;
	if (geometry.behindObstacle(jambs)) return Cause::occluded;
	if (far(geometry, jambs)) return Cause::noise_at_range;
	if (geometry.besideImage(jambs, floor_m)) return Cause::jamb_out_of_view;
	if (geometry.wallsAt(center, report.normal_in_map) > 1) return Cause::wall_split;
	return Cause::evidence_wrong;
}
}  // namespace

std::string_view nameOf(Cause cause)
{
	return kTexts.at(static_cast<std::size_t>(cause)).name;
}

std::string_view sentenceOf(Cause cause)
{
	return kTexts.at(static_cast<std::size_t>(cause)).sentence;
}

Cause causeOf(const CauseInput& input, const DoorPair& pair)
{
	return pair.outcome == Outcome::miss ? causeOfMiss(input, input.truth.doors.at(*pair.truth))
	                                     : causeOfFalseAlarm(input, input.reports.at(*pair.report));
}
}  // namespace explore::evaluation

#include <explore/navigation/avoider.h>
#include <explore/navigation/best_direction.h>
#include <explore/navigation/mrpt_avoiders.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore
{
namespace
{
/** The least open path among the directions from straight ahead to the chosen one; 0 when it leads where most of what
 *  the hull first passes through was not seen. */
double turningPath(const Ways& ways, const Avoidance& avoidance, const AvoiderConfig& config)
{
	const double turn = avoidance.heading_rad.value_or(0.0);
	const double steps = std::max(1.0, std::ceil(std::abs(turn) / config.resolution_rad));
	const double step = std::max(std::abs(turn) / steps, 1e-6);
	const DirectionFan fan{std::min(turn, 0.0), step, static_cast<std::size_t>(steps) + 1, avoidance.elevation_rad};
	const WayFan found = ways.along(fan);
	const bool seen = turn < 0.0 ? found.seen_start.front() : found.seen_start.back();
	return seen ? *std::min_element(found.open_m.begin(), found.open_m.end()) : 0.0;
}
}  // namespace

void describe(FieldVisitor& fields, AvoiderConfig& config)
{
	static constexpr std::array<std::string_view, 5> kMethods{"open_path", "paper", "CHolonomicND", "CHolonomicVFF",
	                                                          "CHolonomicFullEval"};
	static constexpr std::array<std::string_view, 3> kRemedies{"none", "swept_corridor", "unseen_blocks"};
	fields.section("avoider", "Reactive obstacle avoidance (paper section 3.2)");
	fields.choice("method", config.method, kMethods,
	              "open_path: the paper's way, mended; paper: as printed, but for its corridor; or one of MRPT's");
	fields.choice("leave_out", config.leave_out, kRemedies,
	              "a remedy that open_path does without, to see what it buys");
	fields.degrees("sector_deg", config.sector_rad, {1.0, 90.0},
	               "candidate directions lie within +- this of the goal; with what the camera saw, all in view do");
	fields.degrees("resolution_deg", config.resolution_rad, {0.25, 15.0}, "between candidate directions");
	fields.real("max_range", config.max_range_m, {0.5, 50.0}, "m", "open paths are not looked at further than this");
	fields.real("clearance", config.clearance_m, {0.0, 1.0}, "m", "added to the robot's radius and height");
	fields.real("clearance_range", config.clearance_range_m, {0.1, 50.0}, "m",
	            "the clearance fades to a fifth at this distance from the robot");
	fields.real("step_height", config.step_height_m, {0.0, 0.5}, "m",
	            "a ground robot rolls over what is lower, and down steps that are less deep");
	fields.degrees("max_elevation_deg", config.max_elevation_rad, {0.0, 60.0}, "steepest climb and descent of a MAV");
	fields.degrees("elevation_step_deg", config.elevation_step_rad, {1.0, 45.0},
	               "between a MAV's candidate elevations");
}

Avoidance avoid(const AvoiderInput& input, const RobotConfig& robot, const AvoiderConfig& config)
{
	const Ways ways(input, robot, config);
	const bool scores = config.method == AvoiderMethod::open_path || config.method == AvoiderMethod::paper;
	Avoidance result = scores ? bestDirection(ways, input, robot, config) : mrptDirection(ways, input, config);
	if (result.heading_rad) result.turning_path_m = turningPath(ways, result, config);
	return result;
}
}  // namespace explore

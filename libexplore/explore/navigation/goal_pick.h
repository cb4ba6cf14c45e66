// Which of the frontiers comes first: the nearest, or the first of the shortest tour that ends at home.
#pragma once

#include <explore/navigation/look_targets.h>
#include <explore/navigation/mission.h>

#include <optional>
#include <vector>

namespace explore
{
/** What goals are picked from. */
struct PickInput
{
	const PlanMap& map;
	const TravelField& field;  ///< from the robot
	const std::vector<LookTarget>& targets;
	double yaw_rad = 0;                  ///< of the robot, in the map
	CellIndex home = kNoCell;            ///< the robot's cell where the map does not have it
	std::optional<std::size_t> current;  ///< index of the target that the robot goes for now
};

/** Index of the target to go for; `targets` must not be empty. No value: none is worth the way (pocket_worth). The
 * current one is kept unless another first goal makes the tour shorter by switch_gain_m, and one that was left lately
 * comes first only where that saves return_gain_m. */
std::optional<std::size_t> firstOfTour(const PickInput& input, const RobotConfig& robot, const PlanConfig& config);

/** Index of the target with the least way. */
std::size_t nearestTarget(const std::vector<LookTarget>& targets);
}  // namespace explore

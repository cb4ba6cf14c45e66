// The openings in a view's walls: doors and passages with verdict and confidence (method = full).
#pragma once

#include <explore/perception/corridor_end.h>
#include <explore/perception/opening_candidates.h>
#include <explore/perception/remedies.h>

#include <vector>

namespace explore
{
/** The openings of all walls; of those that overlap, the surest. Best first. */
std::vector<Opening> findOpenings(const LevelView& view, const std::vector<UprightWall>& walls,
                                  const RobotConfig& robot, const OpeningsConfig& config,
                                  const SensorNoiseConfig& noise);

/** Where a corridor ends, as an opening. */
Opening openingOf(const CorridorEnd& end, const RobotConfig& robot, const VerdictConfig& config);

/** The same as the rest of the program wants it: a door in the robot frame. */
Door doorOf(const Opening& opening, const LevelPose& pose);
}  // namespace explore

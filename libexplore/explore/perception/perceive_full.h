// method = full: level view, walls, corridor, openings, obstacles.
#pragma once

#include <explore/perception/full_view.h>
#include <explore/perception/perceive.h>

namespace explore
{
/** The openings of walls and the ends of corridors. */
std::vector<Opening> allOpenings(const FullView& view, const RobotConfig& robot, const PerceptionConfig& config);

/** Of an organised frame. */
Percepts perceiveFull(const DepthFrame& frame, const PerceptionConfig& given, const RobotConfig& robot,
                      PerceptionMemory& memory);
}  // namespace explore

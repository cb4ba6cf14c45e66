// The surfaces of one frame that all else of method = full rests on: level view and upright walls.
#pragma once

#include <explore/perception/perception_config.h>

#include <vector>

namespace explore
{
struct FullView
{
	LevelView level;
	std::vector<UprightWall> walls;  ///< in the level frame
	CorridorPairs corridors;         ///< walls that face each other
};

/** The frame must be organised and outlive the result. */
FullView fullView(const DepthFrame& frame, const PerceptionConfig& config, const RobotConfig& robot,
                  const GroundMemory& memory);
}  // namespace explore

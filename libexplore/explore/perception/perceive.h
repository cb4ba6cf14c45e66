// Perception of one frame: paper §3.1, the first 25 lines of Algorithm 1. Pure: same frame, config and seed, same
// result.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/results.h>
#include <explore/perception/perception_config.h>

namespace explore
{
Percepts perceive(const DepthFrame& frame, const PerceptionConfig& config);
}  // namespace explore

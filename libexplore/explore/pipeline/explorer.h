// The explorer's main step: Algorithm 1 of the paper, continued to a heading.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/navigation/mission.h>
#include <explore/navigation/steering.h>
#include <explore/perception/perceive.h>
#include <explore/pipeline/explorer_config.h>

#include <functional>
#include <memory>
#include <optional>
#include <string_view>

namespace explore
{
/** All that is carried from frame to frame. */
struct ExplorerState
{
	std::optional<mrpt::Clock::time_point> last_timestamp;
	std::optional<Ground> last_ground;
	PerceptionMemory perception;
	NearFieldGuard guard;
	double speed_mps = 0;  ///< last commanded
	std::unique_ptr<FrontierMemory> memory;  ///< from the first frame with a pose on
	Mission mission;
	Steering steering;
};

struct StepResult
{
	Percepts percepts;
	Decision decision;
	bool finished = false;  ///< the exploration is over: nothing is left to do for the robot
};

/** Called when a stage has ended, with its name; lets the caller measure time without a clock in here. */
using StageEnded = std::function<void(std::string_view stage)>;

/** One frame: perceive → remember → choose goal → avoid → heading. Deterministic; updates `state`. */
StepResult step(const DepthFrame& frame, ExplorerState& state, const ExplorerConfig& config,
                const StageEnded& ended = {});
}  // namespace explore

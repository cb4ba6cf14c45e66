// The explorer's main step: Algorithm 1 of the paper, continued to a heading.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/perception/perceive.h>
#include <explore/pipeline/explorer_config.h>

#include <functional>
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
};

struct StepResult
{
	Percepts percepts;
	Decision decision;
};

/** Called when a stage has ended, with its name; lets the caller measure time without a clock in here. */
using StageEnded = std::function<void(std::string_view stage)>;

/** One frame: perceive → choose goal → avoid → heading. Deterministic; updates `state`. */
StepResult step(const DepthFrame& frame, ExplorerState& state, const ExplorerConfig& config,
                const StageEnded& ended = {});
}  // namespace explore

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
	double speed_mps = 0;                    ///< last commanded
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

/** Writes a state, or reads it into an empty one: explorers of the same configuration go on from both in the same way.
 */
template <class Archive>
void exchange(Archive& archive, ExplorerState& state, const ExplorerConfig& config)
{
	auto& [last_timestamp, last_ground, perception, guard, speed_mps, memory, mission, steering] =
	    state;  // all there is
	archive(last_timestamp), archive(last_ground), archive(perception), archive(guard), archive(speed_mps);
	archive(mission), archive(steering);
	bool remembers = memory != nullptr;
	archive(remembers);
	if (remembers && !memory) memory = std::make_unique<FrontierMemory>(config.memory, config.robot);
	if (remembers) archive(*memory);
}

/** Called when a stage has ended, with its name; lets the caller measure time without a clock in here. */
using StageEnded = std::function<void(std::string_view stage)>;

/** One frame: perceive → remember → choose goal → avoid → heading. Deterministic; updates `state`. */
StepResult step(const DepthFrame& frame, ExplorerState& state, const ExplorerConfig& config,
                const StageEnded& ended = {});
}  // namespace explore

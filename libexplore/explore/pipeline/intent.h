// What the robot wants in this frame: from the memory and its mission, or from the frame alone.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/navigation/goal_choice.h>
#include <explore/navigation/steering.h>
#include <explore/pipeline/explorer_config.h>

namespace explore
{
struct Intent
{
	GoalChoice choice;
	SteeringGoal steering;
	bool may_move_blindly = false;  ///< turn and back off, though the frame be empty
	bool finished = false;          ///< the exploration is over, and the robot is home
};

/** With `memory`, θ_o and θ_v are those of confirmed tracks, and the goal is the mission's (policy paper: the tracks');
 *  without, all is as this frame has it. */
Intent intend(const DepthFrame& frame, const Percepts& percepts, const FrontierMemory* memory, Mission& mission,
              Steering& steering, const ExplorerConfig& config);
}  // namespace explore

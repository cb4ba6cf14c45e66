// Logs with truth made by hand: rooms of rectangles, rendered ray by ray, and what is truly in them.
#pragma once

#include "apps/program.h"
#include "support/analytic_scene.h"

#include <explore/core/truth.h>

#include <filesystem>
#include <string>
#include <vector>

namespace explore::test
{
/** A wall across the robot's way with a door in it. */
struct DoorScene
{
	double wall_x_m = 2.6;       ///< from the robot, along its heading
	double door_y_m = 0.0;       ///< of the door's middle; left is positive
	double door_width_m = 0.95;  ///< 0: a wall without a door
	bool labelled = true;        ///< false: the truth does not know the door, so that its report is a false alarm
	double boxed_at_x_m = 0.0;   ///< a box in the robot's way; 0: none
};

/** Writes FOLDER/NAME.rawlog and its truth: a frame a scene. The truth has exact doors and free paths that end at the
 *  wall or pass through the door. Returns the log's path. */
std::filesystem::path writeScoredLog(const std::filesystem::path& folder, const std::string& name,
                                     const std::vector<DoorScene>& scenes, const TruthLog& head);

/** Runs explore-eval to its end. Logs are scored with the paper's method, whose results the tests know. */
ProgramResult exploreEval(std::vector<std::string> arguments, const Program::Setup& setup = {});

/** A TruthLog without frames: ground robot, family and configuration as given. */
TruthLog headOf(const std::string& family, const std::string& configuration, bool negative = false);
}  // namespace explore::test

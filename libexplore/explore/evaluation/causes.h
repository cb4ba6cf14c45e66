// Why a report is false or a door was missed: one code each, by fixed rules from the truth and what perception found.
#pragma once

#include <explore/evaluation/door_pairs.h>
#include <explore/perception/perception_config.h>

#include <string_view>

namespace explore::evaluation
{
/** In doc/definitions.md, "Cause codes", with their rules. */
enum class Cause
{
	association,       ///< a second report of a door, or a door whose report was given to another
	size_limit,        ///< narrower or wider than the method looks for
	misplaced,         ///< found, but centre or width is outside the tolerance
	ground_wrong,      ///< no floor, or not where it is
	evidence_wrong,    ///< the place was looked at and judged wrongly
	wall_missed,       ///< the door's wall was not found
	wall_split,        ///< the door's wall was found in pieces
	jamb_out_of_view,  ///< the wall beside a jamb is outside the image
	occluded,          ///< something stands before it
	noise_at_range,    ///< too far for the sensor
	door_hidden,       ///< a true door, but not visible from here
	undecided,         ///< found, and not known what it is
	clearance_wrong,   ///< found, and thought too narrow or too low for the robot
};
std::string_view nameOf(Cause cause);
/** For a person who looks at the picture. */
std::string_view sentenceOf(Cause cause);

/** One frame as the rules see it. */
struct CauseInput
{
	const TruthFrame& truth;
	const CameraIntrinsics& intrinsics;
	const mrpt::poses::CPose3D& robot_from_camera;
	const Percepts& percepts;
	const PerceptionConfig& perception;
	const RobotConfig& robot;
	const std::vector<Report>& reports;
	const std::vector<DoorPair>& pairs;  ///< at the main tolerance
};

/** `pair` is a miss or a false alarm of `input.pairs`. */
Cause causeOf(const CauseInput& input, const DoorPair& pair);
}  // namespace explore::evaluation

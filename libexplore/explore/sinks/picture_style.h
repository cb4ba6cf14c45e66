// Colours and measures that both halves of a frame picture share.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/robot.h>
#include <explore/pipeline/explorer.h>
#include <explore/sinks/canvas.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace explore
{
/** What the pictures need to know besides the frame and its results. */
struct PictureConfig
{
	double max_range_m = 5.0;  ///< the plan view reaches this far; depth colours end here
	RobotConfig robot;
};

/** An opening as it is drawn. */
struct DoorMark
{
	std::array<Eigen::Vector3d, 4> corners_in_robot;    ///< floor, floor, lintel, lintel
	Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< of its wall, toward the robot
	mrpt::img::TColor color;
	std::string label;
	double label_height = 0.5;  ///< where the label stands: share of the opening's height
};

/** What is drawn besides the frame's own results. */
struct PictureNotes
{
	std::string title;  ///< instead of the usual one; empty = the usual one
	std::vector<DoorMark> doors;
};

namespace style
{
using mrpt::img::TColor;
inline const TColor kPaper(18, 21, 28), kPanel(27, 31, 41), kGrid(52, 59, 74), kText(214, 219, 229),
    kFaint(128, 137, 154);
inline const TColor kDoor(240, 84, 70), kDoorHeading(255, 209, 71), kVanishingPoint(255, 122, 198),
    kAvoid(255, 148, 54), kDesired(240, 240, 245), kChosen(74, 222, 128), kWall(86, 190, 255), kRobot(214, 219, 229),
    kFrontier(230, 159, 0);

/** Near is pale, far is deep blue: lightness falls evenly with `share` (0–1). */
TColor depthColor(double share);
/** Of what is so high above the floor: paler = higher. */
TColor heightColor(double height_m);
/** Of Okabe and Ito's colours, which nearly everybody can tell apart; those of the report. */
TColor verdictColor(Verdict verdict);
}  // namespace style

/** A point on the floor (where it was found; else at z = 0), `distance_m` away along `heading_rad`, robot frame. */
Eigen::Vector3d floorPoint(const std::optional<Ground>& ground, double heading_rad, double distance_m);

/** Which of the headings an arrow stands for. */
enum class HeadingKind
{
	vanishing_point,  ///< θ_v
	door,             ///< θ_o, to the nearest door
	avoid,            ///< θ_a
	chosen
};
/** As the headings of frames.jsonl are called. */
[[nodiscard]] std::string_view nameOf(HeadingKind kind);
namespace style
{
TColor headingColor(HeadingKind kind);
}  // namespace style

/** An arrow on the floor in front of the robot. */
struct HeadingArrow
{
	HeadingKind kind = HeadingKind::chosen;
	Eigen::Vector3d from_in_robot, to_in_robot;
};
/** Those that there are, the chosen one last. */
std::vector<HeadingArrow> headingArrows(const StepResult& result);

/** The four corners of an opening in the robot frame: floor, floor, lintel, lintel (2 m high where unknown). */
std::array<Eigen::Vector3d, 4> doorCorners(const Door& door, const std::optional<Ground>& ground);

/** A door of the results. */
DoorMark markOf(const Door& door, const std::optional<Ground>& ground);

/** "door 0.92 m", with the verdict where it is not `open`. */
std::string doorLabel(const Door& door);

/** The chosen heading, how far it is free and how fast, or why the robot stops. */
std::string decisionText(const Decision& decision);
}  // namespace explore

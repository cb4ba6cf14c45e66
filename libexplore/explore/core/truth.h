// What a simulated world really holds, frame by frame: written beside a log, read when a run is scored.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/results.h>
#include <explore/core/robot.h>
#include <mrpt/poses/CPose3D.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace explore
{
/** Whether a door has to be found in a frame (doc/definitions.md, "visible door"). */
enum class Visibility
{
	visible,  ///< both jambs in view over half their height, half of the opening unoccluded, both jambs within 5 m
	ignored,  ///< partly visible: finding it or not counts neither way
	hidden,   ///< a report here is a false alarm
};
[[nodiscard]] std::string_view nameOf(Visibility visibility);

/** An opening, in the map frame, as the noise-free rays of one frame's camera see it. */
struct TruthDoor
{
	std::string id;                                            ///< the same in every frame of a log
	Eigen::Vector3d center_in_map = Eigen::Vector3d::Zero();   ///< floor level + half the height (1 m without one)
	Eigen::Vector3d normal_in_map = Eigen::Vector3d::UnitX();  ///< of its wall, horizontal, toward the camera
	double width_m = 0;
	std::optional<double> height_m;  ///< no value: no lintel
	double clear_width_m = 0;        ///< what leaf and obstacles leave
	Verdict verdict = Verdict::open;
	bool passable = true;  ///< the robot fits through now
	Visibility visibility = Visibility::hidden;
	double visible_share = 0;  ///< of the opening's rays: in the image and not occluded, 0–1
	std::array<double, 2>
	    jamb_share{};  ///< of each jamb's height up to 2 m: in the image and not occluded; left, right
	bool lintel_in_view = false;
};

/** What there is to say about a corridor's direction in a frame. */
enum class CorridorState
{
	none,        ///< no facing walls: a direction is wrong
	not_scored,  ///< too short an overlap to say
	corridor,
};
[[nodiscard]] std::string_view nameOf(CorridorState state);

struct TruthCorridor
{
	CorridorState state = CorridorState::none;
	Eigen::Vector3d direction_in_map = Eigen::Vector3d::UnitX();  ///< unit, horizontal; sign without meaning
	double width_m = 0;
};

/** Something that stands in the way, as a vertical cylinder around it. */
struct TruthObstacle
{
	std::string kind;
	Eigen::Vector3d center_in_map = Eigen::Vector3d::Zero();
	double radius_m = 0, height_m = 0;
};

/** True free paths of the swept body from the robot's place, in its heading's level frame. */
struct TruthFreePaths
{
	static constexpr int kAzimuths = 360;  ///< azimuth i is i degrees, positive to the left, 0 = robot's x axis
	std::vector<double> elevations_rad;    ///< positive up; {0} for a ground robot
	std::vector<float> free_m;             ///< elevation-major, kAzimuths each; capped at cap_m
	double cap_m = 8;
};

struct TruthFrame
{
	std::size_t index = 0;  ///< DepthFrame::index
	double t = 0;           ///< mrpt::Clock::toDouble
	int scene = 0;          ///< frames of one scene belong together; nothing is carried from one scene to the next
	mrpt::poses::CPose3D map_from_robot;
	std::optional<mrpt::poses::CPose3D> robot_from_camera;  ///< no value: that of the log
	std::vector<TruthDoor> doors;                           ///< those in front of the camera, hidden ones included
	TruthCorridor corridor;
	std::vector<TruthObstacle> obstacles;
	std::optional<TruthFreePaths> free_paths;
};

/** Cells that a robot's centre can get to, one level of height above another. Cells are counted from the map's origin:
 *  cell (i, j) reaches from (i, j) · cell_m to (i + 1, j + 1) · cell_m. */
struct TruthReach
{
	struct Level
	{
		double low_m = 0, high_m = 0;         ///< z in the map of what has to be free for the level's cells
		std::vector<std::uint8_t> reachable;  ///< 1 = reachable; (column, row) is at row · columns + column
	};
	double cell_m = 0.05;
	int first_column = 0, first_row = 0;  ///< number of the cell with the smallest x and y
	int columns = 0, rows = 0;
	std::vector<Level> levels;  ///< one for a ground robot

	/** Middle of the cell on the floor plan. */
	[[nodiscard]] Eigen::Vector2d centerOf(int column, int row) const
	{
		return cell_m * Eigen::Vector2d(first_column + column + 0.5, first_row + row + 0.5);
	}
	/** Of all levels. */
	[[nodiscard]] std::size_t cells() const;
	/** Of the floor below the reachable cells [m²]. */
	[[nodiscard]] double floorArea() const;
};

/** Everything in LOG.truth.json. */
struct TruthLog
{
	std::string world;          ///< file name of the world, or "synth"
	std::string family;         ///< scene family; empty for a world
	std::string configuration;  ///< row of the paper's Fig. 3(b) that it belongs to; empty = none
	bool negative = false;      ///< no door in it: scored by its false alarms
	RobotConfig robot;
	std::string noise;  ///< name of the noise model
	std::uint64_t seed = 0;
	std::string command;  ///< that makes the log again
	CameraIntrinsics intrinsics;
	mrpt::poses::CPose3D robot_from_camera;
	std::vector<TruthFrame> frames;
};

/** The camera's mount in that frame of the log. */
[[nodiscard]] inline const mrpt::poses::CPose3D& mountOf(const TruthLog& log, const TruthFrame& frame)
{
	return frame.robot_from_camera ? *frame.robot_from_camera : log.robot_from_camera;
}
}  // namespace explore

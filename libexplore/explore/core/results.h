// The plain results that pass from stage to stage and end up in frames.jsonl. All in the robot frame, metres, radians.
#pragma once

#include <explore/core/geometry.h>
#include <explore/core/point_cloud.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace explore
{
/** The floor as this frame shows it. */
struct Ground
{
	Plane plane;                 ///< normal points up
	double camera_height_m = 0;  ///< distance of the camera's centre above the plane
	std::size_t inliers = 0;     ///< voxels
	bool seen = true;            ///< false where an earlier frame's floor is carried on
};

/** A line in 3D: the foot point nearest to the camera, and a unit direction. */
struct Line
{
	Eigen::Vector3d point = Eigen::Vector3d::Zero();
	Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
};

/** A vertical plane; its normal points toward the robot. */
struct Wall
{
	Plane plane;
	std::size_t inliers = 0;  ///< voxels
	Line floor_line;          ///< where it meets the ground (paper eq. 4)
};

/** What an opening is; meanings in doc/output-format.md. */
enum class Verdict
{
	open,
	ajar,
	closed,
	blocked,
	passage,
	drop,
	partial,
	unknown
};
[[nodiscard]] std::string_view nameOf(Verdict verdict);

/** What the rays through an opening met: why a door got its verdict (method = full). Shares are 0–1. */
struct OpeningEvidence
{
	double through = 0;  ///< of the unoccluded rays: end on the floor beyond, or further behind than the robot is long
	double stopped = 0;  ///< end sooner: a leaf, a back wall, something that stands there
	double no_return = 0;  ///< come back with nothing
	double occluded = 0;   ///< of all rays: end well in front of the wall
	double speckle = 0;    ///< share of holes, pixels without return, amid near surfaces seen through it (glass)
	double left_wall = 0, right_wall = 0;          ///< how surely wall (or a wall across) stands beside each jamb
	double sill = 0;                               ///< share of the wall's surface in the opening below knee height
	std::optional<double> lintel_m;                ///< its height, where it was seen
	double lowest_seen_m = 0, highest_seen_m = 0;  ///< heights at which the opening was in view
	std::optional<double> floor_beyond;            ///< share of the rays that should meet the floor there and do
	double range_m = 0;                            ///< from the camera to the opening's middle
};

struct Door
{
	Eigen::Vector3d center = Eigen::Vector3d::Zero();   ///< middle of the opening
	Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< of its wall, toward the robot
	double width_m = 0;
	std::optional<double> height_m;  ///< no value: the top was not in view, or the method does not measure it
	Verdict verdict = Verdict::open;
	double clear_width_m = 0;
	std::optional<double> confidence;  ///< P(the robot can pass now); no value where the method gives none
	std::optional<int> track;
	std::optional<OpeningEvidence> evidence;  ///< no value with method = paper
};

/** Where parallel wall–floor lines lead. */
struct VanishingPoint
{
	Eigen::Vector3d point = Eigen::Vector3d::Zero();
	Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit, horizontal in the ground plane
	std::vector<std::size_t> walls;                        ///< indices of the walls whose lines agree
	std::size_t inliers = 0;                               ///< of those walls together
	std::optional<int> track;
};

/** What the camera saw per vertical image strip: how near, and how much it could not measure. */
struct NearField
{
	static constexpr std::size_t kSectors = 16;
	struct Sector
	{
		float nearest_m = 0;        ///< smallest depth with enough pixels behind it; 0 = nothing measured
		float no_return_share = 1;  ///< pixels without a return, 0–1
	};
	std::array<Sector, kSectors> sectors;
	std::size_t valid_pixels = 0;  ///< pixels (or points) with a finite, positive measurement, whatever their range
	bool organised = false;        ///< false for unorganised clouds: the sectors say nothing
};

/** Everything that perception finds in one frame (the first half of Algorithm 1). */
struct Percepts
{
	std::optional<Ground> ground;
	std::vector<Wall> walls;
	std::vector<Door> doors;
	std::vector<VanishingPoint> vanishing_points;
	PointCloud obstacles_in_robot;  ///< O = P_f \ P_ground, voxel centroids
	NearField near_field;
};

enum class GoalKind
{
	door,
	corridor,
	frontier,
	look,
	recover,
	home,
	none
};
[[nodiscard]] std::string_view nameOf(GoalKind kind);

struct Goal
{
	GoalKind kind = GoalKind::none;
	std::optional<int> track;
	std::optional<Eigen::Vector3d> point_in_robot;
};

/** Why the robot must not move now. */
enum class StopReason
{
	none,
	empty_frame,         ///< too few valid measurements
	stale_frame,         ///< not newer than the one before
	near_obstacle_lost,  ///< an obstacle slipped under the sensor's minimum range
	path_too_short,      ///< open path below the stopping distance
	no_direction,        ///< the avoider found no way
	finished,            ///< the exploration is over
	bumper,              ///< the robot touches something
	cliff,               ///< the robot stands at an edge
	link_lost,           ///< the robot's own poses or scans do not come any more
};
[[nodiscard]] std::string_view nameOf(StopReason reason);

/** θ_o, θ_v, θ_a, θ_d and the result; yaw in (−π, π], robot frame, positive left. */
struct Headings
{
	std::optional<double> door_rad;             ///< θ_o
	std::optional<double> vanishing_point_rad;  ///< θ_v
	std::optional<double> avoid_rad;            ///< θ_a; no value when nothing forces a deviation
	std::optional<double> desired_rad;          ///< θ_d
	std::optional<double> chosen_rad;           ///< no value = stop
	double chosen_elevation_rad = 0;            ///< positive up; 0 for a ground robot
};

/** Velocity in the robot frame. */
struct Command
{
	Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
	double yaw_rate_radps = 0;
};

/** What one step decided. */
struct Decision
{
	Goal goal;
	Headings headings;
	double open_path_m = 0;  ///< free length along the chosen heading (along the desired one when stopped)
	bool stop = false;
	StopReason stop_reason = StopReason::none;
	Command command;
};
}  // namespace explore

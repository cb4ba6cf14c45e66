// Reactive avoidance (paper §3.2): from obstacle points and a desired direction to the best safe direction.
#pragma once

#include <explore/config/fields.h>
#include <explore/core/results.h>
#include <explore/core/robot.h>
#include <explore/perception/sight_lines.h>

#include <cstddef>

namespace explore
{
enum class AvoiderMethod
{
	open_path,      ///< paper §3.2 with remedies 10 and 11: swept corridor, nothing cropped, unseen space counts
	paper,          ///< paper §3.2, obstacles cropped to ± sector of θ_d, with the swept corridor; unseen is free
	holonomic_nd,   ///< mrpt::nav::CHolonomicND
	holonomic_vff,  ///< mrpt::nav::CHolonomicVFF
	holonomic_full_eval  ///< mrpt::nav::CHolonomicFullEval
};

/** What open_path adds to the paper, by name, so that each can be left out to see what it buys. */
enum class AvoiderRemedy
{
	none,
	swept_corridor,  ///< 10: without it every point within ± sector of θ_d caps every direction, as printed
	unseen_blocks    ///< 11: without it unseen space is free, and directions out of view are candidates
};

struct AvoiderConfig
{
	AvoiderMethod method = AvoiderMethod::open_path;
	AvoiderRemedy leave_out = AvoiderRemedy::none;
	double sector_rad = 0.7853981633974483;  ///< candidates within ± this of θ_d (paper: 45°), where not in view
	double resolution_rad = 0.008726646259971648;     ///< between candidate directions (0.5°)
	double max_range_m = 5.0;                         ///< open paths are capped here
	double clearance_m = 0.05;                        ///< added to the robot's radius and height
	double clearance_range_m = 1.0;                   ///< the clearance fades to a fifth at this distance
	double step_height_m = 0.05;                      ///< a ground robot rolls over what is lower
	double max_elevation_rad = 0.5235987755982988;    ///< MAV only (30°)
	double elevation_step_rad = 0.17453292519943295;  ///< MAV only (10°)
};
/** [avoider] */
void describe(FieldVisitor& fields, AvoiderConfig& config);

/** What the avoider looks at, robot frame. Azimuths are about the floor's normal (see level_frame.h). */
struct AvoiderInput
{
	const PointCloud* obstacles_in_robot = nullptr;  ///< must be set
	std::optional<Plane> ground;                     ///< where the floor was seen
	double desired_rad = 0;                          ///< θ_d
	double desired_elevation_rad = 0;                ///< MAV only
	double goal_distance_m = 0;                      ///< what lies further off does not matter; 0 = no end
	/** Where the camera looked; must outlive the call. Without it nothing is known of what was not seen, and it counts
	 * as free. */
	const SightLines* sight = nullptr;
	/** Unit, against gravity: what is level where no floor was seen. */
	Eigen::Vector3d up_in_robot = Eigen::Vector3d::UnitZ();
	/** The sensor's centre: where a drop in the floor begins is seen along its rays. Without it a drop counts only
	 *  where its points are. */
	std::optional<Eigen::Vector3d> sensor_in_robot;
};

/** θ* and how far it is free. */
struct Avoidance
{
	std::optional<double> heading_rad;  ///< no value: every direction is blocked
	double elevation_rad = 0;
	/** d(θ*) from the robot's hull, as far as it was observed, at most max_range_m; d(θ_d) when every direction is
	 *  blocked. */
	double open_path_m = 0;
	/** The least d among the directions from straight ahead to θ*: what the hull may meet while it turns. 0 where it
	 *  turns to what it has not seen yet: it drives when it looks there. */
	double turning_path_m = 0;
	bool deviates = false;  ///< θ* differs from θ_d
};

/** The avoider that `config.method` names. Deterministic; keeps nothing between calls. */
Avoidance avoid(const AvoiderInput& input, const RobotConfig& robot, const AvoiderConfig& config);
}  // namespace explore

// What a source delivers: one depth image (or cloud) with the time and the poses that belong to it.
#pragma once

#include <explore/core/point_cloud.h>
#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose3D.h>

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace explore
{
/** Pinhole camera without distortion; pixel (u, v) is column u, row v, centres at whole numbers. */
struct CameraIntrinsics
{
	int width_px = 0, height_px = 0;
	double fx_px = 0, fy_px = 0, cx_px = 0, cy_px = 0;
	bool operator==(const CameraIntrinsics&) const = default;
};

/** Depth along the optical axis [m], row-major, width × height; 0 = no return. Never NaN, infinite or negative: sources
 *  see to it. */
struct DepthImage
{
	CameraIntrinsics intrinsics;
	std::vector<float> depth_m;

	[[nodiscard]] bool empty() const { return depth_m.empty(); }
	[[nodiscard]] float at(int u, int v) const
	{
		return depth_m[static_cast<std::size_t>(v) * static_cast<std::size_t>(intrinsics.width_px) +
		               static_cast<std::size_t>(u)];
	}
};

/** Where map_from_robot of a frame comes from. */
enum class PoseOrigin
{
	none,        ///< there is no pose: map_from_robot is the identity, or the last one that was known
	robot_pose,  ///< CObservationRobotPose
	odometry,    ///< CObservationOdometry
	action,      ///< CActionRobotMovement2D / 3D
	robot_link,  ///< the robot, over [robot_link] listen
};
/** Whether such poses tell height, pitch and roll where these are not 0. */
[[nodiscard]] constexpr bool isPoseInSpace(PoseOrigin origin)
{
	return origin == PoseOrigin::robot_pose || origin == PoseOrigin::robot_link;
}
[[nodiscard]] std::string nameOf(PoseOrigin origin);

/** Why the robot must not move, whatever the camera shows. */
enum class RobotHalt
{
	none,
	bumper,     ///< it touches something
	cliff,      ///< it stands at an edge
	link_lost,  ///< its poses or scans have come, and do not come any more
};

/** One measurement. Camera axes are MRPT's (x forward, y left, z up); see doc/frames.md. */
struct DepthFrame
{
	std::size_t index = 0;  ///< 0, 1, … among the frames that the source delivered
	mrpt::Clock::time_point timestamp;
	std::string sensor_label;

	DepthImage image;             ///< organised sensors; empty otherwise
	PointCloud points_in_camera;  ///< unorganised sensors (and points-only scans); empty otherwise

	mrpt::poses::CPose3D robot_from_camera;
	mrpt::poses::CPose3D map_from_robot;
	PoseOrigin pose_origin = PoseOrigin::none;
	/** Unit vector against gravity in the robot frame, where an IMU was recorded. */
	std::optional<Eigen::Vector3d> up_in_robot;

	/** What other sensors of the robot say stands around it; seen at the frame's time. */
	PointCloud more_obstacles_in_robot;
	RobotHalt halt = RobotHalt::none;
};

/** Direction in the camera frame of the ray through pixel (u, v), scaled so that its x (depth) is 1. The only place
 * that knows the image axes: u grows to the right (−y), v grows downward (−z). */
Eigen::Vector3d rayOfPixel(const CameraIntrinsics& intrinsics, double u_px, double v_px);

/** The pixel (u, v) that sees `point_in_camera`; no value behind the camera. */
std::optional<Eigen::Vector2d> pixelOfPoint(const CameraIntrinsics& intrinsics, const Eigen::Vector3d& point_in_camera);
}  // namespace explore

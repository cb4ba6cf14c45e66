// [source], [openni2], [simulator] and [camera]: where frames come from and what is corrected before anything looks at
// them.
#pragma once

#include <explore/config/fields.h>
#include <explore/config/sensor_poses.h>

#include <string>

namespace explore
{
enum class SourceKind
{
	rawlog,
	simulator,  ///< a robot in a simulated world, driven by what the explorer decides
	openni2     ///< a camera, or an .oni recording of one
};

/** Which recorded poses become map_from_robot. */
enum class PosePolicy
{
	automatic,  ///< the best kind found: robot_pose, then odometry, then action
	robot_pose,
	odometry,
	action,
	none
};

/** Where robot_from_camera comes from. */
enum class MountPolicy
{
	log,      ///< the observation's sensorPose (or --sensors-pose); in a simulated world the usual mount
	ini,      ///< pose_x … pose_roll below
	estimate  ///< height, pitch and roll from the floor in the first frames
};

struct CameraConfig
{
	MountPolicy mount = MountPolicy::log;
	double x_m = 0, y_m = 0, z_m = 0.5, yaw_rad = 0, pitch_rad = 0, roll_rad = 0;
	double depth_scale = 1.0;  ///< true depth / measured depth
	double depth_offset_m = 0.0;
	double depth_quadratic_per_m = 0.0;  ///< z' = offset + scale·z + quadratic·z²
	std::string self_mask;               ///< image file; non-black pixels see the robot itself
};

/** What the simulated robot is told about where it is. */
enum class SimulatedPose
{
	exact,
	odometry  ///< with the errors of [simulated_robot]; a MAV's is its state estimate
};

struct SimulatorConfig
{
	std::string world;  ///< path
	std::string
	    start;  ///< name of a spawn, or "x y yaw" or "x y z yaw" (m, degrees); empty = the first spawn that suits
	SimulatedPose pose = SimulatedPose::exact;
	double command_delay_s = 0.05;  ///< from a frame to the command that answers it
	double time_limit_s = 3600;     ///< of simulated time
	int seed = 1;
};

/** How a camera is opened; a recording has its own size and rate. */
struct Openni2Config
{
	std::string device;  ///< index in the list of devices, serial number or URI; empty = the first
	int width_px = 640, height_px = 480, rate_hz = 30;
	bool color = false;                                 ///< colour images beside the depth
	bool registration = false;                          ///< depth as the colour camera would see it
	double fx_px = 0, fy_px = 0, cx_px = 0, cy_px = 0;  ///< 0 = from the field of view that the camera tells
	double lost_after_s = 10;
};

struct SourceConfig
{
	SourceKind kind = SourceKind::rawlog;
	std::string rawlog;         ///< path
	std::string oni;            ///< path of an OpenNI2 recording; empty = a camera
	std::string images_folder;  ///< of externally stored images; empty = found beside the rawlog
	std::string sensor_label;   ///< empty = the first depth sensor in the log
	PosePolicy pose = PosePolicy::automatic;
	bool gravity_from_imu = true;
	Openni2Config openni2;
	SimulatorConfig simulator;
	CameraConfig camera;
	SensorPoses sensor_poses;  ///< from --sensors-pose, not from the ini
};

/** [source] [openni2] [simulator] [camera] */
void describe(FieldVisitor& fields, SourceConfig& config);
}  // namespace explore

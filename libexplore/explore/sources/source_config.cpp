#include "source_config.h"

#include <array>
#include <string_view>

namespace explore
{
namespace
{
constexpr std::array<std::string_view, 1> kKinds = {"rawlog"};
constexpr std::array<std::string_view, 5> kPoses = {"automatic", "robot_pose", "odometry", "action", "none"};
constexpr std::array<std::string_view, 3> kMounts = {"log", "ini", "estimate"};

void describeCamera(FieldVisitor& fields, CameraConfig& camera)
{
	constexpr Bounds kPlace_m{-100, 100}, kTurn_deg{-180, 180};
	fields.section("camera", "Where the depth camera sits on the robot, and what is corrected in its images.");
	fields.choice("mount", camera.mount, kMounts,
	              "Where the camera's pose on the robot comes from: the log (or --sensors-pose), pose_x ... pose_roll "
	              "below, or the log's with height, pitch and roll estimated from the floor.");
	fields.real("pose_x", camera.x_m, kPlace_m, "m", "Forward, from the robot's origin; with mount = ini.");
	fields.real("pose_y", camera.y_m, kPlace_m, "m", "To the left.");
	fields.real("pose_z", camera.z_m, kPlace_m, "m", "Up.");
	fields.degrees("pose_yaw", camera.yaw_rad, kTurn_deg, "Positive looks left.");
	fields.degrees("pose_pitch", camera.pitch_rad, kTurn_deg, "Positive looks down.");
	fields.degrees("pose_roll", camera.roll_rad, kTurn_deg, "Positive leans right.");
	fields.real("depth_scale", camera.depth_scale, {0.1, 10}, "",
	            "Corrected depth = depth_offset + depth_scale * z + depth_quadratic * z^2.");
	fields.real("depth_offset", camera.depth_offset_m, {-1, 1}, "m", "See depth_scale.");
	fields.real("depth_quadratic", camera.depth_quadratic_per_m, {-0.5, 0.5}, "1/m", "See depth_scale.");
	fields.text("self_mask", camera.self_mask,
	            "Image of the depth image's size whose non-black pixels see the robot itself; empty = none.");
}
}  // namespace

void describe(FieldVisitor& fields, SourceConfig& config)
{
	fields.section("source", "Where the frames come from.");
	fields.choice("kind", config.kind, kKinds, "What is read.");
	fields.text("rawlog", config.rawlog, "Path of the rawlog, plain or gzipped.");
	fields.text("images_folder", config.images_folder,
	            "Folder of externally stored images; empty = found beside the rawlog.");
	fields.text("sensorLabel", config.sensor_label, "The depth sensor to use; empty = the first one in the log.");
	fields.choice("pose", config.pose, kPoses,
	              "Which recorded poses place the robot: automatic takes the best kind that is found around the first "
	              "frame, in the order robot_pose, odometry, action.");
	fields.flag("gravity_from_imu", config.gravity_from_imu, "Use a recorded accelerometer to tell which way is up.");
	describeCamera(fields, config.camera);
}
}  // namespace explore

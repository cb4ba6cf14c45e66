#include "source_config.h"

#include <array>
#include <string_view>

namespace explore
{
namespace
{
constexpr std::array<std::string_view, 3> kKinds = {"rawlog", "simulator", "openni2"};
constexpr std::array<std::string_view, 5> kPoses = {"automatic", "robot_pose", "odometry", "action", "none"};
constexpr std::array<std::string_view, 2> kSimulatedPoses = {"exact", "odometry"};
constexpr std::array<std::string_view, 3> kMounts = {"log", "ini", "estimate"};

void describeOpenni2(FieldVisitor& fields, Openni2Config& openni2)
{
	constexpr Bounds kFocal_px{0, 1e6};
	fields.section("openni2", "The camera, where [source] kind = openni2: see doc/live.md.");
	fields.text(
	    "device", openni2.device,
	    "Its number in the list that explore-rawlog record --openni2 list prints, its serial number, or its URI; "
	    "empty = the first one.");
	fields.integer("width_px", openni2.width_px, {16, 4096}, "px",
	               "Of the depth images; a recording has its own size.");
	fields.integer("height_px", openni2.height_px, {16, 4096}, "px", "See width_px.");
	fields.integer("rate_hz", openni2.rate_hz, {1, 1000}, "Hz", "Depth images a second; a recording has its own.");
	fields.flag("color", openni2.color,
	            "explore-rawlog record keeps colour images beside the depth, of its size and rate where the camera has "
	            "such; explore-mrpt goes by depth alone, and leaves the colour camera off.");
	fields.flag("registration", openni2.registration,
	            "Depth as seen from the colour camera, where the camera can do that; fx to cy are then that one's.");
	fields.real("fx", openni2.fx_px, kFocal_px, "px",
	            "Calibrated focal length; 0 = from the field of view that the camera tells.");
	fields.real("fy", openni2.fy_px, kFocal_px, "px", "See fx.");
	fields.real("cx", openni2.cx_px, {0, 4096}, "px", "Calibrated principal point; 0 = the middle of the image.");
	fields.real("cy", openni2.cy_px, {0, 4096}, "px", "See cx.");
	fields.real("lost_after_s", openni2.lost_after_s, {1, 3600}, "s",
	            "A camera that delivered frames and was away that long is lost: the run ends with exit code 4.");
}

void describeSimulator(FieldVisitor& fields, SimulatorConfig& simulator)
{
	fields.section("simulator", "The simulated world, where [source] kind = simulator.");
	fields.text("world", simulator.world, "Path of the world, a Gazebo SDF file.");
	fields.text("start", simulator.start,
	            "Where the robot begins: a spawn of the world by its name, or x y yaw, or x y z yaw, in metres and "
	            "degrees; empty = the world's first spawn that suits the robot.");
	fields.choice("pose", simulator.pose, kSimulatedPoses,
	              "What the robot is told about its place: exact, the true one, since nothing corrects drift yet; or "
	              "odometry, with the errors of [simulated_robot], a MAV's state estimate.");
	fields.real("command_delay", simulator.command_delay_s, {0, 1}, "s",
	            "From a frame to the command that answers it; less than the time between two frames.");
	fields.real("time_limit", simulator.time_limit_s, {0.1, 1e6}, "s", "The run ends after that much simulated time.");
	fields.integer("seed", simulator.seed, {0, 1e9}, "", "Of the noise of camera, odometry and IMU.");
}

void describeCamera(FieldVisitor& fields, CameraConfig& camera)
{
	constexpr Bounds kPlace_m{-100, 100}, kTurn_deg{-180, 180};
	fields.section("camera", "Where the depth camera sits on the robot, and what is corrected in its images.");
	fields.choice("mount", camera.mount, kMounts,
	              "Where the camera's pose on the robot comes from: the log (or --sensors-pose), pose_x ... pose_roll "
	              "below, or the log's with height, pitch and roll estimated from the floor. A simulated camera has "
	              "its usual mount but with ini.");
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
	fields.text("oni", config.oni, "Path of a recording that OpenNI2 made, with kind = openni2; empty = a camera.");
	fields.text("images_folder", config.images_folder,
	            "Folder of externally stored images; empty = found beside the rawlog.");
	fields.text("sensorLabel", config.sensor_label,
	            "The depth sensor to use; empty = the first one in the log. OpenNI2's frames get this label, "
	            "OPENNI2 where it is empty.");
	fields.choice("pose", config.pose, kPoses,
	              "Which recorded poses place the robot: automatic takes the best kind that is found around the first "
	              "frame, in the order robot_pose, odometry, action.");
	fields.flag("gravity_from_imu", config.gravity_from_imu, "Use a recorded accelerometer to tell which way is up.");
	describeOpenni2(fields, config.openni2);
	describeSimulator(fields, config.simulator);
	describeCamera(fields, config.camera);
}
}  // namespace explore

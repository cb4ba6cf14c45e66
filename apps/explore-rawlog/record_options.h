// What explore-rawlog record is asked for, and what becomes of it.
#pragma once

#include <explore-rawlog/record_camera.h>
#include <explore/simulation/recorder.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace explore::app
{
struct RecordOptions
{
	CameraRecordOptions camera;  ///< instead of a world
	std::string world, labels, path, poses, drive, out, ini, sensor, noise;
	std::optional<RobotKind> robot;
	std::vector<double> mount;  ///< x y z [m] yaw pitch roll [deg]; empty = the usual one
	std::vector<std::string> set;
	std::string configuration;
	int width_px = 0;  ///< 0 = the sensor's own; likewise below
	double rate_hz = 0, seconds = 0;
	double noise_scale = 1.0, holes = 0.0;
	std::uint64_t seed = 1;
	int threads = 1;
	bool no_color = false;
};

/** What of the options a camera or an .oni recording takes. */
CameraRecordOptions cameraOptionsOf(const RecordOptions& options);

void addRecordOptions(CLI::App& record, RecordOptions& options);

/** The command line that makes the same log again. */
std::string commandOf(const RecordOptions& options);

struct RecordConfig
{
	simulation::RecorderConfig recorder;
	simulation::SimulatedRobotConfig simulated_robot;
};
/** Defaults, then the ini, then the options, then --set; what comes later wins. Keys of [robot] that the ini leaves out
 *  are those of a usual robot of the kind. Throws ConfigError. */
RecordConfig recordConfigOf(const RecordOptions& options);
}  // namespace explore::app

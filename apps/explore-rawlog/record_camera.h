// explore-rawlog record --openni2 | --oni: what a depth camera sees, or an .oni recording holds, becomes a rawlog.
#pragma once

#include <mrpt/poses/CPose3D.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace explore::app
{
struct CameraRecordOptions
{
	std::optional<std::string> device;  ///< of --openni2: "" = as the ini says, "list" = list them
	std::string oni, out, ini;
	std::vector<std::string> set;  ///< "section.key=value"
	std::vector<double> mount;     ///< x y z [m] yaw pitch roll [deg]; empty = the ini's, or the robot's origin
	double seconds = 0;            ///< 0 = until interrupted, or to the recording's end

	/** Whether either was asked for. */
	[[nodiscard]] bool given() const { return device || !oni.empty(); }
};

/** robot_from_camera of --pose x,y,z,yaw,pitch,roll: six numbers. Throws ConfigError for one above 1000. */
mrpt::poses::CPose3D poseOfOption(const std::vector<double>& numbers);

/** --openni2 and --oni. */
void addCameraOptions(CLI::App& record, CameraRecordOptions& options);

/** Returns the exit code. Throws ConfigError, also where the program was built without OpenNI2, InputError, SensorLost
 *  and OutputError. */
int recordCamera(const CameraRecordOptions& options);

/** A `record` that knows cameras and recordings alone, where the simulator is not built. */
void addCameraRecordCommand(CLI::App& app, std::function<int()>& command);
}  // namespace explore::app

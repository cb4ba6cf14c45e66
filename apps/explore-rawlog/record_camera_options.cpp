#include <explore-rawlog/record_camera.h>
#include <explore/core/errors.h>
#include <explore/core/geometry.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

namespace explore::app
{
mrpt::poses::CPose3D poseOfOption(const std::vector<double>& numbers)
{
	const auto& p = numbers;
	if (!std::all_of(p.begin(), p.end(), [](double value) { return std::abs(value) <= 1000.0; }))
		throw ConfigError("--pose x,y,z,yaw,pitch,roll: metres and degrees of at most 1000 are needed");
	return {p[0], p[1], p[2], p[3] * kDegree_rad, p[4] * kDegree_rad, p[5] * kDegree_rad};
}

void addCameraOptions(CLI::App& record, CameraRecordOptions& options)
{
	record
	    .add_option_function<std::string>(
	        "--openni2", [&options](const std::string& device) { options.device = device; },
	        "Records a depth camera: its number, serial number or URI, else the ini's; list shows what is plugged in")
	    ->type_name("[DEVICE]")
	    ->expected(0, 1)
	    ->trigger_on_parse();
	record.add_option("--oni", options.oni, "Makes a rawlog of a recording of OpenNI2")->type_name("F.oni");
}

void addCameraRecordCommand(CLI::App& app, std::function<int()>& command)
{
	auto options = std::make_shared<CameraRecordOptions>();
	CLI::App* record = app.add_subcommand("record", "Makes a rawlog of what a depth camera sees.");
	auto* input = record->add_option_group("input", "What to record");
	addCameraOptions(*input, *options);
	input->require_option(1);
	record->add_option("--seconds", options->seconds, "Stops after that time; else when it is interrupted")
	    ->type_name("S")
	    ->check(CLI::PositiveNumber.description(""));
	record->add_option("--pose", options->mount, "The camera on the robot: metres, degrees; else the ini's")
	    ->type_name("X,Y,Z,YAW,PITCH,ROLL")
	    ->delimiter(',')
	    ->expected(6);
	record->add_option("--ini", options->ini, "[openni2] and [camera] from a path, or a name in the ini/ folder")
	    ->type_name("NAME");
	record->add_option("--set", options->set, "Overrides one key of the ini; may be repeated")
	    ->type_name("SECTION.KEY=VALUE")
	    ->allow_extra_args(false);
	record->add_option("--out", options->out, "The rawlog to write (gzipped)")->type_name("LOG.rawlog");
	record->callback([options, &command] { command = [options] { return recordCamera(*options); }; });
}
}  // namespace explore::app

#include <common/exit_codes.h>
#include <explore-rawlog/import_command.h>
#include <explore/core/errors.h>
#include <explore/core/geometry.h>
#include <explore/sources/import_recording.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

namespace explore::app
{
namespace
{
/** Start of recordings that carry no times, seconds since 1970: fixed, so that the same input gives the same bytes. */
constexpr double kUntimedStart_s = 1'400'000'000.0;
constexpr double kTumDepthScale_m = 1.0 / 5000.0, kPngDepthScale_m = 0.001;

struct ImportOptions
{
	std::string tum, png, poses, out, sensor_label = "DEPTH";
	std::vector<double> intrinsics;  ///< fx fy cx cy [px]
	std::vector<double> pose;        ///< x y z [m] yaw pitch roll [deg]
	double depth_scale_m = 0;        ///< 0 = the layout's own
	double rate_hz = 30;
};

void addOptions(CLI::App& import, ImportOptions& options)
{
	auto* input = import.add_option_group("input", "What to import");
	input->add_option("--tum", options.tum, "Folder with depth.txt, depth images, perhaps groundtruth.txt (TUM RGB-D)")
	    ->type_name("DIR");
	input
	    ->add_option("--png", options.png,
	                 "Folder of 16-bit greyscale PNG files, taken in natural order of their names")
	    ->type_name("DIR");
	input->require_option(1);
	import
	    .add_option("--intrinsics", options.intrinsics,
	                "Of the depth camera, in pixels; needed with --png, else 525,525,319.5,239.5")
	    ->type_name("FX,FY,CX,CY")
	    ->delimiter(',')
	    ->expected(4);
	import.add_option("--depth-scale", options.depth_scale_m, "Metres a count; else 0.001, with --tum 0.0002")
	    ->type_name("M")
	    ->check(CLI::Range(1e-6, 1.0));
	import
	    .add_option("--poses", options.poses,
	                "Robot poses, 't x y z qx qy qz qw' a line; else, with --tum, groundtruth.txt (of the camera)")
	    ->type_name("P.tum");
	import.add_option("--pose", options.pose, "The camera on the robot: metres, degrees; else the robot's origin")
	    ->type_name("X,Y,Z,YAW,PITCH,ROLL")
	    ->delimiter(',')
	    ->expected(6);
	import.add_option("--sensor-label", options.sensor_label, "Label of the depth sensor")->capture_default_str();
	import.add_option("--rate", options.rate_hz, "Frames a second of --png")
	    ->type_name("HZ")
	    ->check(CLI::Range(1e-3, 1e4))
	    ->capture_default_str();
	import.add_option("--out", options.out, "The rawlog to write (gzipped)")->required()->type_name("LOG.rawlog");
}

ImportConfig configOf(const ImportOptions& options)
{
	ImportConfig config;
	config.sensor_label = options.sensor_label;
	config.depth_scale_m = options.depth_scale_m;
	if (options.depth_scale_m == 0) config.depth_scale_m = options.tum.empty() ? kPngDepthScale_m : kTumDepthScale_m;
	if (options.intrinsics.empty() && options.tum.empty())
		throw ConfigError("--png needs --intrinsics fx,fy,cx,cy in pixels");
	if (const auto& k = options.intrinsics; !k.empty())
	{
		const auto usable = [](double value) { return std::isfinite(value) && value >= 1.0 && value <= 1e6; };
		if (!std::all_of(k.begin(), k.end(), usable))
			throw ConfigError("--intrinsics fx,fy,cx,cy: each from 1 to 1000000 px is needed");
		config.fx_px = k[0], config.fy_px = k[1], config.cx_px = k[2], config.cy_px = k[3];
	}
	if (const auto& p = options.pose; !p.empty())
	{
		if (!std::all_of(p.begin(), p.end(), [](double value) { return std::abs(value) <= 1000.0; }))
			throw ConfigError("--pose x,y,z,yaw,pitch,roll: metres and degrees of at most 1000 are needed");
		config.robot_from_camera = {p[0], p[1], p[2], p[3] * kDegree_rad, p[4] * kDegree_rad, p[5] * kDegree_rad};
	}
	return config;
}

Recording recordingOf(const ImportOptions& options, const ImportConfig& config)
{
	Recording recording;
	if (!options.poses.empty()) recording.map_from_robot = readTumPoses(options.poses);
	if (!options.png.empty())
	{
		// Images without times start with the poses that belong to them.
		const auto earlier = [](const TimedPose& a, const TimedPose& b) { return a.time < b.time; };
		const auto first = std::min_element(recording.map_from_robot.begin(), recording.map_from_robot.end(), earlier);
		const LogTime start =
		    first != recording.map_from_robot.end() ? first->time : mrpt::Clock::fromDouble(kUntimedStart_s);
		recording.frames = listPngFolder(options.png, start, options.rate_hz);
		return recording;
	}
	recording.frames = listTumFolder(options.tum);
	const std::filesystem::path truth = std::filesystem::path(options.tum) / "groundtruth.txt";
	if (options.poses.empty() && std::filesystem::exists(truth))
		recording.map_from_robot = robotPosesOfOptical(readTumPoses(truth), config.robot_from_camera);
	return recording;
}

int importFolder(const ImportOptions& options)
{
	const ImportConfig config = configOf(options);
	const Recording recording = recordingOf(options, config);
	RawlogWriter writer(options.out);
	importRecording(recording, config, writer);
	writer.close();
	std::cout << options.out << ": " << recording.frames.size() << " frames, " << recording.map_from_robot.size()
	          << " poses\n";
	return kDone;
}
}  // namespace

void addImportCommand(CLI::App& app, std::function<int()>& command)
{
	auto options = std::make_shared<ImportOptions>();
	CLI::App* import = app.add_subcommand("import", "Makes a rawlog of a folder of depth images.");
	addOptions(*import, *options);
	import->callback([options, &command] { command = [options] { return importFolder(*options);
};
}  // namespace explore::app
);
}
}  // namespace explore::app

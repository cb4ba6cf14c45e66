// Draws robot poses in the free space of a labelled world, most of them with a door before them: independent views for
// explore-rawlog record --poses.
#include "support/pose_sampler.h"

#include <explore/simulation/load_world.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

namespace explore::test
{
namespace
{
using namespace simulation;
using Eigen::Vector3d;

constexpr double kScene_s = 20;  ///< between poses

void writeTum(const std::vector<SampledPose>& poses, const std::filesystem::path& path)
{
	std::ofstream file(path, std::ios::binary);
	file << "# t x y z qx qy qz qw\n" << std::setprecision(9);
	double t_s = 1'600'000'000;
	for (const SampledPose& pose : poses)
	{
		const Eigen::Quaterniond turn = Eigen::AngleAxisd(pose.yaw_rad, Vector3d::UnitZ()) *
		                                Eigen::AngleAxisd(pose.pitch_rad, Vector3d::UnitY()) *
		                                Eigen::AngleAxisd(pose.roll_rad, Vector3d::UnitX());
		file << std::setprecision(12) << t_s << std::setprecision(9) << ' ' << pose.position.x() << ' '
		     << pose.position.y() << ' ' << pose.position.z() << ' ' << turn.x() << ' ' << turn.y() << ' ' << turn.z()
		     << ' ' << turn.w() << '\n';
		t_s += kScene_s;
	}
	if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

int run(std::map<std::string, std::string> options)
{
	WorldPaths paths = usualWorldPaths();
	paths.labels_file = options["--labels"];
	const World world = loadWorld(options.at("--world"), paths);
	const RayScene scene(world);
	SampleOptions wanted;
	wanted.mav = options["--robot"] == "mav";
	if (!options["--count"].empty()) wanted.count = std::stoi(options["--count"]);
	if (!options["--camera"].empty()) wanted.camera_m = std::stod(options["--camera"]);
	if (!options["--doors"].empty()) wanted.door_share = std::stod(options["--doors"]);
	if (std::istringstream area(options["--within"]); !options["--within"].empty())
		area >> wanted.within.min().x() >> wanted.within.min().y() >> wanted.within.max().x() >>
		    wanted.within.max().y();
	const std::string seed = options["--seed"].empty() ? "1" : options["--seed"];
	const std::vector<SampledPose> poses = samplePoses(scene, wanted, std::stoull(seed));
	writeTum(poses, options.at("--out"));
	std::cout << options.at("--out") << ": " << poses.size() << " poses\n";
	return poses.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
}  // namespace
}  // namespace explore::test

int main(int argc, char** argv)
try
{
	std::map<std::string, std::string> options;
	for (int i = 1; i + 1 < argc; i += 2) options[argv[i]] = argv[i + 1];
	if (argc % 2 == 0 || !options.contains("--world") || !options.contains("--out"))
	{
		std::cerr << "usage: sample_poses --world F.sdf --out P.tum [--labels F.doors.json] [--robot ground|mav]\n"
		             "       [--camera HEIGHT] [--count N] [--doors SHARE] [--within 'X0 Y0 X1 Y1'] [--seed S]\n";
		return EXIT_FAILURE;
	}
	return explore::test::run(options);
}
catch (const std::exception& error)
{
	std::cerr << "sample_poses: " << error.what() << '\n';
	return EXIT_FAILURE;
}

// A robot in another process, that sees through OpenNI2 and hears through UDP, explores a small world to the end.
#include "apps/program.h"
#include "support/test_sockets.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

using namespace explore;
using namespace explore::test;
using namespace std::chrono_literals;
using nlohmann::json;
namespace fs = std::filesystem;

namespace
{
using Arguments = std::vector<std::string>;

const Arguments kCamera{"simulated_camera.width_px=160", "simulated_camera.height_px=120"};

Program robotServer(const fs::path& folder, const std::string& commands, const std::string& poses, const fs::path& out)
{
	Arguments arguments{folder.string(), commands,
	                    poses,           out.string(),
	                    "corridor.ini",  std::string(EXPLORE_SOURCE_DIR) + "/tests/data/three_rooms.sdf"};
	arguments.insert(arguments.end(), kCamera.begin(), kCamera.end());
	Program::Setup setup;
	setup.standard_output = (folder / "truth.json").string();
	return {ROBOT_SERVER_PROGRAM, arguments, setup};
}

Program explorer(const std::string& commands, const std::string& poses, const fs::path& out)
{
	Arguments arguments{"--ini", "corridor.ini", "--out", out.string(), "--quiet"};
	for (const std::string& setting :
	     Arguments{"source.kind=openni2", "openni2.width_px=160", "openni2.height_px=120", "camera.mount=ini",
	               "camera.pose_z=0.5", "robot_link.commands=udp://127.0.0.1:" + commands,
	               "robot_link.listen=udp://127.0.0.1:" + poses, "output.pictures_every=0"})
	{
		arguments.emplace_back("--set");
		arguments.push_back(setting);
	}
	return {EXPLORE_MRPT_PROGRAM, arguments, {}};
}

bool appears(const fs::path& path)
{
	const auto due = std::chrono::steady_clock::now() + 60s;
	while (!fs::exists(path) && std::chrono::steady_clock::now() < due) std::this_thread::sleep_for(20ms);
	return fs::exists(path);
}
}  // namespace

TEST(Wire, ARobotInAnotherProcessExploresToTheEndAndComesHome)
{
	const fs::path folder = freshFolder() / "camera", out = testFolder() / "o";
	fs::create_directories(folder);
	const std::string commands = std::to_string(freePort()), poses = std::to_string(freePort());
	Program robot = robotServer(folder, commands, poses, out);
	ASSERT_TRUE(appears(folder / "control"));
	::setenv("EXPLORE_VIRTUAL_CAMERA", folder.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread
	const ProgramResult explored = explorer(commands, poses, out).wait();
	robot.signal(SIGTERM);
	ASSERT_EQ(robot.wait().exit_code, 0);
	ASSERT_EQ(explored.exit_code, 0) << explored.err;

	const json exploration = json::parse(readFile(out / "summary.json"))["exploration"];
	EXPECT_TRUE(exploration["complete"]) << exploration["reason"];
	const json truth = json::parse(readFile(folder / "truth.json"));
	EXPECT_EQ(truth["collisions"], 0) << truth;
	EXPECT_LT(truth["from_start_m"], 0.10) << truth;
	EXPECT_GT(truth["coverage"], 0.97) << truth;
	EXPECT_GT(truth["commands"], 10.0 * truth["t_s"].get<double>()) << truth;
}

// From a ROS 1 bag to a rawlog, by the commands of doc/ros.md; skipped where the packages for it are not installed.
#include "apps/program.h"
#include "apps/rawlog_program.h"

#include <explore/sources/rawlog_source.h>
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <optional>

using namespace explore;
using namespace explore::test;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
using Arguments = std::vector<std::string>;

/** A Python that has ROS 1's packages: Debian's belong to Debian's own. */
std::optional<std::string> pythonWithRosbag()
{
	for (const std::string python : {"python3", "/usr/bin/python3"})
		if (std::system((python + " -c 'import rosbag, sensor_msgs, nav_msgs, tf2_msgs' > /dev/null 2>&1").c_str()) ==
		    0)
			return python;
	return std::nullopt;
}

ProgramResult run(Arguments arguments)
{
	return Program("/usr/bin/env", std::move(arguments), {}).wait();
}

struct Quiet : mrpt::system::COutputLogger
{
	Quiet() { logging_enable_console_output = false; }
};

/** Frames of a corridor whose end is 6 m ahead, seen from 0.1 m before a robot that drives 0.3 m/s. */
void expectTheCorridor(const SourceConfig& config, bool has_poses)
{
	Quiet quiet;
	RawlogSource source(config, quiet);
	int frames = 0;
	for (; const auto frame = source.next(); ++frames)
	{
		const double x_m = 0.03 * frames;
		EXPECT_NEAR(mrpt::Clock::toDouble(frame->timestamp), 1.5e9 + 0.1 * frames, 1e-6);
		EXPECT_EQ(frame->image.intrinsics, (CameraIntrinsics{80, 60, 73.5, 73.5, 39.5, 29.5}));
		EXPECT_EQ(frame->image.at(0, 0), 0.0F) << "nothing came back there";
		EXPECT_NEAR(frame->image.at(40, 30), 5.9 - x_m, 1e-3);
		// The wall to the left and the floor below.
		EXPECT_NEAR(frame->image.at(2, 30), 73.5 / 37.5, 1e-3);
		EXPECT_NEAR(frame->image.at(40, 58), 0.5 * 73.5 / 28.5, 1e-3);
		EXPECT_NEAR(frame->robot_from_camera.z(), 0.5, 1e-9);
		EXPECT_EQ(frame->pose_origin, has_poses ? PoseOrigin::robot_pose : PoseOrigin::none);
		EXPECT_NEAR(frame->map_from_robot.x(), has_poses ? x_m : 0.0, 1e-6);
	}
	EXPECT_EQ(frames, 20);
}

class RosBag : public testing::TestWithParam<const char*>
{
protected:
	void SetUp() override
	{
		const auto python = pythonWithRosbag();
		if (!python)
			GTEST_SKIP() << "no Python with rosbag: install python3-rosbag python3-sensor-msgs python3-nav-msgs "
			                "python3-tf2-msgs to test the way from a bag";
		m_python = *python;
		const ProgramResult made = run({m_python, EXPLORE_SOURCE_DIR "/tests/support/make_bag.py", m_bag, GetParam()});
		ASSERT_EQ(made.exit_code, 0) << made.err;
	}
	[[nodiscard]] ProgramResult extract(const std::string& folder, const std::string& depth) const
	{
		return run({m_python, EXPLORE_SOURCE_DIR "/doc/examples/bag_to_folder.py", m_bag, depth, folder, "/odom"});
	}

	std::string m_python, m_bag = (freshFolder() / "log.bag").string(), m_log = (testFolder() / "log.rawlog").string();
};
}  // namespace

TEST_P(RosBag, BecomesARawlogOverImages)
{
	const std::string folder = (testFolder() / "images").string();
	const ProgramResult extracted = extract(folder, "/camera/depth/image_raw");
	ASSERT_EQ(extracted.exit_code, 0) << extracted.err;
	EXPECT_THAT(extracted.out, HasSubstr("explore-rawlog import --tum " + folder +
	                                     " --depth-scale 0.001 --intrinsics 73.5,73.5,39.5,29.5 --poses " + folder +
	                                     "/poses.tum --pose X,Y,Z,YAW,PITCH,ROLL --out LOG.rawlog"));
	const ProgramResult imported =
	    exploreRawlog({"import", "--tum", folder, "--depth-scale", "0.001", "--intrinsics", "73.5,73.5,39.5,29.5",
	                   "--poses", folder + "/poses.tum", "--pose", "0.1,0,0.5,0,0,0", "--out", m_log});
	ASSERT_EQ(imported.exit_code, 0) << imported.err;
	SourceConfig config;
	config.rawlog = m_log;
	expectTheCorridor(config, true);
}

TEST_P(RosBag, WithoutTheTopicIsToldSo)
{
	const ProgramResult extracted = extract((testFolder() / "images").string(), "/camera/depth/image");
	EXPECT_EQ(extracted.exit_code, 1);
	EXPECT_THAT(extracted.err, HasSubstr("holds no /camera/depth/image"));
}

TEST_P(RosBag, BecomesARawlogThroughMrptsConverter)
{
	if (std::system("command -v rosbag2rawlog > /dev/null 2>&1") != 0)
		GTEST_SKIP() << "no rosbag2rawlog: install mrpt-apps to test it";
	const std::string config_path = (testFolder() / "config.yml").string();
	writeFile(config_path,
	          "sensors:\n  DEPTH:\n    type: 'CObservation3DRangeScan'\n    depth: '/camera/depth/image_raw'\n"
	          "    cameraInfo: '/camera/depth/camera_info'\n");
	ASSERT_EQ(run({"rosbag2rawlog", "-c", config_path, "-f", "odom", "-o", m_log, m_bag}).exit_code, 0);
	SourceConfig config;
	config.rawlog = m_log;
	config.camera.mount = MountPolicy::ini;
	if (GetParam() == std::string("32FC1")) return expectTheCorridor(config, false);
	// What the document says of the other kind.
	const ProgramResult info = exploreRawlog({"info", m_log});
	EXPECT_EQ(info.exit_code, 3);
	EXPECT_THAT(info.err, HasSubstr("holds no observation"));
}
INSTANTIATE_TEST_SUITE_P(Depth, RosBag, testing::Values("16UC1", "32FC1"));

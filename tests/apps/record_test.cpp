// explore-rawlog record as a user runs it: worlds become rawlogs with their truth.
#include "apps/rawlog_program.h"

#include <explore/evaluation/truth_file.h>

#include <gmock/gmock.h>

using namespace explore;
using namespace explore::test;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
constexpr const char* kHall = R"(<?xml version="1.0"?>
<sdf version="1.7">
  <world name="hall">
    <model name="hall">
      <static>true</static>
      <link name="walls">
        <visual name="left"><pose>3 1.05 1.25 0 0 0</pose><geometry><box><size>8 0.1 2.5</size></box></geometry></visual>
        <visual name="right"><pose>3 -1.05 1.25 0 0 0</pose><geometry><box><size>8 0.1 2.5</size></box></geometry></visual>
        <visual name="floor"><pose>4 0 -0.05 0 0 0</pose><geometry><box><size>14 8 0.1</size></box></geometry></visual>
        <visual name="end_left"><pose>7.05 0.725 1.25 0 0 0</pose><geometry><box><size>0.1 0.55 2.5</size></box></geometry></visual>
        <visual name="end_right"><pose>7.05 -0.725 1.25 0 0 0</pose><geometry><box><size>0.1 0.55 2.5</size></box></geometry></visual>
        <visual name="lintel"><pose>7.05 0 2.25 0 0 0</pose><geometry><box><size>0.1 0.9 0.5</size></box></geometry></visual>
      </link>
    </model>
    <plugin name="explore_labels" filename="explore_labels">
      <door id="end" at="7.05 0 0" yaw="0" width="0.9" height="2.0" depth="0.1"/>
      <corridor id="hall" from="-1 0" to="7 0" width="2"/>
      <route name="down" points="3 0; 4 0.1"/>
      <route name="into the wall" points="3 0; 3 3"/>
    </plugin>
  </world>
</sdf>
)";

struct Hall
{
	Hall() { writeFile(freshFolder() / "hall.sdf", kHall); }

	static ProgramResult record(std::vector<std::string> arguments, const Program::Setup& setup = {})
	{
		arguments.insert(arguments.begin(), {"record", "--size", "80"});
		for (const char* name : {"--world", "--path", "--out"})
		{
			const auto option = std::find(arguments.begin(), arguments.end(), name);
			if (option != arguments.end()) *(option + 1) = (testFolder() / *(option + 1)).string();
		}
		return exploreRawlog(arguments, setup);
	}
	static std::string info(const std::string& log)
	{
		return exploreRawlog({"info", (testFolder() / log).string()}).out;
	}
	static TruthLog truth(const std::string& name) { return evaluation::readTruth(testFolder() / name); }
};

TEST(Record, ADrivenRouteBecomesALogWithItsTruth)
{
	const Hall hall;
	const auto result = hall.record({"--world", "hall.sdf", "--drive", "down", "--out", "log.rawlog"});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	EXPECT_EQ(result.err, "");
	const TruthLog truth = hall.truth("log.truth.json");
	ASSERT_GT(truth.frames.size(), 20U);
	EXPECT_THAT(result.out, HasSubstr(std::to_string(truth.frames.size()) + " frames"));
	EXPECT_THAT(hall.info("log.rawlog"),
	            AllOf(HasSubstr("'XTION': " + std::to_string(truth.frames.size()) + ", 10 Hz"), HasSubstr("80x60"),
	                  HasSubstr("CObservationOdometry"), HasSubstr("accelerometer: yes"), HasSubstr("z 0.5 m"),
	                  HasSubstr("damage:        none")));
	EXPECT_EQ(truth.world, "hall.sdf");
	EXPECT_EQ(truth.noise, "kinect");
	ASSERT_EQ(truth.frames.back().doors.size(), 1U);
	EXPECT_EQ(truth.frames.back().doors[0].visibility, Visibility::visible);
	EXPECT_NEAR(truth.frames.back().map_from_robot.x(), 4.0, 0.11);
}

TEST(Record, TheCommandInTheTruthMakesTheSameBytesAgain)
{
	const Hall hall;
	const std::vector<std::string> choices{"record",  "--world", "hall.sdf",   "--drive",   "down",
	                                       "--size",  "96",      "--noise",    "kinect",    "--seed",
	                                       "5",       "--rate",  "7.5",        "--seconds", "1.5",
	                                       "--robot", "ground",  "--no-color", "--set",     "robot.radius=0.25"};
	auto arguments = choices;
	arguments.insert(arguments.end(), {"--out", "log.rawlog", "--threads", "2"});
	const Program::Setup inside{"", 0, testFolder()};
	ASSERT_EQ(exploreRawlog(arguments, inside).exit_code, 0);
	const std::string log = readFile(testFolder() / "log.rawlog"), truth = readFile(testFolder() / "log.truth.json");
	ASSERT_FALSE(log.empty());

	const std::string command = hall.truth("log.truth.json").command;
	EXPECT_THAT(command, testing::Not(HasSubstr(testFolder().string())));
	std::vector<std::string> words;
	std::istringstream text(command);
	for (std::string word; text >> word;) words.push_back(word);
	ASSERT_EQ(words.front(), "explore-rawlog");
	words.erase(words.begin());
	fs::remove(testFolder() / "log.rawlog");
	ASSERT_EQ(exploreRawlog(words, inside).exit_code, 0);
	EXPECT_TRUE(readFile(testFolder() / "log.rawlog") == log);
	EXPECT_TRUE(readFile(testFolder() / "log.truth.json") == truth);
}

TEST(Record, APathIsFollowedAtTheCamerasRate)
{
	const Hall hall;
	writeFile(testFolder() / "path.tum", "# t x y z qx qy qz qw\n100.5 0 0 1.2 0 0 0 1\n102.5 2 0.5 1.4 0 0 0 1\n");
	const auto result = hall.record({"--world", "hall.sdf", "--path", "path.tum", "--robot", "mav", "--rate", "4",
	                                 "--sensor", "ideal", "--out", "log.rawlog"});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const TruthLog truth = hall.truth("log.truth.json");
	ASSERT_EQ(truth.frames.size(), 9U);
	EXPECT_DOUBLE_EQ(truth.frames[0].t, 100.5);
	EXPECT_DOUBLE_EQ(truth.frames[3].t, 101.25);
	EXPECT_NEAR(truth.frames[3].map_from_robot.x(), 0.75, 1e-6);
	EXPECT_NEAR(truth.frames[3].map_from_robot.z(), 1.275, 1e-6);
	EXPECT_EQ(truth.robot.kind, RobotKind::mav);
	EXPECT_DOUBLE_EQ(truth.robot.radius_m, 0.30);
	EXPECT_EQ(truth.noise, "none");
	EXPECT_THAT(hall.info("log.rawlog"), AllOf(HasSubstr("CObservationRobotPose"), HasSubstr("'IDEAL': 9, 4 Hz")));
}

TEST(Record, PosesAreScenesOfTheirOwn)
{
	const Hall hall;
	writeFile(testFolder() / "poses.tum",
	          "100 4 0 0 0 0 0 1\n110 0 0.3 0 0 0 0.70710678 0.70710678\n130 4 0 0 0 0 0 1\n");
	const auto result =
	    hall.record({"--world", "hall.sdf", "--poses", (testFolder() / "poses.tum").string(), "--out", "log.rawlog"});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	EXPECT_EQ(result.err, "");
	const TruthLog truth = hall.truth("log.truth.json");
	ASSERT_EQ(truth.frames.size(), 3U);
	for (std::size_t i = 0; i < 3; ++i)
	{
		EXPECT_EQ(truth.frames[i].index, i);
		EXPECT_EQ(truth.frames[i].scene, static_cast<int>(i));
		EXPECT_DOUBLE_EQ(truth.frames[i].t, i == 0 ? 100.0 : i == 1 ? 110.0 : 130.0);
	}
	EXPECT_NEAR(truth.frames[1].map_from_robot.y(), 0.3, 1e-9);
	EXPECT_NEAR(truth.frames[1].map_from_robot.yaw(), M_PI / 2, 1e-6);
	ASSERT_EQ(truth.frames[2].doors.size(), 1U);
	EXPECT_EQ(truth.frames[2].doors[0].visibility, Visibility::visible);
	EXPECT_THAT(truth.command, HasSubstr("--poses"));
	EXPECT_THAT(hall.info("log.rawlog"), AllOf(HasSubstr("'XTION': 3"), HasSubstr("accelerometer: yes")));
}

TEST(Record, WarnsOfAPathThatTouchesOrLeavesTheWorld)
{
	const Hall hall;
	writeFile(testFolder() / "path.tum", "0 0 0 0 0 0 0 1\n1 0 8 0 0 0 0 1\n");
	const auto result =
	    hall.record({"--world", "hall.sdf", "--path", "path.tum", "--rate", "2", "--out", "log.rawlog"});
	EXPECT_EQ(result.exit_code, 0);
	EXPECT_THAT(result.err, AllOf(HasSubstr("warning: the robot's body touches something"),
	                              HasSubstr("warning: the path leaves the world's bounds")));
	EXPECT_EQ(hall.truth("log.truth.json").frames.size(), 3U);
}

TEST(Record, ARouteThatIsBlockedEndsEarlyWithAWarning)
{
	const Hall hall;
	const auto result =
	    hall.record({"--world", "hall.sdf", "--drive", "into the wall", "--rate", "1", "--out", "log.rawlog"});
	EXPECT_EQ(result.exit_code, 0);
	EXPECT_THAT(result.err, HasSubstr("the route ends early"));
}

TEST(Record, AnIniOfExploreMrptWithSimulatorSectionsIsTaken)
{
	const Hall hall;
	writeFile(testFolder() / "robot.ini",
	          "[robot]\nkind = mav\nheight = 0.2\n[camera]\nmount = ini\npose_z = 0.1\n[perception]\nseed = 3\n"
	          "[simulated_camera]\nname = kinect\n[simulated_robot]\nmax_tilt_deg = 5\n");
	const std::string ini = (testFolder() / "robot.ini").string();
	writeFile(testFolder() / "path.tum", "0 0 0 1 0 0 0 1\n");
	const auto result = hall.record({"--world", "hall.sdf", "--path", "path.tum", "--ini", ini, "--out", "log.rawlog"});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const TruthLog truth = hall.truth("log.truth.json");
	EXPECT_DOUBLE_EQ(truth.robot.height_m, 0.2);
	EXPECT_DOUBLE_EQ(truth.robot.radius_m, 0.30) << "a usual MAV's, for the ini leaves it out";
	EXPECT_DOUBLE_EQ(truth.robot_from_camera.z(), 0.1);
	EXPECT_THAT(hall.info("log.rawlog"), HasSubstr("'KINECT'"));
}

TEST(Record, SaysWhatIsWrong)
{
	const Hall hall;
	const auto expectRefused = [&](const std::vector<std::string>& arguments, int exit_code, const std::string& message)
	{
		const auto result = hall.record(arguments);
		EXPECT_EQ(result.exit_code, exit_code) << result.err;
		EXPECT_THAT(result.err, HasSubstr(message));
	};
	writeFile(testFolder() / "empty.tum", "# nothing\n");
	writeFile(testFolder() / "back.tum", "1 0 0 0 0 0 0 1\n0 1 0 0 0 0 0 1\n");
	expectRefused({"--world", "hall.sdf", "--drive", "up", "--out", "o.rawlog"}, 2, "it has down, into the wall");
	expectRefused({"--world", "none.sdf", "--drive", "up", "--out", "o.rawlog"}, 3, "none.sdf");
	expectRefused({"--world", "hall.sdf", "--path", "none.tum", "--out", "o.rawlog"}, 3, "none.tum");
	expectRefused({"--world", "hall.sdf", "--path", "empty.tum", "--out", "o.rawlog"}, 3, "has no pose");
	expectRefused({"--world", "hall.sdf", "--path", "back.tum", "--out", "o.rawlog"}, 2, "must increase");
	expectRefused({"--world", "hall.sdf", "--out", "o.rawlog"}, 2, "--path");
	writeFile(testFolder() / "near.tum", "0 0 0 0 0 0 0 1\n3 1 0 0 0 0 0 1\n");
	expectRefused({"--world", "hall.sdf", "--poses", (testFolder() / "near.tum").string(), "--out", "o.rawlog"}, 2,
	              "10 s apart or more");
	expectRefused({"--world", "hall.sdf", "--drive", "down", "--sensor", "lidar", "--out", "o.rawlog"}, 2, "xtion");
	expectRefused({"--world", "hall.sdf", "--drive", "down", "--noise", "loud", "--out", "o.rawlog"}, 2, "speckle");
	expectRefused({"--world", "hall.sdf", "--drive", "down", "--set", "robot.radus=1", "--out", "o.rawlog"}, 2,
	              "radius");
	expectRefused({"--world", "hall.sdf", "--drive", "down", "--set", "robot.radius=2", "--out", "o.rawlog"}, 2,
	              "touches something at its start");
	expectRefused({"--world", "hall.sdf", "--drive", "down", "--out", "missing/o.rawlog"}, 5, "missing/o.rawlog");
	EXPECT_FALSE(fs::exists(testFolder() / "o.rawlog"));
	EXPECT_FALSE(fs::exists(testFolder() / "o.truth.json"));
}

TEST(Record, AFullDiskIsNotTakenForSuccess)
{
	const Hall hall;
	const auto result = hall.record({"--world", "hall.sdf", "--drive", "down", "--out", "/dev/full"});
	EXPECT_EQ(result.exit_code, 5);
	EXPECT_THAT(result.err, HasSubstr("/dev/full: cannot be written"));
}
}  // namespace

#include "support/test_files.h"

#include <common/app_config.h>
#include <explore/core/errors.h>
#include <gmock/gmock.h>

using namespace explore;
using namespace explore::app;
using testing::HasSubstr;

namespace
{
ConfigChoices withIni(const std::string& text)
{
	const auto path = test::freshFolder() / "test.ini";
	test::writeFile(path, text);
	ConfigChoices options;
	options.ini = path.string();
	return options;
}
}  // namespace

TEST(AppConfig, WithoutIniTheDefaultsHold)
{
	const auto loaded = loadConfig({});
	EXPECT_TRUE(loaded.ini.empty());
	EXPECT_EQ(loaded.config.explorer.robot.radius_m, 0.22);
	EXPECT_EQ(loaded.config.explorer.perception.range_filter.max_range_m, 5.0);
	EXPECT_TRUE(loaded.config.output.timing);
}

TEST(AppConfig, SetWinsOverTheIniAndSeedOverBoth)
{
	ConfigChoices options = withIni("[robot]\nradius = 0.3\nheight = 0.5\n[perception]\nseed = 3\n");
	options.set = {"robot.radius=0.4"};
	options.seed = 8;
	const auto loaded = loadConfig(options);
	EXPECT_EQ(loaded.config.explorer.robot.radius_m, 0.4);
	EXPECT_EQ(loaded.config.explorer.robot.height_m, 0.5);
	EXPECT_EQ(loaded.config.explorer.perception.seed, 8);
	EXPECT_EQ(loaded.config.source.simulator.seed, 8);
}

TEST(AppConfig, NamedInputSetsItsKind)
{
	ConfigChoices world = withIni("[source]\nkind = rawlog\nrawlog = a.rawlog\n");
	world.world = "b.sdf";
	EXPECT_EQ(loadConfig(world).config.source.kind, SourceKind::simulator);
	EXPECT_EQ(loadConfig(world).config.source.simulator.world, "b.sdf");
	ConfigChoices rawlog = withIni("[source]\nkind = simulator\n");
	rawlog.rawlog = "a.rawlog";
	EXPECT_EQ(loadConfig(rawlog).config.source.kind, SourceKind::rawlog);
}

TEST(AppConfig, RobotKeysLeftOutAreThoseOfItsKind)
{
	const auto robot = loadConfig(withIni("[robot]\nkind = mav\nmax_speed = 0.6\n")).config.explorer.robot;
	EXPECT_EQ(robot.kind, RobotKind::mav);
	EXPECT_EQ(robot.radius_m, 0.30);
	EXPECT_EQ(robot.height_m, 0.25);
	EXPECT_EQ(robot.max_speed_mps, 0.6);
}

TEST(AppConfig, RobotOptionOfTheOtherKindReplacesTheInisRobot)
{
	ConfigChoices options = withIni("[robot]\nkind = ground\nradius = 0.5\nheight = 1.5\n");
	options.robot = RobotKind::mav;
	options.set = {"robot.height=0.2"};
	const auto robot = loadConfig(options).config.explorer.robot;
	EXPECT_EQ(robot.kind, RobotKind::mav);
	EXPECT_EQ(robot.radius_m, 0.30);  // not the ground robot's 0.5
	EXPECT_EQ(robot.height_m, 0.2);
	EXPECT_EQ(robot.max_speed_mps, 0.8);
}

TEST(AppConfig, RobotOptionOfTheSameKindKeepsTheInisRobot)
{
	ConfigChoices options = withIni("[robot]\nkind = mav\nradius = 0.35\n");
	options.robot = RobotKind::mav;
	EXPECT_EQ(loadConfig(options).config.explorer.robot.radius_m, 0.35);
}

TEST(AppConfig, RawlogOptionWinsOverTheIni)
{
	ConfigChoices options = withIni("[source]\nrawlog = a.rawlog\n");
	EXPECT_EQ(loadConfig(options).config.source.rawlog, "a.rawlog");
	options.rawlog = "b.rawlog";
	EXPECT_EQ(loadConfig(options).config.source.rawlog, "b.rawlog");
}

TEST(AppConfig, SensorPosesComeFromAGrabberFile)
{
	const auto grabber = test::freshFolder() / "grabber.ini";
	test::writeFile(grabber, "[KINECT]\nsensorLabel = KINECT\npose_z = 0.7\npose_pitch = 10\n");
	ConfigChoices options;
	options.sensors_pose = grabber.string();
	const auto poses = loadConfig(options).config.source.sensor_poses;
	ASSERT_EQ(poses.count("KINECT"), 1U);
	EXPECT_NEAR(poses.at("KINECT").z(), 0.7, 1e-12);
	EXPECT_NEAR(poses.at("KINECT").pitch(), 0.17453292519943295, 1e-12);
}

TEST(AppConfig, MistakesOnTheCommandLineAreNamed)
{
	const auto message_for = [](const std::string& set)
	{
		ConfigChoices options;
		options.set = {set};
		try
		{
			loadConfig(options);
		}
		catch (const ConfigError& error)
		{
			return std::string(error.what());
		}
		return std::string("accepted");
	};
	EXPECT_THAT(message_for("robot.radios=1"), AllOf(HasSubstr("robot.radios"), HasSubstr("radius")));
	EXPECT_THAT(message_for("robot.radius=wide"), HasSubstr("wide"));
	EXPECT_THAT(message_for("robot.radius"), HasSubstr("robot.radius"));
}

TEST(AppConfig, DumpLoadsBackToTheSameDump)
{
	ConfigChoices options;
	options.set = {"robot.radius=0.1234567890123", "perception.ground_tilt_deg=7.3", "output.pictures_every=4"};
	const std::string dump = dumpConfig(loadConfig(options).config);
	EXPECT_EQ(dumpConfig(loadConfig(withIni(dump)).config), dump);
	EXPECT_EQ(loadConfig(withIni(dump)).config.explorer.robot.radius_m, 0.1234567890123);
}

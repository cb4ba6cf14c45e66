#include <common/exit_codes.h>
#include <explore-mrpt/options.h>
#include <gtest/gtest.h>

using namespace explore;
using namespace explore::app;

namespace
{
ParsedOptions parse(std::vector<const char*> arguments)
{
	arguments.insert(arguments.begin(), "explore-mrpt");
	testing::internal::CaptureStdout();
	testing::internal::CaptureStderr();
	auto parsed = parseOptions(static_cast<int>(arguments.size()), arguments.data());
	testing::internal::GetCapturedStdout();
	testing::internal::GetCapturedStderr();
	return parsed;
}
}  // namespace

TEST(Options, EveryOptionReachesItsField)
{
	const auto parsed = parse({"--ini",          "a.ini",
	                           "--rawlog",       "b.rawlog",
	                           "--out",          "o",
	                           "--set",          "robot.radius=0.3",
	                           "--set",          "perception.seed=5",
	                           "--robot",        "mav",
	                           "--sensors-pose", "g.ini",
	                           "--verbosity",    "DEBUG",
	                           "--max-frames",   "7",
	                           "--seed",         "9",
	                           "--quiet",        "--dump-config",
	                           "--realtime"});
	ASSERT_FALSE(parsed.exit_code);
	const Options& options = parsed.options;
	EXPECT_EQ(options.ini, "a.ini");
	EXPECT_EQ(options.rawlog, "b.rawlog");
	EXPECT_EQ(options.out, "o");
	EXPECT_EQ(options.set, (std::vector<std::string>{"robot.radius=0.3", "perception.seed=5"}));
	EXPECT_EQ(options.robot, RobotKind::mav);
	EXPECT_EQ(options.sensors_pose, "g.ini");
	EXPECT_EQ(options.verbosity, mrpt::system::LVL_DEBUG);
	EXPECT_EQ(options.max_frames, 7U);
	EXPECT_EQ(options.seed, 9);
	EXPECT_TRUE(options.quiet);
	EXPECT_TRUE(options.dump_config);
	EXPECT_TRUE(options.realtime);
}

TEST(Options, AWorldStandsInForARecordingAndNotBesideOne)
{
	EXPECT_EQ(parse({"--world", "a.sdf"}).options.world, "a.sdf");
	EXPECT_EQ(parse({"--world", "a.sdf", "--rawlog", "b.rawlog"}).exit_code, kUsageError);
}

TEST(Options, ADashMeansStandardOutput)
{
	EXPECT_TRUE(parse({"--rawlog", "a", "--out", "-"}).options.toStandardOutput());
	EXPECT_FALSE(parse({"--rawlog", "a"}).options.toStandardOutput());
}

TEST(Options, HelpAndVersionEndWell)
{
	EXPECT_EQ(parse({"--help"}).exit_code, kDone);
	EXPECT_EQ(parse({"--version"}).exit_code, kDone);
}

TEST(Options, MistakesAreUsageErrors)
{
	EXPECT_EQ(parse({}).exit_code, kUsageError);
	EXPECT_EQ(parse({"--rowlog", "a"}).exit_code, kUsageError);
	EXPECT_EQ(parse({"stray"}).exit_code, kUsageError);
	EXPECT_EQ(parse({"--rawlog"}).exit_code, kUsageError);
	EXPECT_EQ(parse({"--robot", "boat"}).exit_code, kUsageError);
	EXPECT_EQ(parse({"--verbosity", "LOUD"}).exit_code, kUsageError);
	EXPECT_EQ(parse({"--max-frames", "0"}).exit_code, kUsageError);
	EXPECT_EQ(parse({"--max-frames", "-3"}).exit_code, kUsageError);
	EXPECT_EQ(parse({"--seed", "many"}).exit_code, kUsageError);
}

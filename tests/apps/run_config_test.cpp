#include "apps/program.h"
#include "apps/rawlog_maker.h"

#include <gmock/gmock.h>

using namespace explore::test;
using testing::HasSubstr;

TEST(RunConfig, TypoIsNamedWithFileLineAndTheNearestKey)
{
	const auto folder = freshFolder();
	writeFile(folder / "my.ini", "// mine\n[perception]\nmax_range = 4\nscan_hieght = 0.8\n");
	const auto result = exploreMrpt({"--ini", (folder / "my.ini").string(), "--rawlog", "any.rawlog"});
	EXPECT_EQ(result.exit_code, 2);
	EXPECT_EQ(result.out, "");
	EXPECT_THAT(result.err, HasSubstr((folder / "my.ini").string()));
	EXPECT_THAT(result.err, HasSubstr("4"));
	EXPECT_THAT(result.err, HasSubstr("scan_hieght"));
	EXPECT_THAT(result.err, HasSubstr("scan_height"));
}

TEST(RunConfig, ValueOutOfBoundsIsRefused)
{
	const auto result = exploreMrpt({"--rawlog", "any.rawlog", "--set", "robot.radius=-1"});
	EXPECT_EQ(result.exit_code, 2);
	EXPECT_THAT(result.err, AllOf(HasSubstr("robot.radius"), HasSubstr("-1")));
}

TEST(RunConfig, MissingIniListsThePlacesTried)
{
	const auto result = exploreMrpt({"--ini", "nowhere.ini"});
	EXPECT_EQ(result.exit_code, 2);
	EXPECT_THAT(result.err, HasSubstr(std::string(EXPLORE_SOURCE_DIR) + "/ini/nowhere.ini"));
}

TEST(RunConfig, NoInputIsAUsageError)
{
	const auto result = exploreMrpt({"--quiet"});
	EXPECT_EQ(result.exit_code, 2);
	EXPECT_THAT(result.err, HasSubstr("--rawlog"));
}

TEST(RunConfig, WithoutArgumentsTheHelpIsShown)
{
	const auto result = exploreMrpt({});
	EXPECT_EQ(result.exit_code, 2);
	EXPECT_EQ(result.out, "");
	EXPECT_THAT(result.err, HasSubstr("--rawlog"));
}

TEST(RunConfig, DumpedConfigurationLoadsBack)
{
	const auto folder = freshFolder();
	const auto first = exploreMrpt({"--dump-config", "--set", "robot.radius=0.31"});
	ASSERT_EQ(first.exit_code, 0) << first.err;
	EXPECT_THAT(first.out, HasSubstr("radius = 0.31"));
	writeFile(folder / "dumped.ini", first.out);
	const auto second = exploreMrpt({"--ini", (folder / "dumped.ini").string(), "--dump-config"});
	EXPECT_EQ(second.exit_code, 0) << second.err;
	EXPECT_EQ(second.out, first.out);
}

TEST(RunConfig, QuietSaysNothingWhenAllIsWell)
{
	const auto folder = freshFolder();
	writeCorridorRawlog(folder / "log.rawlog", {3});
	const auto result =
	    exploreMrpt({"--rawlog", (folder / "log.rawlog").string(), "--out", (folder / "o").string(), "--quiet"});
	EXPECT_EQ(result.exit_code, 0);
	EXPECT_EQ(result.out, "");
	EXPECT_EQ(result.err, "");
}

TEST(RunConfig, RecordingOfTheIniIsFoundBesideIt)
{
	const auto folder = freshFolder();
	writeCorridorRawlog(folder / "log.rawlog", {2});
	writeFile(folder / "my.ini", "[source]\nrawlog = log.rawlog\n");
	Program::Setup setup;
	setup.working_folder = "/";
	const auto result = exploreMrpt({"--ini", (folder / "my.ini").string(), "--out", (folder / "o").string()}, setup);
	EXPECT_EQ(result.exit_code, 0) << result.err;
	EXPECT_EQ(linesOf(readFile(folder / "o" / "frames.jsonl")).size(), 2U);
}

#include "apps/eval_fixture.h"
#include "apps/program.h"
#include "apps/rawlog_maker.h"
#include "apps/rawlog_program.h"

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

TEST(RunConfig, WithoutArgumentsTheFirstCommandsAreShownAndTheHelpHasThemToo)
{
	const auto none = exploreMrpt({});
	EXPECT_EQ(none.exit_code, 2);
	EXPECT_EQ(none.out, "");
	EXPECT_LT(std::ranges::count(none.err, '\n'), 12) << "at a glance";
	const auto help = exploreMrpt({"--help"});
	EXPECT_EQ(help.exit_code, 0);
	for (const std::string command : {"explore-mrpt --ini corridor.ini ", "explore-mrpt --ini xtion.ini ",
	                                  "explore-mrpt --ini corridor.ini --rawlog ", "explore-out/report.html"})
	{
		EXPECT_THAT(none.err, HasSubstr(command));
		EXPECT_THAT(help.out, HasSubstr(command));
	}
	EXPECT_THAT(none.err, HasSubstr("explore-mrpt --help"));
}

// Each is run elsewhere as it stands, but for the names of files; here: that no option of it is unknown.
TEST(RunConfig, TheFirstCommandsOfEveryProgramAreUnderstood)
{
	const auto none = freshFolder() / "none";
	const std::string file = (none / "my.rawlog").string();
	const std::string out = (none / "out").string();
	EXPECT_EQ(exploreMrpt({"--ini", "corridor.ini", "--rawlog", file, "--out", out}).exit_code, 3);
	EXPECT_EQ(exploreRawlog({"info", file}).exit_code, 3);
	EXPECT_EQ(exploreRawlog({"import", "--png", none.string(), "--intrinsics", "525,525,319.5,239.5", "--out", file})
	              .exit_code,
	          3);
	EXPECT_EQ(exploreEval({file, "--ini", "corridor.ini", "--out", out}).exit_code, 3);
	EXPECT_EQ(exploreEval({"compare", out, file}).exit_code, 3);
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

#include "apps/program.h"
#include "apps/rawlog_maker.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

using namespace explore::test;
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
std::string corridorLog(std::size_t frames)
{
	const auto path = freshFolder() / "log.rawlog";
	writeCorridorRawlog(path, {frames});
	return path.string();
}
}  // namespace

TEST(RunOutput, DashWritesTheSameLinesToStandardOutputAndNothingElse)
{
	const auto log = corridorLog(4);
	Program::Setup setup;
	setup.working_folder = testFolder();
	const auto result = exploreMrpt({"--rawlog", log, "--out", "-"}, setup);
	ASSERT_EQ(result.exit_code, 0) << result.err;
	EXPECT_FALSE(fs::exists(testFolder() / "-"));
	EXPECT_FALSE(fs::exists(testFolder() / "explore-out"));
	ASSERT_EQ(exploreMrpt({"--rawlog", log}, setup).exit_code, 0);
	EXPECT_EQ(result.out, readFile(testFolder() / "explore-out" / "frames.jsonl"));
}

TEST(RunOutput, FullStandardOutputIsNoticed)
{
	if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
	Program::Setup setup;
	setup.standard_output = "/dev/full";
	const auto log = corridorLog(3);
	for (const auto& arguments : {std::vector<std::string>{"--rawlog", log, "--out", "-"},
	                              {"--rawlog", log, "--out", (testFolder() / "o").string()},
	                              {"--dump-config"}})
	{
		const auto result = exploreMrpt(arguments, setup);
		EXPECT_EQ(result.exit_code, 5);
		EXPECT_THAT(result.err, HasSubstr("standard output"));
	}
}

TEST(RunOutput, FullDiskLeavesWholeLines)
{
	const auto log = corridorLog(12);
	Program::Setup setup;
	setup.file_size_limit = 8000;
	const auto result =
	    exploreMrpt({"--rawlog", log, "--out", (testFolder() / "o").string(), "--set", "output.report=false"}, setup);
	EXPECT_EQ(result.exit_code, 5);
	EXPECT_THAT(result.err, HasSubstr("frames.jsonl"));
	const auto frames = readFile(testFolder() / "o" / "frames.jsonl");
	EXPECT_EQ(frames.back(), '\n');
	const auto lines = linesOf(frames);
	EXPECT_GE(lines.size(), 1U);
	EXPECT_LT(lines.size(), 12U);
	for (const auto& line : lines) EXPECT_TRUE(json::accept(line));
	const json summary = json::parse(readFile(testFolder() / "o" / "summary.json"));
	EXPECT_THAT(summary["exploration"]["reason"].get<std::string>(), HasSubstr("frames.jsonl"));
	EXPECT_FALSE(std::filesystem::exists(testFolder() / "o" / "map.ot.part"));
}

TEST(RunOutput, AFileInPlaceOfTheFolderIsRefusedAndKept)
{
	const auto log = corridorLog(2);
	writeFile(testFolder() / "file", "keep");
	for (const auto& out : {testFolder() / "file", testFolder() / "file" / "below"})
	{
		const auto result = exploreMrpt({"--rawlog", log, "--out", out.string()});
		EXPECT_EQ(result.exit_code, 5);
		EXPECT_THAT(result.err, HasSubstr("file"));
	}
	EXPECT_EQ(readFile(testFolder() / "file"), "keep");
}

TEST(RunOutput, ASecondRunReplacesTheFirst)
{
	const auto log = corridorLog(6);
	const auto out = (testFolder() / "o").string();
	ASSERT_EQ(exploreMrpt({"--rawlog", log, "--out", out, "--set", "output.pictures_every=2"}).exit_code, 0);
	EXPECT_TRUE(fs::exists(fs::path(out) / "pictures" / "000004.png"));
	ASSERT_EQ(exploreMrpt({"--rawlog", log, "--out", out, "--max-frames", "2", "--set", "output.timing=false", "--set",
	                       "output.trajectory=false"})
	              .exit_code,
	          0);
	EXPECT_EQ(linesOf(readFile(fs::path(out) / "frames.jsonl")).size(), 2U);
	EXPECT_FALSE(fs::exists(fs::path(out) / "pictures"));
	EXPECT_FALSE(fs::exists(fs::path(out) / "timing.csv"));
	EXPECT_FALSE(fs::exists(fs::path(out) / "trajectory.tum"));
}

TEST(RunOutput, NothingButTheSummaryOnStandardOutput)
{
	const auto log = corridorLog(3);
	const auto result = exploreMrpt({"--rawlog", log, "--out", (testFolder() / "o").string(), "--verbosity", "DEBUG"});
	ASSERT_EQ(result.exit_code, 0);
	EXPECT_EQ(result.out.rfind("3 frames of ", 0), 0U) << result.out;
	EXPECT_THAT(result.out, HasSubstr("results in " + (testFolder() / "o").string()));
}

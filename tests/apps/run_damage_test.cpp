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
ProgramResult exploreFile(const fs::path& rawlog, const fs::path& out)
{
	return exploreMrpt({"--rawlog", rawlog.string(), "--out", out.string()});
}
}  // namespace

TEST(RunDamage, TruncatedLogKeepsTheFramesBeforeTheCut)
{
	const auto folder = freshFolder();
	writeCorridorRawlog(folder / "whole.rawlog", {10});
	const std::string bytes = readFile(folder / "whole.rawlog");
	ASSERT_EQ(exploreFile(folder / "whole.rawlog", folder / "whole").exit_code, 0);
	const auto whole = linesOf(readFile(folder / "whole" / "frames.jsonl"));
	for (const double share : {0.35, 0.6, 0.95})
	{
		writeFile(folder / "cut.rawlog", bytes.substr(0, static_cast<std::size_t>(share * double(bytes.size()))));
		const auto result = exploreFile(folder / "cut.rawlog", folder / "cut");
		EXPECT_EQ(result.exit_code, 3);
		EXPECT_THAT(result.err, HasSubstr("cut.rawlog"));
		const auto cut = linesOf(readFile(folder / "cut" / "frames.jsonl"));
		ASSERT_GE(cut.size(), static_cast<std::size_t>(share * 10) - 1);
		ASSERT_LT(cut.size(), 10U);
		for (std::size_t i = 0; i < cut.size(); ++i) EXPECT_EQ(cut[i], whole[i]) << "line " << i;
		const json summary = json::parse(readFile(folder / "cut" / "summary.json"));
		EXPECT_EQ(summary["exploration"]["reason"], "input damaged");
		EXPECT_FALSE(summary["source"]["damage"].is_null());
		EXPECT_GE(summary["source"]["lost_objects"].get<int>(), 1);
		EXPECT_EQ(summary["source"]["frames"], cut.size());
	}
}

TEST(RunDamage, WhatIsNoRawlogIsAnInputError)
{
	const auto folder = freshFolder();
	writeFile(folder / "text.rawlog", "This is no rawlog.\nIt only has the name of one.\n");
	writeFile(folder / "empty.rawlog", "");
	for (const char* name : {"text.rawlog", "empty.rawlog", "missing.rawlog"})
	{
		const auto result = exploreFile(folder / name, folder / "o");
		EXPECT_EQ(result.exit_code, 3) << name;
		EXPECT_THAT(result.err, HasSubstr(name));
		EXPECT_EQ(result.out, "") << name;
	}
}

TEST(RunDamage, UnreadableInputLeavesAnEarlierRunAlone)
{
	const auto folder = freshFolder();
	fs::create_directories(folder / "o");
	writeFile(folder / "o" / "frames.jsonl", "earlier\n");
	writeFile(folder / "text.rawlog", "This is no rawlog.\n");
	for (const char* name : {"missing.rawlog", "text.rawlog"})
		EXPECT_EQ(exploreFile(folder / name, folder / "o").exit_code, 3) << name;
	EXPECT_EQ(readFile(folder / "o" / "frames.jsonl"), "earlier\n");
}

TEST(RunDamage, LogWithoutDepthFramesIsAnInputError)
{
	const auto folder = freshFolder();
	const fs::path odometry_only = "/usr/share/mrpt/datasets/localization_demo.rawlog";
	if (!fs::exists(odometry_only)) GTEST_SKIP() << "needs " << odometry_only;
	EXPECT_EQ(exploreFile(odometry_only, folder / "o").exit_code, 3);
}

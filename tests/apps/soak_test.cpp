// explore-eval soak as a user runs it: worlds and seeds, tables, and what it does when a run fails.
#include "apps/program.h"

#include <gmock/gmock.h>

using namespace explore::test;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
ProgramResult soak(std::vector<std::string> more)
{
	std::vector<std::string> arguments{"soak", "--ini", "corridor.ini", "--set", "simulator.time_limit=0.5"};
	arguments.insert(arguments.end(), more.begin(), more.end());
	return Program(EXPLORE_EVAL_PROGRAM, arguments, {}).wait();
}
}  // namespace

TEST(SoakCommand, ExploresEveryWorldWithEverySeed)
{
	const fs::path out = freshFolder() / "o";
	const auto result = soak({"--world", "corridor.sdf", "--world", "corridor.sdf@lobby", "--world", "office.sdf",
	                          "--runs", "2", "--seed", "5", "--jobs", "2", "--out", out.string()});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const auto rows = linesOf(readFile(out / "soak.csv"));
	ASSERT_EQ(rows.size(), 7U);
	EXPECT_THAT(rows[1], HasSubstr("corridor,5,,0,time limit,0.5,6,"));
	EXPECT_THAT(rows[2], HasSubstr("corridor_2,5,"));
	EXPECT_THAT(rows[6], HasSubstr("office,6,"));
	for (const char* world : {"corridor", "corridor_2", "office"})
		for (const char* seed : {"5", "6"})
		{
			EXPECT_TRUE(fs::exists(out / world / seed / "summary.json"));
			EXPECT_FALSE(fs::exists(out / world / seed / "frames.jsonl"));
		}
	EXPECT_NE(readFile(out / "corridor/5/truth.tum"), readFile(out / "corridor_2/5/truth.tum"));
	EXPECT_EQ(result.out, readFile(out / "soak.txt"));
	EXPECT_THAT(result.out, HasSubstr("0 of 2"));
	EXPECT_THAT(result.err, HasSubstr("explored 6 of 6"));
}

TEST(SoakCommand, ARunIsTheOneThatExploreMrptMakes)
{
	const fs::path folder = freshFolder(), out = folder / "o", alone = folder / "alone";
	ASSERT_EQ(soak({"--world", "corridor.sdf", "--runs", "1", "--seed", "3", "--keep-frames", "--out", out.string()})
	              .exit_code,
	          0);
	ASSERT_EQ(exploreMrpt({"--ini", "corridor.ini", "--world", "corridor.sdf", "--seed", "3", "--set",
	                       "simulator.time_limit=0.5", "--out", alone.string()})
	              .exit_code,
	          0);
	EXPECT_EQ(readFile(out / "corridor/3/frames.jsonl"), readFile(alone / "frames.jsonl"));
}

TEST(SoakCommand, AFailedRunLeavesTheOthers)
{
	const fs::path out = freshFolder() / "o";
	const auto result =
	    soak({"--world", "corridor.sdf@attic", "--world", "office.sdf", "--runs", "1", "--out", out.string()});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.out, AllOf(HasSubstr("corridor, seed 1: failed: "), HasSubstr("attic"), HasSubstr("office")));
}

TEST(SoakCommand, OutOfTimeNothingMoreBegins)
{
	const fs::path out = freshFolder() / "o";
	const auto result = soak({"--world", "corridor.sdf", "--runs", "50", "--minutes", "0.02", "--out", out.string()});
	EXPECT_EQ(result.exit_code, 0);
	EXPECT_LT(linesOf(readFile(out / "soak.csv")).size(), 51U);
	EXPECT_THAT(result.err, HasSubstr("were not begun"));
}

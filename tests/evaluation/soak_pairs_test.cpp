// Explorations compared pair by pair, from runs whose figures are written by hand.
#include "support/test_files.h"

#include <explore/core/errors.h>
#include <explore/evaluation/soak_pairs.h>
#include <explore/sinks/summary.h>
#include <gmock/gmock.h>

using namespace explore;
using namespace explore::evaluation;
using testing::HasSubstr;

namespace
{
SoakRun runOf(const std::string& world, int seed, double path_m, bool complete = true)
{
	SoakRun run;
	run.world = world;
	run.seed = seed;
	run.complete = complete;
	run.path_m = path_m;
	run.coverage = 0.99;
	return run;
}

void leaveSummary(const std::filesystem::path& folder, double path_m)
{
	RunSummary summary;
	summary.truth = TruthSummary{{}, 0.125, path_m, 0.0, 0, 40.0, 0.9};
	std::filesystem::create_directories(folder);
	test::writeFile(folder / "summary.json", summaryJson(summary));
}
}  // namespace

TEST(SoakPairs, AreRunsOfTheSameWorldAndSeed)
{
	const std::vector<SoakRun> base{runOf("office", 1, 100), runOf("corridor", 1, 50), runOf("office", 2, 100)};
	const std::vector<SoakRun> other{runOf("office", 2, 130), runOf("office", 1, 110), runOf("office", 3, 999)};
	const auto worlds = pairsOf(base, other);
	ASSERT_EQ(worlds.size(), 1U) << "the corridor has no pair";
	EXPECT_EQ(worlds[0].world, "office");
	ASSERT_EQ(worlds[0].base.size(), 2U);
	EXPECT_EQ(worlds[0].other[0].path_m, 110);
	EXPECT_EQ(worlds[0].other[1].path_m, 130);
	EXPECT_DOUBLE_EQ(longerShare(worlds[0]).value(), 0.2);
}

TEST(SoakPairs, WaysOfRunsThatDidNotEndAreNotCompared)
{
	const std::vector<SoakRun> base{runOf("office", 1, 100), runOf("office", 2, 5, false)};
	const std::vector<SoakRun> other{runOf("office", 1, 150), runOf("office", 2, 500)};
	EXPECT_DOUBLE_EQ(longerShare(pairsOf(base, other).at(0)).value(), 0.5);
	const std::vector<SoakRun> none{runOf("office", 1, 1, false)};
	EXPECT_FALSE(longerShare(pairsOf(none, other).at(0)));
}

TEST(SoakPairs, TheTableHasTheIntervalAndALineForAll)
{
	std::vector<SoakRun> base, other;
	for (int seed = 1; seed <= 8; ++seed)
		for (const char* world : {"corridor", "office"})
		{
			base.push_back(runOf(world, seed, 100));
			other.push_back(runOf(world, seed, seed % 2 == 0 ? 110 : 130));
		}
	const std::string text = soakPairsText("ours", "nearest", pairsOf(base, other));
	EXPECT_THAT(text, HasSubstr("nearest (other) beside ours"));
	EXPECT_THAT(text, HasSubstr("+20.0 [+1"));
	EXPECT_THAT(text, HasSubstr("  all "));
	EXPECT_THAT(text, HasSubstr("16 of 16"));
}

TEST(SoakPairs, AreReadFromWhatSoakLeaves)
{
	const auto folder = test::freshFolder();
	leaveSummary(folder / "office" / "2", 20);
	leaveSummary(folder / "corridor" / "1", 10);
	leaveSummary(folder / "office" / "notes", 30);
	const auto runs = readSoakRuns(folder);
	ASSERT_EQ(runs.size(), 2U);
	EXPECT_EQ(runs[0].world, "corridor");
	EXPECT_EQ(runs[1].seed, 2);
	EXPECT_EQ(runs[1].path_m, 20);
	EXPECT_TRUE(readSoakRuns(folder / "nothing").empty());
	test::writeFile(folder / "office" / "2" / "summary.json", "{");
	EXPECT_THROW(readSoakRuns(folder), InputError);
}

// Tables over simulated runs, from runs whose figures are written by hand.
#include "support/test_files.h"

#include <explore/core/errors.h>
#include <explore/evaluation/soak.h>
#include <explore/sinks/summary.h>
#include <gmock/gmock.h>

using namespace explore;
using namespace explore::evaluation;
using testing::HasSubstr;
using testing::Not;

namespace
{
SoakRun goodRun(const std::string& world, int seed, double coverage)
{
	SoakRun run;
	run.world = world;
	run.seed = seed;
	run.complete = true;
	run.reason = "nothing reachable left";
	run.coverage = coverage;
	run.path_m = 50;
	run.time_s = 120;
	return run;
}

/** The line of the table that begins with `world`. */
std::string lineOf(const std::string& table, const std::string& world)
{
	const std::size_t at = table.find("  " + world + " ");
	return at == std::string::npos ? "" : table.substr(at, table.find('\n', at) - at);
}
}  // namespace

TEST(Soak, ReadsWhatARunLeaves)
{
	RunSummary summary;
	summary.reason = "time limit";
	summary.truth = TruthSummary{{{}, {}}, 0.125, 31.5, 0.25, 3, 40.5, 0.875};
	const auto path = test::freshFolder() / "summary.json";
	test::writeFile(path, summaryJson(summary));
	const SoakRun run = readSoakRun("corridor", 7, path);
	EXPECT_EQ(run.world, "corridor");
	EXPECT_EQ(run.seed, 7);
	EXPECT_FALSE(run.complete);
	EXPECT_EQ(run.reason, "time limit");
	EXPECT_EQ(run.collisions, 2U);
	EXPECT_EQ(run.goal_flips, 3U);
	EXPECT_EQ(run.coverage, 0.875);
	EXPECT_EQ(run.min_clearance_m, 0.125);
	EXPECT_EQ(run.path_m, 31.5);
	EXPECT_EQ(run.from_start_m, 0.25);
	EXPECT_EQ(run.reachable_m2, 40.5);

	summary.truth.reset();
	test::writeFile(path, summaryJson(summary));
	EXPECT_THROW(readSoakRun("corridor", 7, path), InputError) << "of a recording nothing is known";
}

TEST(Soak, ALineAWorldAndOneForAll)
{
	std::vector<SoakRun> runs{goodRun("office", 1, 0.99), goodRun("office", 2, 0.98), goodRun("office", 3, 0.97),
	                          goodRun("corridor", 1, 1.0)};
	runs[1].goal_flips = 3;
	runs[2].from_start_m = 0.12;
	const std::string table = soakText(runs);
	EXPECT_THAT(lineOf(table, "office"),
	            AllOf(HasSubstr("3 of 3"), HasSubstr("0.9700"), HasSubstr("0.9800 [0.9700, 0.9900]"), HasSubstr("0.12"),
	                  HasSubstr("2.00 [0.00, ")));
	EXPECT_THAT(lineOf(table, "corridor"), AllOf(HasSubstr("1 of 1"), HasSubstr("1.0000 [1.0000, 1.0000]")));
	EXPECT_THAT(lineOf(table, "all"), HasSubstr("4 of 4"));
	EXPECT_LT(table.find("office"), table.find("corridor"));
	EXPECT_THAT(table, Not(HasSubstr("did not complete")));
}

TEST(Soak, WhatWentWrongIsListedAndAFailedRunIsInNoFigure)
{
	std::vector<SoakRun> runs{goodRun("office", 1, 0.99), goodRun("office", 2, 0.98), goodRun("office", 3, 0.10)};
	runs[1].complete = false;
	runs[1].reason = "time limit";
	runs[1].collisions = 2;
	runs[2].error = "no such world";
	const std::string table = soakText(runs);
	EXPECT_THAT(lineOf(table, "office"), AllOf(HasSubstr("1 of 2"), HasSubstr("0.9800"), Not(HasSubstr("0.1000"))));
	EXPECT_THAT(table, AllOf(HasSubstr("office, seed 2: not complete: time limit; 2 collisions"),
	                         HasSubstr("office, seed 3: failed: no such world")));
	EXPECT_EQ(soakText({}), "");
}

TEST(Soak, CsvHasARowARun)
{
	SoakRun run = goodRun("home", 4, 0.5);
	run.coverage.reset();
	run.collisions = 1;
	const std::string csv = soakCsv(std::vector<SoakRun>{run});
	EXPECT_THAT(csv, HasSubstr("world,seed,error,complete,reason,time_s,"));
	EXPECT_THAT(csv, HasSubstr("\nhome,4,,1,nothing reachable left,120,0,50,0,1,0,0,,,0\n"));
}

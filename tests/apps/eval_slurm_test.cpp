// The job array script against a stand-in for sbatch that runs each task at once.
#include "apps/eval_fixture.h"
#include "apps/program.h"

#include <gmock/gmock.h>

using namespace explore;
namespace fs = std::filesystem;

namespace
{
constexpr const char* kSbatch = R"(#!/bin/sh
array='' output='' status=0
while :; do
	case $1 in
	--array=0-*) array=${1#--array=0-} ;;
	--output=*) output=$(echo "${1#--output=}" | sed 's/%A/7/;s/%a/all/') ;;
	--*) echo "$1" >> "$SBATCH_LOG" ;;
	*) break ;;
	esac
	shift
done
for i in $(seq 0 "${array:-0}"); do
	SLURM_ARRAY_TASK_ID=$i "$@" >> "$output" 2>&1 || status=$?
done
echo 7
[ -n "$array" ] || exit $status
)";

struct Cluster
{
	fs::path folder = test::freshFolder();
	std::vector<std::string> logs;

	Cluster()
	{
		fs::create_directories(folder / "bin");
		test::writeFile(folder / "bin" / "sbatch", kSbatch);
		fs::permissions(folder / "bin" / "sbatch", fs::perms::owner_all);
		const auto head = test::headOf("frontal", "single wall single door");
		for (const char* name : {"a", "b", "with blank"})
			logs.push_back(test::writeScoredLog(folder, name, {{2.6}, {3.0, 0.4}}, head).string());
		test::writeFile(folder / "logs.txt", "# logs\n" + logs[0] + "\n\n" + logs[1] + "\n" + logs[2] + "\n");
	}

	[[nodiscard]] test::ProgramResult submit(std::vector<std::string> arguments) const
	{
		const std::vector<std::string> environment{"PATH=" + (folder / "bin").string() + ":/usr/bin:/bin",
		                                           "SBATCH_LOG=" + (folder / "sbatch.log").string(),
		                                           std::string("EXPLORE_EVAL=") + EXPLORE_EVAL_PROGRAM,
		                                           EXPLORE_SOURCE_DIR "/apps/explore-eval/slurm_array.sh"};
		arguments.insert(arguments.begin(), environment.begin(), environment.end());
		return test::Program("/usr/bin/env", arguments, {}).wait();
	}
};
}  // namespace

TEST(EvalSlurm, TheArrayGivesWhatOneRunGives)
{
	const Cluster cluster;
	const auto out = (cluster.folder / "out").string(), whole = (cluster.folder / "whole").string();
	const auto result =
	    cluster.submit({"-w", "corridor.ini", (cluster.folder / "logs.txt").string(), out, "--seed", "2"});
	EXPECT_EQ(result.exit_code, 0) << result.err << test::readFile(cluster.folder / "out/slurm/merge.txt");
	ASSERT_EQ(test::Program(EXPLORE_EVAL_PROGRAM,
	                        {"--ini", "corridor.ini", "--seed", "2", "--out", whole, cluster.logs[0], cluster.logs[1],
	                         cluster.logs[2]},
	                        {})
	              .wait()
	              .exit_code,
	          0);
	for (const char* file : {"eval.json", "frames.csv", "doors.csv", "table.txt", "index.html"})
		EXPECT_TRUE(test::readFile(fs::path(out) / file) == test::readFile(fs::path(whole) / file)) << file;
	const std::string asked = test::readFile(cluster.folder / "sbatch.log");
	EXPECT_THAT(asked, testing::HasSubstr("--dependency=afterany:7"));
	EXPECT_THAT(asked, testing::HasSubstr("--wait"));
}

TEST(EvalSlurm, RequirementsAreJudgedOverAllParts)
{
	const Cluster cluster;
	const auto list = (cluster.folder / "logs.txt").string(), out = (cluster.folder / "out").string();
	const std::string paper = "perception.method=paper";
	EXPECT_EQ(cluster.submit({"-r", "recall.value=1", "corridor.ini", list, out, "--set", paper}).exit_code, 0);
	EXPECT_EQ(cluster.submit({"-r", "recall=0.99", "corridor.ini", list, out, "--set", paper}).exit_code, 1);
	EXPECT_THAT(test::readFile(cluster.folder / "out/slurm/merge.txt"), testing::HasSubstr("recall: measured 1.0000"));
}

TEST(EvalSlurm, MistakesAreUsageErrors)
{
	const Cluster cluster;
	EXPECT_EQ(cluster.submit({}).exit_code, 2);
	test::writeFile(cluster.folder / "empty.txt", "# nothing\n");
	const auto result =
	    cluster.submit({"corridor.ini", (cluster.folder / "empty.txt").string(), (cluster.folder / "out").string()});
	EXPECT_EQ(result.exit_code, 2);
	EXPECT_THAT(result.err, testing::HasSubstr("empty.txt: names no log"));
}

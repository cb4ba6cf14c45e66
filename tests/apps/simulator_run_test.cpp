// explore-mrpt with a simulated robot, as a user runs it: what it leaves, when it ends, what it refuses.
#include "apps/program.h"
#include "apps/tum_file.h"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

using namespace explore::test;
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
/** A run in the corridor world; `more` comes last. */
ProgramResult inCorridor(const fs::path& out, std::vector<std::string> more)
{
	std::vector<std::string> arguments{"--ini", "corridor.ini", "--world", "corridor.sdf", "--out", out.string()};
	arguments.insert(arguments.end(), more.begin(), more.end());
	return exploreMrpt(arguments);
}

json summaryIn(const fs::path& out)
{
	return json::parse(readFile(out / "summary.json"));
}

double lengthOf(const std::vector<Eigen::Vector2d>& path)
{
	double length = 0;
	for (std::size_t i = 1; i < path.size(); i++) length += (path[i] - path[i - 1]).norm();
	return length;
}
}  // namespace

TEST(SimulatorRun, DrivesDownTheCorridorAndLeavesItsTruth)
{
	const auto out = freshFolder() / "o";
	const auto result = inCorridor(out, {"--max-frames", "210"});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	EXPECT_EQ(linesOf(readFile(out / "frames.jsonl")).size(), 210U);
	// The pose is exact unless the ini says otherwise.
	EXPECT_EQ(readFile(out / "truth.tum"), readFile(out / "trajectory.tum"));
	const auto path = placesIn(out / "truth.tum");
	ASSERT_EQ(path.size(), 210U);
	EXPECT_NEAR(path.front().x(), 0.8, 1e-6) << "the world's first spawn";
	EXPECT_GT(path.back().x(), 1.5) << "21 s, of which it looks around for some";

	const json summary = summaryIn(out);
	EXPECT_EQ(summary["source"]["kind"], "simulator");
	EXPECT_EQ(summary["source"]["pose_from"], "robot_pose");
	EXPECT_EQ(summary["exploration"]["reason"], "max frames");
	EXPECT_EQ(summary["truth"]["collisions"], 0);
	EXPECT_GT(summary["truth"]["min_clearance_m"].get<double>(), 0.05);
	EXPECT_NEAR(summary["truth"]["path_m"].get<double>(), lengthOf(path), 0.01);
	EXPECT_GT(summary["truth"]["reachable_m2"].get<double>(), 50.0);
	EXPECT_THAT(result.out, HasSubstr("0 collisions"));
}

TEST(SimulatorRun, ThePapersPolicyDrivesToo)
{
	const auto out = freshFolder() / "o";
	const auto result = inCorridor(out, {"--max-frames", "60", "--set", "goal.policy=paper"});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const auto path = placesIn(out / "truth.tum");
	ASSERT_EQ(path.size(), 60U);
	EXPECT_GT(path.back().x(), 1.3) << "it began at 0.8, with nothing but its first view on the map";
	EXPECT_EQ(summaryIn(out)["truth"]["collisions"], 0);
}

TEST(SimulatorRun, SameSeedSameBytesOtherSeedOthers)
{
	const auto folder = freshFolder();
	const auto frames = [&](const std::string& name, const std::string& seed)
	{
		const auto result = inCorridor(folder / name, {"--max-frames", "8", "--seed", seed});
		EXPECT_EQ(result.exit_code, 0) << result.err;
		return readFile(folder / name / "frames.jsonl");
	};
	const std::string first = frames("a", "3");
	EXPECT_FALSE(first.empty());
	EXPECT_EQ(frames("b", "3"), first);
	EXPECT_NE(frames("c", "4"), first);
}

TEST(SimulatorRun, OdometryDriftsFromTheTruth)
{
	const auto out = freshFolder() / "o";
	ASSERT_EQ(inCorridor(out, {"--max-frames", "40", "--set", "simulator.pose=odometry"}).exit_code, 0);
	EXPECT_NE(readFile(out / "truth.tum"), readFile(out / "trajectory.tum"));
	EXPECT_NEAR(placesIn(out / "truth.tum").back().x(), placesIn(out / "trajectory.tum").back().x(), 0.2);
	EXPECT_EQ(summaryIn(out)["source"]["pose_from"], "odometry");
}

TEST(SimulatorRun, EndsAtItsTimeLimit)
{
	const auto out = freshFolder() / "o";
	ASSERT_EQ(inCorridor(out, {"--set", "simulator.time_limit=0.5"}).exit_code, 0);
	EXPECT_EQ(linesOf(readFile(out / "frames.jsonl")).size(), 6U);
	EXPECT_EQ(summaryIn(out)["exploration"]["reason"], "time limit");
}

TEST(SimulatorRun, AMavFliesInItsBand)
{
	const auto out = freshFolder() / "o";
	const auto result = exploreMrpt(
	    {"--ini", "warehouse.ini", "--world", "warehouse.sdf", "--max-frames", "20", "--out", out.string()});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const json first = json::parse(linesOf(readFile(out / "frames.jsonl")).front());
	EXPECT_NEAR(first["pose"]["z"].get<double>(), 1.2, 1e-6);
	EXPECT_EQ(summaryIn(out)["truth"]["collisions"], 0);
}

TEST(SimulatorRun, RealtimeTakesAsLongAsTheRobotDoes)
{
	const auto start = std::chrono::steady_clock::now();
	ASSERT_EQ(inCorridor(freshFolder() / "o", {"--max-frames", "16", "--realtime"}).exit_code, 0);
	EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(1500));
}

TEST(SimulatorRun, InterruptedItEndsWell)
{
	const auto out = freshFolder() / "o";
	Program program(EXPLORE_MRPT_PROGRAM,
	                {"--ini", "corridor.ini", "--world", "corridor.sdf", "--realtime", "--out", out.string()}, {});
	while (program.running() && !fs::exists(out / "truth.tum")) std::this_thread::yield();
	program.signal(SIGINT);
	EXPECT_EQ(program.wait().exit_code, 130);
	EXPECT_EQ(summaryIn(out)["exploration"]["reason"], "interrupted");
	EXPECT_TRUE(summaryIn(out).contains("truth"));
}

TEST(SimulatorRun, StartsWhereItIsTold)
{
	const auto out = freshFolder() / "o";
	ASSERT_EQ(inCorridor(out, {"--max-frames", "1", "--set", "simulator.start=lobby"}).exit_code, 0);
	EXPECT_NEAR(placesIn(out / "truth.tum").front().x(), 13.0, 1e-6);
	const auto nowhere = inCorridor(out, {"--set", "simulator.start=attic"});
	EXPECT_EQ(nowhere.exit_code, 2);
	EXPECT_THAT(nowhere.err, AllOf(HasSubstr("attic"), HasSubstr("lobby")));
	const auto in_wall = inCorridor(out, {"--set", "simulator.start=0.8 0.95 0"});
	EXPECT_EQ(in_wall.exit_code, 2);
	EXPECT_THAT(in_wall.err, HasSubstr("touches something at its start"));
}

TEST(SimulatorRun, AMissingWorldListsThePlacesTried)
{
	const auto result = exploreMrpt({"--world", "moon.sdf"});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.err, AllOf(HasSubstr("moon.sdf"), HasSubstr("rawlogs/worlds/moon.sdf")));
	const auto none = exploreMrpt({"--set", "source.kind=simulator"});
	EXPECT_EQ(none.exit_code, 2);
	EXPECT_THAT(none.err, HasSubstr("--world"));
}

// Whole explorations of a small world, as a user runs them: to the end, within bounds, and home in time.
#include "apps/program.h"
#include "apps/tum_file.h"

#include <explore/sources/map_file.h>
#include <gmock/gmock.h>

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <set>

using namespace explore;
using namespace explore::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace
{
/** A run of the ground robot in a corridor of 6 m with three furnished rooms; `more` comes last. */
json explored(const fs::path& out, const std::vector<std::string>& more = {})
{
	std::vector<std::string> arguments{"--ini",   "corridor.ini",
	                                   "--world", std::string(EXPLORE_SOURCE_DIR) + "/tests/data/three_rooms.sdf",
	                                   "--set",   "simulated_camera.width_px=160",
	                                   "--out",   out.string()};
	arguments.insert(arguments.end(), more.begin(), more.end());
	const auto result = exploreMrpt(arguments);
	EXPECT_EQ(result.exit_code, 0) << result.err;
	return json::parse(readFile(out / "summary.json"));
}

/** The middles of the lines of open doors. */
std::vector<Eigen::Vector2d> openDoorsIn(const fs::path& geojson)
{
	std::vector<Eigen::Vector2d> middles;
	const json all = json::parse(readFile(geojson));
	for (const json& feature : all["features"])
	{
		if (feature["properties"]["kind"] != "door" || feature["properties"]["verdict"] != "open") continue;
		const json& line = feature["geometry"]["coordinates"];
		middles.emplace_back((line[0][0].get<double>() + line[1][0].get<double>()) / 2,
		                     (line[0][1].get<double>() + line[1][1].get<double>()) / 2);
	}
	return middles;
}

/** Matches a place less than 10 cm from this one. */
auto near(double x, double y)
{
	return testing::ResultOf([x, y](const Eigen::Vector2d& place) { return (place - Eigen::Vector2d(x, y)).norm(); },
	                         testing::Lt(0.1));
}

void expectSafeAndHome(const json& summary)
{
	EXPECT_EQ(summary["truth"]["collisions"], 0);
	EXPECT_EQ(summary["truth"]["goal_flips"], 0);
	EXPECT_LT(summary["truth"]["from_start_m"].get<double>(), 0.15);
	EXPECT_LT(summary["exploration"]["home_error_m"].get<double>(), 0.15);
}

/** Why places were left, each once. */
std::set<std::string> reasonsIn(const json& summary)
{
	std::set<std::string> reasons;
	for (const json& left : summary["exploration"]["left_over"]) reasons.insert(left["why"].get<std::string>());
	return reasons;
}

const std::set<std::string> kReasons{"sealed",       "too_narrow", "out_of_reach", "closed_door",
                                     "behind_glass", "drop",       "kept_out",     "outside_bounds"};
}  // namespace

TEST(Exploration, ComesHomeWithAllOfTheBuilding)
{
	const auto out = freshFolder() / "o";
	const json summary = explored(out);
	EXPECT_TRUE(summary["exploration"]["complete"].get<bool>()) << summary["exploration"];
	EXPECT_EQ(summary["exploration"]["reason"], "nothing reachable left");
	EXPECT_GE(summary["truth"]["coverage"].get<double>(), 0.97);
	expectSafeAndHome(summary);
	for (const std::string& reason : reasonsIn(summary)) EXPECT_TRUE(kReasons.contains(reason)) << reason;

	const auto map = readMapFile(out / "map.ot");
	const octomap::OcTreeNode* start = map->search(1.6, 0.0, 0.3);
	ASSERT_NE(start, nullptr) << "the robot began there";
	EXPECT_FALSE(map->isNodeOccupied(start));
	EXPECT_EQ(readFile(out / "map.pgm").substr(0, 2), "P5");
	EXPECT_TRUE(fs::exists(out / "map.yaml"));

	EXPECT_THAT(openDoorsIn(out / "doors.geojson"),
	            testing::UnorderedElementsAre(near(1.55, 0.76), near(4.65, 0.76), near(3.75, -0.76)))
	    << "as the world's file has them";
}

TEST(Exploration, TheSameCommandGivesTheSameFrames)
{
	const auto folder = freshFolder();
	explored(folder / "a", {"--seed", "2"});
	explored(folder / "b", {"--seed", "2"});
	const std::string frames = readFile(folder / "a" / "frames.jsonl");
	EXPECT_GT(linesOf(frames).size(), 100U);
	EXPECT_TRUE(readFile(folder / "b" / "frames.jsonl") == frames);
	EXPECT_TRUE(readFile(folder / "b" / "map.ot") == readFile(folder / "a" / "map.ot"));
}

TEST(Exploration, KeepsInsideItsBoundsAndOutOfWhatIsForbidden)
{
	// The southern room is beyond the bounds, the eastern one in the north is forbidden.
	const auto out = freshFolder() / "o";
	const json summary = explored(out, {"--set", "bounds.enabled=true", "--set", "bounds.min_y=-0.6", "--set",
	                                    "bounds.keep_out=3.1 0.9, 6 0.9, 6 3.6, 3.1 3.6"});
	for (const Eigen::Vector2d& place : placesIn(out / "truth.tum"))
	{
		ASSERT_GE(place.y(), -0.6);
		ASSERT_FALSE(place.x() > 3.1 && place.y() > 0.9) << place.transpose();
	}
	EXPECT_TRUE(summary["exploration"]["complete"].get<bool>()) << summary["exploration"];
	EXPECT_GE(summary["truth"]["coverage"].get<double>(), 0.97) << "of where it may go";
	EXPECT_LT(summary["truth"]["reachable_m2"].get<double>(), 14.0) << "24 m2 without bounds";
	expectSafeAndHome(summary);
	EXPECT_THAT(reasonsIn(summary), testing::IsSupersetOf({"kept_out", "outside_bounds"}));
}

TEST(Exploration, IsHomeWhenItsTimeIsUp)
{
	constexpr double kTime_s = 40;
	const auto out = freshFolder() / "o";
	const json summary = explored(out, {"--set", "budget.time=40"});
	EXPECT_FALSE(summary["exploration"]["complete"].get<bool>());
	EXPECT_EQ(summary["exploration"]["reason"], "time budget");
	EXPECT_LE(summary["exploration"]["time_s"].get<double>(), kTime_s);
	EXPECT_GT(summary["truth"]["path_m"].get<double>(), 2.0) << "it went somewhere";
	expectSafeAndHome(summary);
}

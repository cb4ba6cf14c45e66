// Doors and corridors as lines in the map.
#include <explore/sinks/doors_geojson.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

using namespace explore;
using nlohmann::json;

namespace
{
DoorTrack confirmedDoor(int number, const DoorPlace& place)
{
	DoorTrack track;
	track.number = number;
	track.place = place;
	track.existence.confirmed = true;
	track.existence.hits = 7;
	return track;
}

/** Between these two points; which of them comes first means nothing. */
void expectLine(const json& feature, const std::pair<double, double>& first, const std::pair<double, double>& second)
{
	EXPECT_EQ(feature["type"], "Feature");
	EXPECT_EQ(feature["geometry"]["type"], "LineString");
	auto points = feature["geometry"]["coordinates"].get<std::vector<std::pair<double, double>>>();
	ASSERT_EQ(points.size(), 2U);
	std::ranges::sort(points);
	EXPECT_NEAR(points[0].first, first.first, 1e-6);
	EXPECT_NEAR(points[0].second, first.second, 1e-6);
	EXPECT_NEAR(points[1].first, second.first, 1e-6);
	EXPECT_NEAR(points[1].second, second.second, 1e-6);
}
}  // namespace

TEST(DoorsGeoJson, HasALineForEachConfirmedDoorAndCorridorAndNoOther)
{
	FrontierMemory memory{MemoryConfig{}, RobotConfig{}};
	// In a wall along x, seen from below: from jamb to jamb is along x.
	memory.doors.tracks.push_back(confirmedDoor(3, {{2.0, 1.0}, -std::numbers::pi / 2, 0.9, 0.0, 2.05}));
	memory.doors.tracks.push_back(confirmedDoor(5, {{-4.0, 0.5}, 0.0, 1.2, 0.0, std::nullopt}));
	memory.doors.tracks.back().visited = true;
	memory.doors.tracks.push_back(confirmedDoor(8, {{9.0, 9.0}, 0.0, 1.0}));
	memory.doors.tracks.back().existence.confirmed = false;
	CorridorTrack corridor;
	corridor.number = 2;
	corridor.point_in_map = {1.0, 0.0};
	corridor.direction_rad = std::numbers::pi / 2;
	corridor.from_m = -2.0;
	corridor.to_m = 6.0;
	corridor.width_m = 1.8;
	corridor.existence.confirmed = true;
	memory.corridors.tracks.push_back(corridor);

	const json all = json::parse(doorsGeoJson(memory));
	EXPECT_EQ(all["type"], "FeatureCollection");
	const json& features = all["features"];
	ASSERT_EQ(features.size(), 3U);
	expectLine(features[0], {1.55, 1.0}, {2.45, 1.0});
	EXPECT_EQ(features[0]["properties"]["kind"], "door");
	EXPECT_EQ(features[0]["properties"]["track"], 3);
	EXPECT_EQ(features[0]["properties"]["seen"], 7);
	EXPECT_DOUBLE_EQ(features[0]["properties"]["width"], 0.9);
	EXPECT_DOUBLE_EQ(features[0]["properties"]["height"], 2.05);
	EXPECT_EQ(features[0]["properties"]["visited"], false);
	expectLine(features[1], {-4.0, -0.1}, {-4.0, 1.1});
	EXPECT_TRUE(features[1]["properties"]["height"].is_null());
	EXPECT_EQ(features[1]["properties"]["visited"], true);
	expectLine(features[2], {1.0, -2.0}, {1.0, 6.0});
	EXPECT_EQ(features[2]["properties"]["kind"], "corridor");
	EXPECT_DOUBLE_EQ(features[2]["properties"]["width"], 1.8);
}

TEST(DoorsGeoJson, IsEmptyWhereNothingWasFound)
{
	const FrontierMemory memory{MemoryConfig{}, RobotConfig{}};
	EXPECT_EQ(json::parse(doorsGeoJson(memory))["features"], json::array());
}

// The labels of a world's author: in our plugin, and beside worlds of others.
#include "simulation/world_fixture.h"

#include <explore/core/errors.h>
#include <gmock/gmock.h>

using namespace explore::simulation::test;
using explore::InputError;
using explore::Verdict;
using explore::simulation::loadWorld;
using explore::simulation::World;
using testing::AllOf;
using testing::HasSubstr;

namespace
{
std::string labels(const std::string& content)
{
	return model("floor", visual("<plane><size>9 9</size></plane>")) +
	       "\n<plugin name='explore_labels' filename='explore_labels'>\n" + content + "\n</plugin>";
}

/** What is said of a world with that label, which stands in line 6 of test.sdf. */
std::string refusalOf(const std::string& label)
{
	return messageOf([&label] { worldOf(labels(label)); });
}

World worldBeside(const std::string& json)
{
	freshFolder();
	writeFile(testFolder() / "test.doors.json", json);
	return loadWorld(writeWorld(model("floor", visual("<plane><size>9 9</size></plane>"))), {});
}
}  // namespace

TEST(WorldLabels, AreReadFromThePlugin)
{
	const World world =
	    worldOf(labels("<door id='a' at='1 2' yaw='1.5707963267948966' width='0.9' height='2' depth='0.12'/>"
	                   "<door id='b' at='3 4 1' yaw='0' width='0.8' verdict='ajar' clear_width='0.4' sill='0.02'/>"
	                   "<door id='c' at='5 6' yaw='0' width='1' verdict='closed'/>"
	                   "<corridor id='hall' from='0 0' to='8 0' width='2'/>"
	                   "<obstacle kind='chair' at='1 1' radius='0.3' height='0.9'/>"
	                   "<spawn name='start' at='0 1' yaw='-1'/>"
	                   "<route name='tour' points='0 0; 1 0 0.5; 2 2'/>"));
	ASSERT_EQ(world.doors.size(), 3U);
	const auto& a = world.doors[0];
	EXPECT_EQ(a.id, "a");
	EXPECT_EQ(a.floor_center_in_map, Eigen::Vector3d(1, 2, 0));
	EXPECT_TRUE(a.normal_in_map.isApprox(Eigen::Vector3d::UnitY(), 1e-9));
	EXPECT_EQ(a.width_m, 0.9);
	EXPECT_EQ(a.height_m, 2.0);
	EXPECT_EQ(a.depth_m, 0.12);
	EXPECT_EQ(a.clear_width_m, 0.9);
	EXPECT_EQ(a.verdict, Verdict::open);
	const auto& b = world.doors[1];
	EXPECT_EQ(b.floor_center_in_map.z(), 1);
	EXPECT_FALSE(b.height_m.has_value());
	EXPECT_EQ(b.clear_width_m, 0.4);
	EXPECT_EQ(b.sill_m, 0.02);
	EXPECT_EQ(b.verdict, Verdict::ajar);
	EXPECT_EQ(world.doors[2].clear_width_m, 0);
	ASSERT_EQ(world.corridors.size(), 1U);
	EXPECT_EQ(world.corridors[0].end_in_map, Eigen::Vector2d(8, 0));
	EXPECT_EQ(world.corridors[0].width_m, 2);
	ASSERT_EQ(world.obstacles.size(), 1U);
	EXPECT_EQ(world.obstacles[0].kind, "chair");
	ASSERT_EQ(world.spawns.size(), 1U);
	EXPECT_EQ(world.spawns[0].yaw_rad, -1);
	ASSERT_EQ(world.routes.size(), 1U);
	EXPECT_EQ(world.routes[0].points_in_map[1], Eigen::Vector3d(1, 0, 0.5));
}

TEST(WorldLabels, ThingsMoveAlongTheirWaypoints)
{
	const World world =
	    worldOf(labels("<moving name='p' height='1.8'><waypoint t='0' at='0 0'/><waypoint t='4' at='4 0'/>"
	                   "<waypoint t='8' at='4 4'/></moving>"
	                   "<moving name='cart' kind='box' radius='0.5' height='1' loop='false' gap='0.2'>"
	                   "<waypoint t='0' at='1 1' yaw='2'/></moving>"));
	ASSERT_EQ(world.moving.size(), 2U);
	const auto& track = world.moving[0].track;
	// A person walks straight on, and turns to the next leg just before the corner.
	ASSERT_EQ(track.size(), 5U);
	EXPECT_NEAR(track[1].t_s, 3.6, 1e-9);
	EXPECT_TRUE(track[1].position_in_map.isApprox(Eigen::Vector2d(3.6, 0)));
	EXPECT_NEAR(track[1].yaw_rad, 0, 1e-9);
	EXPECT_NEAR(track[2].yaw_rad, std::acos(0.0), 1e-9);
	EXPECT_EQ(world.moving[0].kind, "person");
	EXPECT_TRUE(world.moving[0].loop);
	const auto& cart = world.moving[1];
	EXPECT_FALSE(cart.loop);
	EXPECT_EQ(cart.gap_m, 0.2);
	EXPECT_EQ(cart.track[0].yaw_rad, 2);
	for (const auto& vertex : cart.mesh.vertices)
	{
		EXPECT_NEAR(vertex.head<2>().norm(), 0.5, 1e-5);
		EXPECT_TRUE(vertex.z() == 0 || vertex.z() == 1);
	}
}

TEST(WorldLabels, MistakesAreRefusedWithTheirLine)
{
	for (const auto& [label, reason] : std::vector<std::pair<std::string, std::string>>{
	         {"<window id='a'/>", "not known"},
	         {"<door id='a' at='1 2' yaw='0'/>", "'width' is missing"},
	         {"<door at='1 2' yaw='0' width='1'/>", "'id' is missing"},
	         {"<door id='a' at='1' yaw='0' width='1'/>", "at is '1'; 'x y' or 'x y z'"},
	         {"<door id='a' at='1 nan' yaw='0' width='1'/>", "at is '1 nan'"},
	         {"<door id='a' at='1 2000' yaw='0' width='1'/>", "at most 1000 m"},
	         {"<door id='a' at='1 2' yaw='0' width='wide'/>", "width is 'wide'"},
	         {"<door id='a' at='1 2' yaw='0' width='-1'/>", "width is '-1'"},
	         {"<door id='a' at='1 2' yaw='0' width='1' clear_width='1.1'/>", "from 0 to 1"},
	         {"<door id='a' at='1 2' yaw='0' width='1' verdict='opne'/>", "one of open, ajar"},
	         {"<door id='a' at='1 2' yaw='0' width='1' heigth='2'/>", "'heigth' is not known"},
	         {"<corridor id='a' from='1 1' to='1 1' width='2'/>", "0.1 m"},
	         {"<route name='a' points='1 1'/>", "two or more points"},
	         {"<moving name='a'/>", "at least one <waypoint"},
	         {"<moving name='a' kind='cat'><waypoint t='0' at='0 0'/></moving>", "person, box or cylinder"},
	         {"<moving name='a'><waypoint t='1' at='0 0'/><waypoint t='1' at='1 0'/></moving>", "t is '1'"},
	         {"<moving name='a'><stop/></moving>", "<waypoint> is the only"},
	         {"<spawn name='a' at='0 0'/><spawn name='a' at='1 1'/>", "not taken yet"}})
	{
		EXPECT_THAT(refusalOf(label), AllOf(HasSubstr("test.sdf:6: <"), HasSubstr(reason))) << label;
		EXPECT_THROW(worldOf(labels(label)), InputError) << label;
	}
}

TEST(WorldLabels, BesideAForeignWorldAreJson)
{
	const World world = worldBeside(R"({
  "doors": [
    {"id": "front \"door\"", "at": [1, 2.5, 0], "yaw": 0, "width": 0.9, "height": null},
    {"id": "b", "at": [3, 4], "yaw": 1, "width": 8e-1, "height": 2.0, "verdict": "ajar", "clear_width": 0.3}
  ],
  "spawns": [{"name": "start", "at": [0, 0]}],
  "routes": [{"name": "tour", "points": [[0, 0], [1, 0, 0.5]]}],
  "obstacles": []
})");
	ASSERT_EQ(world.doors.size(), 2U);
	EXPECT_EQ(world.doors[0].id, "front \"door\"");
	EXPECT_EQ(world.doors[0].floor_center_in_map, Eigen::Vector3d(1, 2.5, 0));
	EXPECT_FALSE(world.doors[0].height_m.has_value());
	EXPECT_EQ(world.doors[1].width_m, 0.8);
	EXPECT_EQ(world.doors[1].verdict, Verdict::ajar);
	EXPECT_EQ(world.spawns.size(), 1U);
	ASSERT_EQ(world.routes.size(), 1U);
	EXPECT_EQ(world.routes[0].points_in_map[1], Eigen::Vector3d(1, 0, 0.5));
}

TEST(WorldLabels, BrokenJsonIsRefusedWithFileAndLine)
{
	const std::string door = R"({"id": "a", "at": [1, 2], "yaw": 0, "width": 0.9})";
	for (const std::string& json : std::vector<std::string>{
	         "\n{\"doors\": [" + door, "\n{\"doors\": [" + door + "]}}", "\n{\"doors\": [" + door + ",]}",
	         "\n{\"doors\": " + door + "}", "\n[" + door + "]", "\n{\"windows\": [" + door + "]}",
	         "\n{\"doors\": [{\"id\": \"a\", \"id\": \"b\"}]}", "\n{\"doors\": [{\"id\": \"a}]}", "\n",
	         "\n{\"doors\": [" + door + "," + door + "]}", "\n{\"doors\": [{\"id\": {}}]}"})
		EXPECT_THAT(messageOf([&json] { worldBeside(json); }), HasSubstr("test.doors.json:2: ")) << json;
}

TEST(WorldLabels, MayStandInAnotherFile)
{
	writeFile(freshFolder() / "other.json", R"({"doors": [{"id": "a", "at": [1, 2], "yaw": 0, "width": 0.9}]})");
	const auto path = writeWorld(model("m", visual(box("1 1 1"))));
	EXPECT_EQ(loadWorld(path, {{}, {}, testFolder() / "other.json"}).doors.size(), 1U);
	EXPECT_THAT(messageOf([&path] { loadWorld(path, {{}, {}, testFolder() / "none.json"}); }), HasSubstr("none.json"));
}

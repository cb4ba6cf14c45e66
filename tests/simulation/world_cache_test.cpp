// The cache of loaded worlds: equal to loading, never stale, never in the way.
#include "simulation/world_fixture.h"

#include <gmock/gmock.h>

#include <random>

using namespace explore::simulation::test;
using namespace explore::simulation;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
constexpr const char* kStl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid\n";

WorldPaths cachedPaths()
{
	return {{}, testFolder() / "cache", {}};
}

fs::path cacheFile()
{
	return *fs::directory_iterator(testFolder() / "cache");
}

/** A world with everything that a world can have: an included model, a mesh, labels, moving things and a warning. */
fs::path writeRichWorld(const std::string& size = "1 1 1")
{
	fs::create_directories(testFolder() / "crate");
	writeFile(testFolder() / "crate" / "model.sdf",
	          "<sdf version='1.6'>" + model("crate", visual(box(size))) + "</sdf>");
	writeFile(testFolder() / "a.stl", kStl);
	return writeWorld(
	    "<include><uri>model://crate</uri></include>" +
	    model("m", visual("<mesh><uri>a.stl</uri></mesh>", "", "glass")) + model("bad", visual("<cone/>")) +
	    "<plugin name='explore_labels' filename='explore_labels'>"
	    "<door id='a' at='1 2' yaw='1' width='0.9' height='2'/><door id='b' at='1 2' yaw='1' width='0.9'/>"
	    "<corridor id='h' from='0 0' to='5 0' width='2'/><obstacle kind='k' at='1 1' radius='1' height='1'/>"
	    "<spawn name='s' at='0 0'/><route name='r' points='0 0; 1 1'/>"
	    "<moving name='p'><waypoint t='0' at='0 0'/><waypoint t='3' at='3 1'/></moving></plugin>");
}

void expectEqual(const World& a, const World& b)
{
	EXPECT_EQ(a.name, b.name);
	EXPECT_EQ(a.warnings, b.warnings);
	EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
	EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
	EXPECT_EQ(a.body_of_triangle, b.body_of_triangle);
	ASSERT_EQ(a.bodies.size(), b.bodies.size());
	for (std::size_t i = 0; i < a.bodies.size(); ++i)
	{
		EXPECT_EQ(a.bodies[i].name, b.bodies[i].name);
		EXPECT_EQ(a.bodies[i].material, b.bodies[i].material);
	}
	ASSERT_EQ(a.materials.size(), b.materials.size());
	for (std::size_t i = 0; i < a.materials.size(); ++i)
	{
		EXPECT_EQ(a.materials[i].name, b.materials[i].name);
		EXPECT_EQ(a.materials[i].surface, b.materials[i].surface);
		EXPECT_EQ(a.materials[i].color, b.materials[i].color);
	}
	ASSERT_EQ(a.doors.size(), b.doors.size());
	for (std::size_t i = 0; i < a.doors.size(); ++i)
	{
		EXPECT_EQ(a.doors[i].id, b.doors[i].id);
		EXPECT_EQ(a.doors[i].normal_in_map, b.doors[i].normal_in_map);
		EXPECT_EQ(a.doors[i].height_m, b.doors[i].height_m);
		EXPECT_EQ(a.doors[i].clear_width_m, b.doors[i].clear_width_m);
	}
	ASSERT_EQ(a.moving.size(), b.moving.size());
	for (std::size_t i = 0; i < a.moving.size(); ++i)
	{
		EXPECT_EQ(a.moving[i].mesh.vertices, b.moving[i].mesh.vertices);
		ASSERT_EQ(a.moving[i].track.size(), b.moving[i].track.size());
		EXPECT_EQ(a.moving[i].track.back().position_in_map, b.moving[i].track.back().position_in_map);
		EXPECT_EQ(a.moving[i].loop, b.moving[i].loop);
	}
	ASSERT_EQ(a.routes.size(), b.routes.size());
	for (std::size_t i = 0; i < a.routes.size(); ++i) EXPECT_EQ(a.routes[i].points_in_map, b.routes[i].points_in_map);
	EXPECT_EQ(a.corridors.size(), b.corridors.size());
	EXPECT_EQ(a.obstacles.size(), b.obstacles.size());
	EXPECT_EQ(a.spawns.size(), b.spawns.size());
}
}  // namespace

TEST(WorldCache, GivesTheSameWorldAsLoading)
{
	freshFolder();
	const fs::path path = writeRichWorld();
	const World loaded = loadWorld(path, {});
	expectEqual(loadWorld(path, cachedPaths()), loaded);
	const auto written = fs::last_write_time(cacheFile());
	expectEqual(loadWorld(path, cachedPaths()), loaded);
	EXPECT_EQ(fs::last_write_time(cacheFile()), written);
}

TEST(WorldCache, IsReallyRead)
{
	freshFolder();
	const fs::path path = writeRichWorld();
	loadWorld(path, cachedPaths());
	const std::string cached = readFile(cacheFile());
	// Another world in the same place, whose cache is replaced by this one with files to match: what comes is the
	// cache.
	EXPECT_THAT(cached, HasSubstr("crate::l::v"));
	EXPECT_EQ(std::distance(fs::directory_iterator(testFolder() / "cache"), fs::directory_iterator()), 1);
	EXPECT_EQ(loadWorld(path, cachedPaths()).bodies.size(), 2U);
	EXPECT_EQ(readFile(cacheFile()), cached);
}

TEST(WorldCache, NoticesEveryChangeOfAFileInTheWorld)
{
	freshFolder();
	const fs::path path = writeRichWorld();
	EXPECT_FLOAT_EQ(boundsOf(loadWorld(path, cachedPaths()), "crate").sizes().x(), 1);
	writeRichWorld("3 3 3");  // an included model
	EXPECT_FLOAT_EQ(boundsOf(loadWorld(path, cachedPaths()), "crate").sizes().x(), 3);
	std::string stl = kStl;  // a mesh, of the same length
	stl.replace(stl.find("vertex 1 1 0"), 12, "vertex 1 7 0");
	writeFile(testFolder() / "a.stl", stl);
	EXPECT_FLOAT_EQ(boundsOf(loadWorld(path, cachedPaths()), "m").sizes().y(), 7);
	writeWorld(model("other", visual(box("1 1 1"))));  // the world itself
	EXPECT_TRUE(boundsOf(loadWorld(path, cachedPaths()), "crate").isEmpty());
}

TEST(WorldCache, NoticesChangesInWhatAMeshRefersTo)
{
	freshFolder();
	writeFile(testFolder() / "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl paint\nf 1 2 3\n");
	writeFile(testFolder() / "a.mtl", "newmtl paint\nKd 1 0 0\n");
	const fs::path path = writeWorld(model("m", visual("<mesh><uri>a.obj</uri></mesh>")));
	const auto color = [&path]
	{
		const World world = loadWorld(path, cachedPaths());
		return world.materials.at(world.bodies.at(0).material).color;
	};
	EXPECT_EQ(color(), Eigen::Vector3f(1, 0, 0));
	writeFile(testFolder() / "a.mtl", "newmtl paint\nKd 0 0 1\n");
	EXPECT_EQ(color(), Eigen::Vector3f(0, 0, 1));
}

TEST(WorldCache, NoticesFilesThatAppearOrGo)
{
	freshFolder();
	const fs::path path =
	    writeWorld(model("m", visual("<mesh><uri>late.stl</uri></mesh>")) + model("x", visual(box("1 1 1"))));
	EXPECT_TRUE(boundsOf(loadWorld(path, cachedPaths()), "m").isEmpty());
	writeFile(testFolder() / "late.stl", kStl);
	EXPECT_FALSE(boundsOf(loadWorld(path, cachedPaths()), "m").isEmpty());
	fs::remove(testFolder() / "late.stl");
	EXPECT_TRUE(boundsOf(loadWorld(path, cachedPaths()), "m").isEmpty());
}

TEST(WorldCache, LabelsBesideTheWorldAreAlwaysReadAnew)
{
	freshFolder();
	const fs::path path = writeWorld(model("x", visual(box("1 1 1"))));
	EXPECT_TRUE(loadWorld(path, cachedPaths()).doors.empty());
	writeFile(testFolder() / "test.doors.json", R"({"doors": [{"id": "a", "at": [1, 2], "yaw": 0, "width": 0.9}]})");
	EXPECT_EQ(loadWorld(path, cachedPaths()).doors.size(), 1U);
}

TEST(WorldCache, ADamagedFileIsIgnoredAndWrittenAgain)
{
	freshFolder();
	const fs::path path = writeRichWorld();
	const World loaded = loadWorld(path, cachedPaths());
	const std::string sound = readFile(cacheFile());
	std::mt19937_64 random(5);
	for (int round = 0; round < 60; ++round)
	{
		std::string damaged = sound;
		if (round < 20)
			damaged.resize(random() % sound.size());
		else
			damaged[random() % sound.size()] ^= static_cast<char>(1 + random() % 255);
		writeFile(cacheFile(), damaged);
		expectEqual(loadWorld(path, cachedPaths()), loaded);
		EXPECT_EQ(readFile(cacheFile()), sound) << round;
	}
}

TEST(WorldCache, ThatCannotBeWrittenDoesNotMatter)
{
	freshFolder();
	const fs::path path = writeRichWorld();
	writeFile(testFolder() / "file", "in the way");
	EXPECT_EQ(loadWorld(path, {{}, testFolder() / "file" / "cache", {}}).bodies.size(), 2U);
}

// Worlds made by others: geometry as libsdformat places it, and doors as rays measure them.
#include "simulation/world_fixture.h"

#include <explore/simulation/ray_scene.h>
#include <gmock/gmock.h>

#include <map>
#include <sdf/sdf.hh>

using namespace explore::simulation::test;
using namespace explore::simulation;
namespace fs = std::filesystem;

namespace
{
fs::path sharedWorlds()
{
	return fs::path(EXPLORE_SOURCE_DIR) / ".." / "shared" / "worlds";
}

WorldPaths sharedPaths()
{
	return {{sharedWorlds() / "osrf"}, {}, {}};
}

struct SharedWorld
{
	const char* path;
	std::size_t least_triangles;
	std::size_t warnings;
};

class SharedWorldTest : public testing::TestWithParam<SharedWorld>
{
protected:
	void SetUp() override
	{
		if (!fs::exists(path())) GTEST_SKIP() << "needs the worlds in ../shared/worlds";
	}
	static fs::path path() { return sharedWorlds() / GetParam().path; }
};

/** Where libsdformat puts the middle of every visual that is a box, cylinder or sphere, by name. */
std::map<std::string, Eigen::Vector3d> placesOf(const sdf::Model& model, const Eigen::Isometry3d& map_from_parent,
                                                const std::string& prefix)
{
	const auto resolved = [](const sdf::SemanticPose& semantic)
	{
		ignition::math::Pose3d pose;
		EXPECT_TRUE(semantic.Resolve(pose).empty());
		Eigen::Isometry3d isometry(Eigen::Translation3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()));
		isometry.rotate(Eigen::Quaterniond(pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()));
		return isometry;
	};
	const auto centred = [](const sdf::Visual& visual)
	{
		const sdf::GeometryType type = visual.Geom()->Type();
		return type == sdf::GeometryType::BOX || type == sdf::GeometryType::CYLINDER ||
		       type == sdf::GeometryType::SPHERE;
	};
	std::map<std::string, Eigen::Vector3d> places;
	const Eigen::Isometry3d map_from_model = map_from_parent * resolved(model.SemanticPose());
	for (std::uint64_t i = 0; i < model.LinkCount(); ++i)
	{
		const sdf::Link& link = *model.LinkByIndex(i);
		for (std::uint64_t k = 0; k < link.VisualCount(); ++k)
		{
			const sdf::Visual& visual = *link.VisualByIndex(k);
			if (!centred(visual)) continue;
			const std::string name = prefix + model.Name() + "::" + link.Name() + "::" + visual.Name();
			places[name] =
			    (map_from_model * resolved(link.SemanticPose()) * resolved(visual.SemanticPose())).translation();
		}
	}
	for (std::uint64_t i = 0; i < model.ModelCount(); ++i)
		places.merge(placesOf(*model.ModelByIndex(i), map_from_model, prefix + model.Name() + "::"));
	return places;
}

std::string findModel(const fs::path& world, const std::string& uri)
{
	std::string name = uri.substr(uri.find_last_of('/') + 1);
	for (const fs::path& folder : {world.parent_path().parent_path() / "models", sharedWorlds() / "osrf"})
		if (fs::exists(folder / name)) return (folder / name).string();
	return {};
}
}  // namespace

TEST_P(SharedWorldTest, LoadsWithItsGeometry)
{
	const World world = loadWorld(path(), sharedPaths());
	EXPECT_GE(world.mesh.triangles.size(), GetParam().least_triangles);
	EXPECT_EQ(world.warnings.size(), GetParam().warnings) << warningsOf(world);
	for (const Eigen::Vector3f& vertex : world.mesh.vertices) ASSERT_LT(vertex.cwiseAbs().maxCoeff(), 51);
}

/** Worlds of boxes without <state>, of which libsdformat knows nothing. */
class SharedBoxesTest : public SharedWorldTest
{
};

TEST_P(SharedBoxesTest, StandWhereLibsdformatPutsThem)
{
	const World world = loadWorld(path(), sharedPaths());
	sdf::Console::Instance()->SetQuiet(true);
	sdf::ParserConfig config;
	config.SetFindCallback([](const std::string& uri) { return findModel(path(), uri); });
	sdf::Root root;
	root.Load(path().string(), config);
	ASSERT_EQ(root.WorldCount(), 1U);
	std::size_t compared = 0;
	for (std::uint64_t i = 0; i < root.WorldByIndex(0)->ModelCount(); ++i)
		for (const auto& [name, middle_in_map] :
		     placesOf(*root.WorldByIndex(0)->ModelByIndex(i), Eigen::Isometry3d::Identity(), ""))
		{
			const auto bounds = boundsOf(world, name);
			ASSERT_FALSE(bounds.isEmpty()) << name;
			EXPECT_LT((bounds.center().cast<double>() - middle_in_map).norm(), 1e-4) << name;
			++compared;
		}
	EXPECT_GE(compared, 9U);
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedWorldTest,
    testing::Values(SharedWorld{"turtlebot3/turtlebot3_gazebo/worlds/turtlebot3_house.world", 14'000, 0},
                    SharedWorld{"turtlebot3/turtlebot3_gazebo/worlds/turtlebot3_world.world", 1'000, 0},
                    SharedWorld{"pal/worlds/home.world", 9'000, 4},
                    SharedWorld{"pal/worlds/tutorial_office.world", 40'000, 0},
                    SharedWorld{"pal/worlds/factory.world", 700, 0},
                    SharedWorld{"aws_small_warehouse/worlds/small_warehouse.world", 15'000, 0},
                    SharedWorld{"aws_small_warehouse/worlds/no_roof_small_warehouse.world", 13'000, 0}),
    [](const auto& world) { return fs::path(world.param.path).stem().string(); });
INSTANTIATE_TEST_SUITE_P(
    Some, SharedBoxesTest,
    testing::Values(SharedWorld{"turtlebot3/turtlebot3_gazebo/worlds/turtlebot3_house.world", 0, 0},
                    SharedWorld{"turtlebot3/turtlebot3_gazebo/worlds/turtlebot3_world.world", 0, 0},
                    SharedWorld{"pal/worlds/tutorial_office.world", 0, 0}),
    [](const auto& world) { return fs::path(world.param.path).stem().string(); });

TEST(SharedHouse, DoorsMeasureWhatTheirLabelsSay)
{
	const fs::path path = sharedWorlds() / "turtlebot3/turtlebot3_gazebo/worlds/turtlebot3_house.world";
	if (!fs::exists(path)) GTEST_SKIP() << "needs the worlds in ../shared/worlds";
	WorldPaths paths = sharedPaths();
	paths.labels_file = fs::path(EXPLORE_SOURCE_DIR) / "tests/simulation/turtlebot3_house.doors.json";
	const World world = loadWorld(path, paths);
	const RayScene scene(world);
	std::size_t doors = 0;
	for (const DoorLabel& door : world.doors)
	{
		const Eigen::Vector3d along = Eigen::Vector3d::UnitZ().cross(door.normal_in_map);
		for (const double height_m : {0.1, 1.0, 1.9})
		{
			const Eigen::Vector3d middle = door.floor_center_in_map + height_m * Eigen::Vector3d::UnitZ();
			const auto left = scene.cast(middle, along, 5), right = scene.cast(middle, -along, 5);
			ASSERT_TRUE(left && right) << door.id;
			EXPECT_NEAR(left->distance, door.width_m / 2, 0.002) << door.id;
			EXPECT_NEAR(right->distance, door.width_m / 2, 0.002) << door.id;
			if (door.width_m > 1) continue;
			EXPECT_NEAR(left->distance + right->distance, 0.900, 0.02) << door.id;
			++doors;
		}
		const auto lintel =
		    scene.cast(door.floor_center_in_map + Eigen::Vector3d(0, 0, 1), Eigen::Vector3d::UnitZ(), 5);
		ASSERT_TRUE(lintel) << door.id;
		EXPECT_NEAR(lintel->distance + 1, *door.height_m, 0.01) << door.id;
		// The robot can pass: nothing stands in the way for a metre on either side.
		EXPECT_FALSE(
		    scene.cast(door.floor_center_in_map - door.normal_in_map + Eigen::Vector3d(0, 0, 1), door.normal_in_map, 2))
		    << door.id;
	}
	EXPECT_EQ(doors, 4U * 3U);
}

/** A world of others with its labels: walls without lintels, so that widths and what is above can be measured. */
struct LabelledWorld
{
	const char* path;
	std::size_t doors;
};
class SharedPassages : public testing::TestWithParam<LabelledWorld>
{
};

TEST_P(SharedPassages, MeasureWhatTheirLabelsSay)
{
	const fs::path path = sharedWorlds() / GetParam().path;
	if (!fs::exists(path)) GTEST_SKIP() << "needs the worlds in ../shared/worlds";
	WorldPaths paths = sharedPaths();
	paths.labels_file = fs::path(EXPLORE_SOURCE_DIR) / "tests/simulation" / (path.stem().string() + ".doors.json");
	const World world = loadWorld(path, paths);
	const RayScene scene(world);
	EXPECT_EQ(world.doors.size(), GetParam().doors);
	for (const DoorLabel& door : world.doors)
	{
		const Eigen::Vector3d along = Eigen::Vector3d::UnitZ().cross(door.normal_in_map);
		for (const double height_m : {0.1, 1.0, 1.9})
		{
			const Eigen::Vector3d middle = door.floor_center_in_map + height_m * Eigen::Vector3d::UnitZ();
			for (const double side : {1.0, -1.0})
			{
				const auto jamb = scene.cast(middle, side * along, 10);
				ASSERT_TRUE(jamb) << door.id;
				EXPECT_NEAR(jamb->distance, 0.5 * door.width_m, 0.005) << door.id;
			}
			EXPECT_FALSE(scene.cast(middle - door.normal_in_map, door.normal_in_map, 2)) << door.id;
		}
		EXPECT_FALSE(scene.cast(door.floor_center_in_map + Eigen::Vector3d(0, 0, 1), Eigen::Vector3d::UnitZ(), 5))
		    << door.id << " has a lintel";
	}
}

INSTANTIATE_TEST_SUITE_P(Pal, SharedPassages,
                         testing::Values(LabelledWorld{"pal/worlds/home.world", 5},
                                         LabelledWorld{"pal/worlds/tutorial_office.world", 1},
                                         LabelledWorld{"pal/worlds/factory.world", 2}),
                         [](const auto& world) { return fs::path(world.param.path).stem().string(); });

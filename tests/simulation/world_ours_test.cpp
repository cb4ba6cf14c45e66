// Our own worlds: sound SDF, closed to outdoors, and labelled with what rays measure.
#include "simulation/world_fixture.h"

#include <explore/simulation/ray_scene.h>
#include <gmock/gmock.h>

#include <numbers>
#include <random>
#include <sdf/sdf.hh>

using namespace explore::simulation::test;
using namespace explore::simulation;
using explore::Verdict;
using testing::IsEmpty;
namespace fs = std::filesystem;

namespace
{
const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

fs::path worldPath(const std::string& name)
{
	return fs::path(EXPLORE_SOURCE_DIR) / "rawlogs" / "worlds" / (name + ".sdf");
}

class OurWorldTest : public testing::TestWithParam<const char*>
{
protected:
	OurWorldTest() : m_world(loadWorld(worldPath(GetParam()), {})), m_scene(m_world)
	{
		// Nobody stands in a doorway while it is measured.
		const Eigen::Isometry3d away(Eigen::Translation3d(0, 0, -500));
		m_scene.place(std::vector<Eigen::Isometry3d>(m_world.moving.size(), away));
	}

	/** Distance along `direction` to the first surface; 100 m where there is none. */
	[[nodiscard]] double distance(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const
	{
		const auto hit = m_scene.cast(from, direction, 100);
		return hit ? hit->distance : 100;
	}

	World m_world;
	RayScene m_scene;
};

/** The height at which nothing but jambs and leaf is in an opening. */
Eigen::Vector3d middleOf(const DoorLabel& door)
{
	return door.floor_center_in_map + (door.sill_m + 0.5 * (door.height_m.value_or(2.0) - door.sill_m)) * kUp;
}

Eigen::Vector3d alongWall(const DoorLabel& door)
{
	return kUp.cross(door.normal_in_map);
}
}  // namespace

TEST_P(OurWorldTest, IsStandardSdfWithoutAnyTrouble)
{
	EXPECT_THAT(m_world.warnings, IsEmpty());
	sdf::Console::Instance()->SetQuiet(true);
	sdf::ParserConfig config;
	config.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
	config.SetFindCallback(
	    [](const std::string& uri)
	    { return (worldPath("").parent_path() / "models" / uri.substr(uri.find_last_of('/') + 1)).string(); });
	sdf::Root root;
	for (const sdf::Error& error : root.Load(worldPath(GetParam()).string(), config)) ADD_FAILURE() << error.Message();
	ASSERT_EQ(root.WorldCount(), 1U);
	EXPECT_GT(root.WorldByIndex(0)->ModelCount(), 10U);
}

TEST_P(OurWorldTest, IsClosedToOutdoors)
{
	std::mt19937_64 random(11);
	const auto uniform = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
	std::vector<Eigen::Vector3d> places;
	for (const Spawn& spawn : m_world.spawns) places.push_back(spawn.position_in_map);
	for (const Route& route : m_world.routes)
		places.insert(places.end(), route.points_in_map.begin(), route.points_in_map.end());
	for (const Eigen::Vector3d& place : places)
		for (int i = 0; i < 500; ++i)
		{
			const double z = 2 * uniform() - 1, azimuth = 2 * std::numbers::pi * uniform(), r = std::sqrt(1 - z * z);
			const Eigen::Vector3d direction(r * std::cos(azimuth), r * std::sin(azimuth), z);
			ASSERT_LT(distance(Eigen::Vector3d(place.x(), place.y(), 1.1), direction), 50) << place.transpose();
		}
}

TEST_P(OurWorldTest, OpeningsHaveTheWidthAndHeightOfTheirLabels)
{
	for (const DoorLabel& door : m_world.doors)
	{
		if (door.clear_width_m == 0 && door.verdict != Verdict::drop) continue;  // something fills it
		const Eigen::Vector3d along = alongWall(door), middle = middleOf(door);
		EXPECT_NEAR(distance(middle, along), door.width_m / 2, 0.01) << door.id;
		EXPECT_NEAR(distance(middle, -along), door.width_m / 2, 0.01) << door.id;
		const double lintel_m = middle.z() + distance(middle, kUp), floor_m = middle.z() - distance(middle, -kUp);
		const double expected_m = door.height_m ? door.floor_center_in_map.z() + *door.height_m : lintel_m;
		EXPECT_NEAR(lintel_m, expected_m, 0.01) << door.id;
		const bool box_in_it = door.verdict == Verdict::blocked && door.sill_m == 0;
		EXPECT_NEAR(floor_m, box_in_it ? floor_m : door.sill_m, 0.01) << door.id;
	}
}

TEST_P(OurWorldTest, WallsAreAsThickAsTheLabelsSay)
{
	for (const DoorLabel& door : m_world.doors)
	{
		// A leaf or a curtain may lie before one side of the wall, hence the thinner of both.
		const Eigen::Vector3d step = 0.4 * door.normal_in_map;
		double thinnest_m = 100;
		for (const double side : {-1.0, 1.0})
		{
			const Eigen::Vector3d beside = middleOf(door) + side * (door.width_m / 2 + 0.08) * alongWall(door);
			const double before_m = distance(beside + step, -door.normal_in_map);
			thinnest_m = std::min(thinnest_m, 0.8 - before_m - distance(beside - step, door.normal_in_map));
		}
		EXPECT_NEAR(thinnest_m, door.depth_m, 0.005) << door.id;
	}
}

TEST_P(OurWorldTest, ClearWidthIsWhatRaysFindFree)
{
	constexpr double kStep_m = 0.005, kReach_m = 1.05;
	for (const DoorLabel& door : m_world.doors)
	{
		if (door.verdict == Verdict::drop)
		{
			EXPECT_GT(distance(door.floor_center_in_map + door.normal_in_map + kUp, -kUp), 1.15) << door.id;
			continue;
		}
		double widest_m = 0, run_m = 0;
		for (double offset_m = -door.width_m / 2 + kStep_m / 2; offset_m < door.width_m / 2; offset_m += kStep_m)
		{
			bool free = true;
			for (const double height_m : {0.06, 0.3, 0.6, 1.0, 1.5, 1.8})
			{
				if (height_m < door.sill_m) continue;
				const Eigen::Vector3d beside = door.floor_center_in_map + offset_m * alongWall(door) + height_m * kUp;
				free = free && distance(beside - kReach_m * door.normal_in_map, door.normal_in_map) > 2 * kReach_m;
			}
			run_m = free ? run_m + kStep_m : 0;
			widest_m = std::max(widest_m, run_m);
		}
		EXPECT_NEAR(widest_m, door.clear_width_m, 0.02) << door.id;
	}
}

TEST_P(OurWorldTest, SpawnsAndRoutesKeepTheRobotsClearance)
{
	// Radii of the ground robot and the MAV of doc/definitions.md and 5 cm more.
	const auto touches = [this](const Eigen::Vector3d& place)
	{
		if (place.z() > 0) return m_scene.touchesCylinder(place - 0.175 * kUp, 0.35, 0.35);
		return m_scene.touchesCylinder(place + 0.05 * kUp, 0.27, 0.55);
	};
	EXPECT_GE(m_world.spawns.size(), 3U);
	for (const Spawn& spawn : m_world.spawns) EXPECT_FALSE(touches(spawn.position_in_map)) << spawn.name;
	for (const Route& route : m_world.routes)
		for (std::size_t i = 1; i < route.points_in_map.size(); ++i)
		{
			const Eigen::Vector3d from = route.points_in_map[i - 1], leg = route.points_in_map[i] - from;
			for (double along = 0; along <= 1; along += 0.05 / leg.norm())
				ASSERT_FALSE(touches(from + along * leg)) << route.name << " at " << (from + along * leg).transpose();
		}
}

TEST_P(OurWorldTest, NobodyStandsWhereARobotStarts)
{
	// The larger robot, the MAV, and the clearance of doc/definitions.md.
	constexpr double kRadius_m = 0.30, kClearance_m = 0.05;
	for (const Spawn& spawn : m_world.spawns)
		for (const MovingBody& body : m_world.moving)
			EXPECT_GE((body.track.front().position_in_map - spawn.position_in_map.head<2>()).norm(),
			          kRadius_m + body.radius_m + kClearance_m)
			    << body.name << " at " << spawn.name;
}

TEST_P(OurWorldTest, PeopleWalkFreely)
{
	for (const MovingBody& body : m_world.moving)
		for (std::size_t i = 1; i < body.track.size(); ++i)
		{
			const Eigen::Vector2d from = body.track[i - 1].position_in_map, leg = body.track[i].position_in_map - from;
			for (double along = 0; along <= 1; along += 0.02)
			{
				const Eigen::Vector2d place = from + along * leg;
				ASSERT_FALSE(m_scene.touchesCylinder({place.x(), place.y(), 0.05}, body.radius_m, body.height_m - 0.05))
				    << body.name << " at " << place.transpose();
			}
		}
}

INSTANTIATE_TEST_SUITE_P(Worlds, OurWorldTest, testing::Values("corridor", "office", "warehouse", "door_gallery"),
                         [](const auto& world) { return std::string(world.param); });

TEST(OurWorlds, TheGalleryShowsEveryVerdictThatALabelCanHave)
{
	const World world = loadWorld(worldPath("door_gallery"), {});
	for (const Verdict verdict : {Verdict::open, Verdict::ajar, Verdict::closed, Verdict::blocked, Verdict::passage,
	                              Verdict::drop, Verdict::unknown})
		EXPECT_TRUE(std::any_of(world.doors.begin(), world.doors.end(),
		                        [verdict](const DoorLabel& door) { return door.verdict == verdict; }))
		    << nameOf(verdict);
	for (const Surface surface : {Surface::glass, Surface::mirror, Surface::black})
		EXPECT_TRUE(std::any_of(world.materials.begin(), world.materials.end(),
		                        [surface](const Material& material) { return material.surface == surface; }));
}

TEST(OurWorlds, TheOfficeHasAtLeastTwelveDoorsToRoomsAndPeople)
{
	const World world = loadWorld(worldPath("office"), {});
	EXPECT_GE(world.doors.size(), 12U);
	EXPECT_GE(world.moving.size(), 2U);
}

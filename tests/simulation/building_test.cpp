// Made-up buildings: what the loader and the truth say of their doors, against the plan's own numbers and against
// bodies that are pushed through.
#include "support/building.h"

#include <explore/core/geometry.h>
#include <explore/simulation/load_world.h>
#include <explore/simulation/truth_rays.h>
#include <gmock/gmock.h>

#include <deque>
#include <numbers>
#include <set>

#include "support/test_files.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{
/** A building as it was planned and as the project reads it. */
class BuildingTest : public testing::TestWithParam<const char*>
{
protected:
	BuildingTest() : m_building(makeBuilding(GetParam(), 7)), m_world(load(m_building)), m_scene(m_world) {}

	static World load(const Building& building)
	{
		const std::filesystem::path folder = freshFolder();
		building.sketch.write(folder);
		return loadWorld(folder / "building.sdf", {});
	}
	[[nodiscard]] const DoorLabel& labelOf(const std::string& id) const
	{
		const auto found = std::find_if(m_world.doors.begin(), m_world.doors.end(),
		                                [&](const DoorLabel& door) { return door.id == id; });
		EXPECT_NE(found, m_world.doors.end()) << id;
		return found == m_world.doors.end() ? m_world.doors.front() : *found;
	}
	/** Calls `look` with wall and opening of every door. */
	template <class Look>
	void forEachDoor(const Look& look) const
	{
		for (const BuildingWall& wall : m_building.plan.walls)
			for (const Opening& opening : wall.openings)
				if (opening.filling != Filling::window && opening.filling != Filling::niche) look(wall, opening);
	}

	Building m_building;
	World m_world;
	RayScene m_scene;
};

bool isShut(const Opening& opening)
{
	const bool hinged = opening.filling == Filling::leaf || opening.filling == Filling::two_leaves ||
	                    opening.filling == Filling::fixed_leaf;
	const bool sliding = opening.filling == Filling::sliding_face || opening.filling == Filling::sliding_wall;
	return (hinged && opening.angle_rad == 0) || (sliding && opening.slid_m == 0);
}

bool isBarred(const Opening& opening)
{
	return opening.filling == Filling::curtain || opening.filling == Filling::person ||
	       opening.filling == Filling::boxes || opening.filling == Filling::counter;
}

/** A bolted leaf takes half of the opening; the other half is the door. */
struct Planned
{
	Vector2d middle_in_map;
	double width_m;
};
Planned plannedOf(const Building& building, const BuildingWall& wall, const Opening& opening)
{
	const bool half = opening.filling == Filling::fixed_leaf;
	const double shift = half ? (opening.hinge_left ? -0.25 : 0.25) * opening.width_m : 0.0;
	return {building.sketch.inMap(wall.frame.start.at({opening.middle_m + shift, 0})),
	        half ? 0.5 * opening.width_m : opening.width_m};
}

/** Whether an upright disc gets from one side of the door to the other, on a grid around it. */
class DiscWay
{
public:
	DiscWay(const RayScene& scene, const DoorLabel& door, double radius_m)
	    : m_scene(scene), m_door(door), m_radius_m(radius_m)
	{
	}
	[[nodiscard]] bool exists()
	{
		for (int u = -kAcross; u <= kAcross; ++u) visit({u, -kDeep});
		while (!m_open.empty())
		{
			const auto [u, v] = m_open.front();
			m_open.pop_front();
			if (v == kDeep) return true;
			for (const Cell& next : {Cell(u + 1, v), Cell(u - 1, v), Cell(u, v + 1), Cell(u, v - 1)}) visit(next);
		}
		return false;
	}

private:
	using Cell = std::pair<int, int>;
	static constexpr double kCell_m = 0.02;
	static constexpr int kAcross = 70, kDeep = 40;

	void visit(const Cell& cell)
	{
		if (std::abs(cell.first) > kAcross || std::abs(cell.second) > kDeep || !m_seen.insert(cell).second) return;
		const double u = cell.first * kCell_m, v = cell.second * kCell_m;
		if (std::abs(v) < 0.5 * m_door.depth_m && std::abs(u) > 0.5 * m_door.width_m) return;
		const Vector3d left = Vector3d::UnitZ().cross(m_door.normal_in_map);
		const Vector3d base = m_door.floor_center_in_map + u * left + v * m_door.normal_in_map + Vector3d(0, 0, 0.16);
		if (!m_scene.touchesCylinder(base, m_radius_m, 0.5)) m_open.push_back(cell);
	}

	const RayScene& m_scene;
	const DoorLabel& m_door;
	double m_radius_m;
	std::set<Cell> m_seen;
	std::deque<Cell> m_open;
};
}  // namespace

TEST_P(BuildingTest, IsReadWithoutAnyTrouble)
{
	EXPECT_THAT(m_world.warnings, testing::IsEmpty());
	std::size_t doors = 0;
	forEachDoor([&](const BuildingWall&, const Opening&) { ++doors; });
	EXPECT_EQ(m_world.doors.size(), doors);
	EXPECT_GE(doors, 8U);
}

TEST_P(BuildingTest, DoorsAreWhereThePlanHasThem)
{
	forEachDoor(
	    [&](const BuildingWall& wall, const Opening& opening)
	    {
		    const DoorLabel& label = labelOf(opening.id);
		    const Planned planned = plannedOf(m_building, wall, opening);
		    EXPECT_LT((label.floor_center_in_map.head<2>() - planned.middle_in_map).norm(), 1e-6) << opening.id;
		    EXPECT_NEAR(label.width_m, planned.width_m, 1e-6) << opening.id;
		    EXPECT_NEAR(label.depth_m, wall.frame.thickness_m, 1e-6) << opening.id;
		    const Vector2d along =
		        m_building.sketch.inMap(wall.frame.start.at({1, 0})) - m_building.sketch.inMap(wall.frame.start.origin);
		    EXPECT_NEAR(label.normal_in_map.head<2>().dot(along), 0, 1e-6) << opening.id;
		    EXPECT_EQ(label.height_m.has_value(), opening.high_m < wall.frame.height_m - 0.01) << opening.id;
		    EXPECT_EQ(label.verdict == Verdict::closed, isShut(opening)) << opening.id;
		    EXPECT_EQ(label.verdict == Verdict::blocked, isBarred(opening)) << opening.id;
	    });
}

/** Rays across the opening at the height of a knee, within the wall where no leaf of an empty doorway is. */
TEST_P(BuildingTest, EmptyOpeningsMeasureWhatTheirLabelsSay)
{
	int measured = 0;
	forEachDoor(
	    [&](const BuildingWall& wall, const Opening& opening)
	    {
		    if (opening.filling != Filling::none) return;
		    const DoorLabel& door = labelOf(opening.id);
		    const Vector3d left = Vector3d::UnitZ().cross(door.normal_in_map);
		    // Off the middle, where the rooms' slabs meet.
		    const Vector3d middle = door.floor_center_in_map + Vector3d(0, 0, 1.0) + 0.01 * door.normal_in_map;
		    for (const double side : {-1.0, 1.0})
		    {
			    const auto jamb = m_scene.cast(middle, side * left, 10);
			    ASSERT_TRUE(jamb) << door.id;
			    EXPECT_NEAR(jamb->distance, 0.5 * door.width_m, 1e-4) << door.id;
		    }
		    const auto head = m_scene.cast(middle, Vector3d::UnitZ(), 20),
		               floor = m_scene.cast(middle, -Vector3d::UnitZ(), 20);
		    ASSERT_TRUE(head && floor) << door.id;
		    const double head_m = 1.0 + head->distance;
		    EXPECT_NEAR(head_m, door.height_m.value_or(head_m), 0.005) << door.id;
		    EXPECT_NEAR(1.0 - floor->distance, door.sill_m, 1e-4) << door.id;
		    EXPECT_NEAR(door.clear_width_m, door.width_m, 1e-6) << wall.length_m;
		    ++measured;
	    });
	EXPECT_GE(measured, 1);
}

TEST_P(BuildingTest, DiscsOfTheClearWidthGetThroughAndLargerOnesDoNot)
{
	constexpr double kGrid_m = 0.02;
	int measured = 0;
	for (const DoorLabel& door : m_world.doors)
	{
		const bool free =
		    door.verdict == Verdict::open || door.verdict == Verdict::ajar || door.verdict == Verdict::passage;
		if (!free || door.width_m > 1.3 || door.sill_m > 0.1) continue;
		const bool measurable = door.clear_width_m > 2 * kGrid_m + 0.06;
		EXPECT_TRUE(!measurable || DiscWay(m_scene, door, 0.5 * door.clear_width_m - kGrid_m).exists()) << door.id;
		EXPECT_FALSE(DiscWay(m_scene, door, 0.5 * door.clear_width_m + 0.01).exists()) << door.id;
		++measured;
	}
	EXPECT_GE(measured, 4);
}

TEST_P(BuildingTest, TheTruthBeforeADoorIsThePlans)
{
	TruthCamera camera;
	camera.intrinsics = {640, 480, 540, 540, 319.5, 239.5};
	camera.robot_from_camera = mrpt::poses::CPose3D(0, 0, 0.8, 0, 0, 0);
	RobotConfig robot;  // of 0.22 m radius and 0.60 m height
	int visible = 0;
	forEachDoor(
	    [&](const BuildingWall& wall, const Opening& opening)
	    {
		    const Planned planned = plannedOf(m_building, wall, opening);
		    const Vector3d normal = labelOf(opening.id).normal_in_map;
		    for (const double side : {-1.0, 1.0})
		    {
			    const Vector2d at = planned.middle_in_map + side * 2.4 * normal.head<2>();
			    const double yaw = std::atan2(-side * normal.y(), -side * normal.x());
			    const TruthFrame frame = truthAt(m_scene, camera, robot, {at.x(), at.y(), 0, yaw, 0, 0});
			    const auto door = std::find_if(frame.doors.begin(), frame.doors.end(),
			                                   [&](const TruthDoor& one) { return one.id == opening.id; });
			    ASSERT_NE(door, frame.doors.end()) << opening.id;
			    EXPECT_LT((door->center_in_map.head<2>() - planned.middle_in_map).norm(), 1e-6) << opening.id;
			    EXPECT_NEAR(door->width_m, planned.width_m, 1e-6) << opening.id;
			    const double clear = isShut(opening) || opening.filling == Filling::curtain ? 0.0 : door->clear_width_m;
			    EXPECT_EQ(door->clear_width_m, clear) << opening.id;
			    const bool fits = clear >= 0.54 && opening.low_m <= 0.05 && opening.high_m >= 0.65;
			    EXPECT_EQ(door->passable, fits && !isBarred(opening) && !opening.drop) << opening.id;
			    visible += door->visibility == Visibility::visible ? 1 : 0;
		    }
	    });
	EXPECT_GE(visible, 5);
}

INSTANTIATE_TEST_SUITE_P(Kinds, BuildingTest, testing::Values("house", "office"),
                         [](const auto& kind) { return std::string(kind.param); });

TEST(Buildings, AreTheSameForTheSameSeed)
{
	const std::filesystem::path folder = freshFolder();
	for (const char* kind : {"house", "hotel"})
	{
		for (const char* name : {"a", "b"})
		{
			std::filesystem::create_directories(folder / name);
			makeBuilding(kind, 3).sketch.write(folder / name);
		}
		for (const char* file : {"building.sdf", "building.doors.json"})
			EXPECT_TRUE(readFile(folder / "a" / file) == readFile(folder / "b" / file)) << kind;
	}
	makeBuilding("house", 4).sketch.write(folder / "b");
	EXPECT_FALSE(readFile(folder / "a" / "building.sdf") == readFile(folder / "b" / "building.sdf"));
}

TEST(Buildings, OfEveryKindAreRead)
{
	for (const std::string_view kind : kBuildingKinds)
	{
		const Building building = makeBuilding(kind, 11);
		const std::filesystem::path folder = freshFolder();
		building.sketch.write(folder);
		const World world = loadWorld(folder / "building.sdf", {});
		EXPECT_THAT(world.warnings, testing::IsEmpty()) << kind;
		EXPECT_EQ(world.doors.size(), building.sketch.doors.size()) << kind;
		EXPECT_GE(world.doors.size(), 8U) << kind;
	}
}

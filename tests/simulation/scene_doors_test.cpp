// Clear widths of doorways with leaves, against a body that is moved through in every way.
#include <explore/core/geometry.h>
#include <explore/simulation/scenes/scene_doors.h>

#include <gmock/gmock.h>

#include "scene_support.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;

namespace
{
/** A wall along x with the door in its middle, and nothing else. */
World wallWith(const DoorPlan& door, double thickness_m)
{
	Sketch sketch({}, depthCamera("xtion").intrinsics, 1);
	sketch.style.wall_thickness_m = thickness_m;
	sketch.style.casing_depth_m = sketch.style.skirting_depth_m = 0;
	WallPlan wall = plainWall(sketch, WallFrame{}, {-4, 4});
	wall.openings.push_back(openingOf(door, wall));
	buildWall(sketch, wall);
	buildDoor(sketch, wall, door);
	return std::move(sketch.world);
}

bool discPasses(const RayScene& scene, double radius_m)
{
	constexpr double kStep_m = 0.025;
	const Pusher below_the_handle{radius_m, 0.05, 0.8};
	const auto inside = [](const Eigen::Vector2d& p) { return std::abs(p.x()) < 2.2 && std::abs(p.y()) < 2.2; };
	return reaches(scene, below_the_handle, {0, -1.9}, kStep_m, inside,
	               [](const Eigen::Vector2d& p) { return p.y() > 2.0; });
}

DoorPlan randomDoor(Random& random)
{
	DoorPlan door;
	door.width_m = random.uniform(0.7, 1.3);
	door.leaf.kind = LeafKind::hinged;
	door.leaf.angle_rad = kDegree_rad * random.uniform(18, 115);
	door.leaf.hinge_low = random.chance(0.5);
	door.leaf.toward_robot = random.chance(0.5);
	return door;
}
}  // namespace

TEST(SceneDoors, TheLabelledClearWidthIsWhatADiscGetsThrough)
{
	Random random(17);
	for (int i = 0; i < 14; ++i)
	{
		const DoorPlan door = randomDoor(random);
		const World world = wallWith(door, random.uniform(0.08, 0.25));
		const RayScene scene(world);
		const double clear_m = world.doors.front().clear_width_m;
		SCOPED_TRACE(testing::Message() << door.width_m << " m, " << door.leaf.angle_rad / kDegree_rad << " degrees, "
		                                << (door.leaf.toward_robot ? "toward" : "away") << ", clear " << clear_m);
		EXPECT_TRUE(discPasses(scene, 0.5 * clear_m - 0.03));
		EXPECT_FALSE(discPasses(scene, 0.5 * clear_m + 0.01));
	}
}

TEST(SceneDoors, WithoutALeafTheWholeWidthIsClear)
{
	DoorPlan door;
	door.width_m = 0.83;
	const World world = wallWith(door, 0.1);
	EXPECT_DOUBLE_EQ(world.doors.front().clear_width_m, 0.83);
	EXPECT_TRUE(discPasses(RayScene(world), 0.40));
	EXPECT_FALSE(discPasses(RayScene(world), 0.42));
}

TEST(SceneDoors, ALeafIsAtItsAngleFromTheWall)
{
	DoorPlan door;
	door.width_m = 0.9;
	door.leaf = {LeafKind::hinged, 30 * kDegree_rad, true, false, 0};
	const Outline leaf = leafOutline(door, 0.1);
	ASSERT_EQ(leaf.size(), 4U);
	// From the hinge at (−0.45, 0.1), 30° off the wall, away from the robot.
	EXPECT_NEAR((leaf[0] - Eigen::Vector2d(-0.45, 0.1)).norm(), 0, 1e-9);
	const Eigen::Vector2d edge = leaf[1] - leaf[0];
	EXPECT_NEAR(std::atan2(edge.y(), edge.x()), 30 * kDegree_rad, 1e-9);
	EXPECT_NEAR(edge.norm(), 0.9, 0.015);
	EXPECT_NEAR(clearWidth(door, 0.1), 2 * 0.9 * std::sin(15 * kDegree_rad), 0.02);
}

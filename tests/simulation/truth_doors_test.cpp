// Which doors a camera truly sees, against plain geometry.
#include <explore/simulation/door_passage.h>
#include <explore/simulation/random.h>
#include <explore/simulation/truth_rays.h>

#include <gmock/gmock.h>

#include <cmath>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using mrpt::poses::CPose3D;

namespace
{
RobotConfig robotOf(RobotKind kind, double radius_m, double height_m)
{
	RobotConfig robot;
	robot.kind = kind;
	robot.radius_m = radius_m;
	robot.height_m = height_m;
	return robot;
}

TruthFrame lookAt(const World& world, const CPose3D& map_from_robot = {}, const TruthCamera& camera = wideCamera())
{
	const RayScene scene(world);
	return truthAt(scene, camera, {}, map_from_robot);
}

TruthDoor onlyDoor(const TruthFrame& frame)
{
	EXPECT_EQ(frame.doors.size(), 1U);
	return frame.doors.empty() ? TruthDoor{} : frame.doors.front();
}
}  // namespace

TEST(TruthDoors, AnOpenDoorStraightAheadIsVisibleAsItsLabelSays)
{
	const TruthDoor door = onlyDoor(lookAt(worldWith({})));
	EXPECT_EQ(door.id, "door");
	EXPECT_EQ(door.visibility, Visibility::visible);
	EXPECT_DOUBLE_EQ(door.visible_share, 1.0);
	EXPECT_DOUBLE_EQ(door.jamb_share[0], 1.0);
	EXPECT_DOUBLE_EQ(door.jamb_share[1], 1.0);
	EXPECT_TRUE(door.lintel_in_view);
	EXPECT_TRUE(door.passable);
	EXPECT_LT((door.center_in_map - Vector3d(3.05, 0.0, 1.0)).norm(), 1e-9);
	EXPECT_LT((door.normal_in_map + Vector3d::UnitX()).norm(), 1e-9);
	EXPECT_DOUBLE_EQ(door.width_m, 0.9);
	EXPECT_DOUBLE_EQ(door.height_m.value_or(0), 2.0);
}

TEST(TruthDoors, CountsOnlyWhatIsInTheImage)
{
	// The image ends 36.87° up: (1.2 − 0.02) m ahead it shows 0.5 + 0.75 · 1.18 = 1.385 m of the door's 2 m.
	const TruthDoor near = onlyDoor(lookAt(worldWith({.face_x = 1.2})));
	EXPECT_NEAR(near.visible_share, 1.385 / 2.0, 0.05);
	EXPECT_NEAR(near.jamb_share[0], 1.385 / 2.0, 0.03);
	EXPECT_EQ(near.visibility, Visibility::visible);
	EXPECT_FALSE(near.lintel_in_view);

	// 0.75 · 0.53 + 0.5 = 0.9 m: less than half.
	const TruthDoor nearer = onlyDoor(lookAt(worldWith({.face_x = 0.55})));
	EXPECT_NEAR(nearer.visible_share, 0.45, 0.05);
	EXPECT_EQ(nearer.visibility, Visibility::ignored);
}

TEST(TruthDoors, BothJambsMustBeWithinFiveMetres)
{
	// The jambs are at y = ±0.45: 4.93 m ahead they are 4.95 m away.
	EXPECT_EQ(onlyDoor(lookAt(worldWith({.face_x = 4.95}))).visibility, Visibility::visible);
	EXPECT_EQ(onlyDoor(lookAt(worldWith({.face_x = 5.01}))).visibility, Visibility::ignored);
}

TEST(TruthDoors, IsIgnoredWithOneJambOutOfTheImage)
{
	// Turned by 41°, the left edge of the image is 4° to the right of straight ahead: 0.2 m at 3 m.
	const TruthDoor door = onlyDoor(lookAt(worldWith({}), {0, 0, 0, -41.0 * M_PI / 180, 0, 0}));
	EXPECT_EQ(door.jamb_share[0], 0.0);
	EXPECT_GT(door.jamb_share[1], 0.9);
	EXPECT_GT(door.visible_share, 0.1);
	EXPECT_EQ(door.visibility, Visibility::ignored);
}

TEST(TruthDoors, LeavesOutWhatIsBehindTheCameraAndTellsOfWhatIsBesideIt)
{
	EXPECT_TRUE(lookAt(worldWith({}), {0, 0, 0, M_PI, 0, 0}).doors.empty());
	const TruthDoor beside = onlyDoor(lookAt(worldWith({}), {0, 0, 0, 80.0 * M_PI / 180, 0, 0}));
	EXPECT_EQ(beside.visibility, Visibility::hidden);
	EXPECT_EQ(beside.visible_share, 0.0);
}

TEST(TruthDoors, IsSeenFromItsBackToo)
{
	const TruthDoor door = onlyDoor(lookAt(worldWith({}), {6.1, 0, 0, M_PI, 0, 0}));
	EXPECT_EQ(door.visibility, Visibility::visible);
	EXPECT_LT((door.normal_in_map - Vector3d::UnitX()).norm(), 1e-9);
	EXPECT_DOUBLE_EQ(door.visible_share, 1.0);
}

TEST(TruthDoors, OneBehindAWallIsHidden)
{
	World world = worldWith({});
	addBox(world, {{2.0, -4.0, 0.0}, {2.1, 4.0, 2.6}});
	const TruthDoor door = onlyDoor(lookAt(world));
	EXPECT_EQ(door.visibility, Visibility::hidden);
	EXPECT_EQ(door.visible_share, 0.0);
}

TEST(TruthDoors, OneSeenThroughAnotherCountsAsAnyOther)
{
	World world = worldWith({.face_x = 1.5, .width_m = 1.2});
	const DoorWall behind{.face_x = 4.0};
	for (const Box& box : boxesOf(behind)) addBox(world, box);
	world.doors.push_back(labelOf(behind, "behind"));
	const TruthFrame frame = lookAt(world);
	ASSERT_EQ(frame.doors.size(), 2U);
	EXPECT_EQ(frame.doors[1].id, "behind");
	EXPECT_EQ(frame.doors[1].visibility, Visibility::visible);
}

TEST(TruthDoors, WhatHidesHalfOfAJambHidesTheDoor)
{
	// Seen from 0.5 m up, a box 1.5 m away hides what lies below the line over its top edge at twice that distance.
	const auto withBoxUpTo = [](double height_at_jamb_m)
	{
		World world = worldWith({});
		const double share = 1.5 / 2.98;
		addBox(world, {{1.5, 0.15, 0.0}, {1.6, 0.5, 0.5 + (height_at_jamb_m - 0.5) * share}});
		return onlyDoor(lookAt(world));
	};
	const TruthDoor seen = withBoxUpTo(0.8), half_hidden = withBoxUpTo(1.2);
	EXPECT_NEAR(seen.jamb_share[0], 0.6, 0.03);
	EXPECT_EQ(seen.visibility, Visibility::visible);
	EXPECT_NEAR(half_hidden.jamb_share[0], 0.4, 0.03);
	EXPECT_DOUBLE_EQ(half_hidden.jamb_share[1], 1.0);
	EXPECT_EQ(half_hidden.visibility, Visibility::ignored);
}

TEST(TruthDoors, ItsOwnLeafHidesNothingOfIt)
{
	const Box leaf{{2.1, 0.40, 0.0}, {2.99, 0.44, 2.0}};  // toward the camera, along the left jamb
	World own = worldWith({}), foreign = worldWith({});
	addBox(own, {{2.3, -0.45, 0.0}, {2.34, 0.0, 2.0}}, "gallery::door_leaf::panel");
	addBox(foreign, {{2.3, -0.45, 0.0}, {2.34, 0.45, 2.0}}, "gallery::door2_leaf::panel");
	addBox(own, leaf, "door_leaf");
	EXPECT_EQ(onlyDoor(lookAt(own)).visibility, Visibility::visible);
	EXPECT_EQ(onlyDoor(lookAt(foreign)).visibility, Visibility::hidden);
}

TEST(TruthDoors, ItIsIgnoredWhereItsOwnLeafCoversMoreThanThreeQuarters)
{
	// Before the wall on the camera's side; the opening is 0.9 m wide, seen from straight ahead, so that the share of
	// it that a leaf just before the wall covers is the leaf's width.
	const auto withLeafOf = [](double width_m)
	{
		World world = worldWith({});
		addBox(world, {{2.93, -0.45, 0.0}, {2.97, -0.45 + width_m, 2.0}}, "door_leaf");
		return onlyDoor(lookAt(world));
	};
	EXPECT_EQ(withLeafOf(0.60).visibility, Visibility::visible);
	EXPECT_EQ(withLeafOf(0.75).visibility, Visibility::ignored);
	EXPECT_DOUBLE_EQ(withLeafOf(0.75).visible_share, 1.0);
}

TEST(TruthDoors, OneSeenThroughGlassIsIgnored)
{
	World world = worldWith({});
	addBox(world, {{2.0, -4.0, 0.0}, {2.01, 4.0, 2.6}}, "pane", "window_glass");
	const TruthDoor door = onlyDoor(lookAt(world));
	EXPECT_EQ(door.visibility, Visibility::ignored);
	EXPECT_EQ(door.visible_share, 0.0);

	World in_the_opening = worldWith({});
	addBox(in_the_opening, {{3.04, -0.45, 0.0}, {3.06, 0.45, 2.0}}, "pane", "glass");
	EXPECT_EQ(onlyDoor(lookAt(in_the_opening)).visibility, Visibility::visible);
}

TEST(TruthDoors, SharesAgreeWithASlowCountOverRandomBoxes)
{
	Random random(7);
	for (int scene = 0; scene < 40; ++scene)
	{
		const DoorWall wall{.face_x = random.uniform(1.5, 4.5), .width_m = random.uniform(0.7, 1.3)};
		World world = worldWith(wall);
		std::vector<Box> boxes;
		for (int i = 0; i < 4; ++i)
		{
			const Vector3d low(random.uniform(0.4, wall.face_x - 0.6), random.uniform(-1.0, 0.8),
			                   random.uniform(0.0, 1.0));
			const Vector3d size(random.uniform(0.05, 0.3), random.uniform(0.05, 0.8), random.uniform(0.1, 1.0));
			boxes.push_back({low, low + size});
			addBox(world, boxes.back());
		}
		const TruthDoor door = onlyDoor(lookAt(world));

		// Every point of a finer grid: within the image, and no box before it.
		int seen = 0, all = 0;
		const Vector3d eye(0.0, 0.0, 0.5);
		for (double y = -0.495; y < 0.5; y += 0.01)
			for (double z = 0.005; z < 1.0; z += 0.01, ++all)
			{
				const Vector3d point(wall.face_x - 0.02, y * wall.width_m, z * wall.height_m);
				const bool in_image = std::abs(point.y()) < point.x() && std::abs(point.z() - 0.5) < 0.75 * point.x();
				seen += in_image && std::none_of(boxes.begin(), boxes.end(),
				                                 [&](const Box& box) { return crosses(eye, point, box); });
			}
		EXPECT_NEAR(door.visible_share, static_cast<double>(seen) / all, 0.06) << "scene " << scene;
	}
}

TEST(TruthPassage, NeedsFiveCentimetresOnEachSide)
{
	const World world = worldWith({.width_m = 0.6});
	const RayScene scene(world);
	const DoorLabel& label = world.doors.front();
	EXPECT_TRUE(passageOf(label, scene, robotOf(RobotKind::ground, 0.25, 0.6)).passable);
	EXPECT_FALSE(passageOf(label, scene, robotOf(RobotKind::ground, 0.251, 0.6)).passable);
	EXPECT_TRUE(passageOf(label, scene, robotOf(RobotKind::ground, 0.2, 1.95)).passable);
	EXPECT_FALSE(passageOf(label, scene, robotOf(RobotKind::ground, 0.2, 1.96)).passable);
}

TEST(TruthPassage, FollowsTheVerdictTheLeafAndTheSill)
{
	const World world = worldWith({});
	const RayScene scene(world);
	const RobotConfig robot;
	DoorLabel label = world.doors.front();
	for (const Verdict verdict : {Verdict::closed, Verdict::blocked, Verdict::drop, Verdict::unknown})
	{
		label.verdict = verdict;
		EXPECT_FALSE(passageOf(label, scene, robot).passable) << nameOf(verdict);
	}
	label.verdict = Verdict::ajar;
	label.clear_width_m = 0.6;
	EXPECT_TRUE(passageOf(label, scene, robot).passable);
	label.clear_width_m = 0.5;
	EXPECT_FALSE(passageOf(label, scene, robot).passable);
	label = world.doors.front();
	label.sill_m = 0.03;
	EXPECT_TRUE(passageOf(label, scene, robot).passable);
	label.sill_m = 0.2;
	EXPECT_FALSE(passageOf(label, scene, robot).passable);
}

TEST(TruthPassage, AMavNeedsAHeightWithinItsBand)
{
	const World world = worldWith({});
	const RayScene scene(world);
	const RobotConfig mav = robotOf(RobotKind::mav, 0.3, 0.25);  // band 0.5 – 2.0 m
	DoorLabel label = world.doors.front();
	label.verdict = Verdict::blocked;
	label.sill_m = 0.9;
	EXPECT_TRUE(passageOf(label, scene, mav).passable) << "over the counter";
	label.sill_m = 1.7;  // 2.0 − 1.7 leaves 0.3, it needs 0.25 + 2 · 0.05
	EXPECT_FALSE(passageOf(label, scene, mav).passable);
	label.sill_m = 0.0;
	EXPECT_FALSE(passageOf(label, scene, mav).passable) << "what blocks it reaches up";
	label.verdict = Verdict::open;
	label.height_m = 0.6;  // below the band
	EXPECT_FALSE(passageOf(label, scene, mav).passable);
}

TEST(TruthPassage, WhoStandsInTheDoorwayBlocksIt)
{
	World world = worldWith({.width_m = 1.0});
	MovingBody person;
	person.name = person.kind = "person";
	person.mesh = personMesh(1.75, 0.25);
	person.material = world.materialNamed("person");
	person.radius_m = 0.25;
	person.track = {{0.0, {3.05, 0.0}, 0.0, 0.0}};
	world.moving.push_back(person);
	RayScene scene(world);
	const DoorLabel& label = world.doors.front();
	const Passage blocked = passageOf(label, scene, {});
	EXPECT_EQ(blocked.verdict, Verdict::blocked);
	EXPECT_FALSE(blocked.passable);
	EXPECT_NEAR(blocked.clear_width_m, 0.25, 1e-9);

	Eigen::Isometry3d aside = Eigen::Isometry3d::Identity();
	aside.translation() = Vector3d(3.05, 0.4, 0.0);  // leaves 0.65 of the metre
	scene.place(std::vector{aside});
	const Passage beside = passageOf(label, scene, {});
	EXPECT_EQ(beside.verdict, Verdict::open);
	EXPECT_TRUE(beside.passable);
	EXPECT_NEAR(beside.clear_width_m, 0.65, 1e-9);

	aside.translation() = Vector3d(2.5, 0.0, 0.0);  // before the door
	scene.place(std::vector{aside});
	EXPECT_NEAR(passageOf(label, scene, {}).clear_width_m, 1.0, 1e-9);
}

// From where random scenes are looked at, and that everything can be made again.
#include <explore/core/geometry.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "scene_support.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;

namespace
{
constexpr int kLooks = 4;

bool touches(const Scene& scene, const RobotConfig& robot, const mrpt::poses::CPose3D& pose)
{
	const bool flies = robot.kind == RobotKind::mav;
	const double low_m = flies ? pose.z() - 0.5 * robot.height_m : 0.03;
	const double high_m = flies ? pose.z() + 0.5 * robot.height_m : scene.body_height_m;
	return scene.rays->touchesCylinder({pose.x(), pose.y(), low_m}, robot.radius_m, high_m - low_m);
}

bool sameWorld(const Scene& a, const Scene& b)
{
	const auto& left = a.world->mesh.vertices;
	const auto& right = b.world->mesh.vertices;
	return left.size() == right.size() && std::equal(left.begin(), left.end(), right.begin());
}
}  // namespace

TEST(ScenePoses, TouchNothingAndBeginAtTheOrigin)
{
	for (const SceneFamily& family : sceneFamilies())
		for (const RobotKind kind : {RobotKind::ground, RobotKind::mav})
			for (int index = 0; index < 2; ++index)
			{
				const Scene scene = sceneOf(family.name, index, kind, kLooks);
				ASSERT_EQ(scene.looks.size(), static_cast<std::size_t>(kLooks));
				const auto& first = firstLook(scene).map_from_robot;
				EXPECT_EQ(first.x(), 0);
				EXPECT_EQ(first.y(), 0);
				EXPECT_NEAR(first.yaw(), 0, 1e-12);
				for (const SceneLook& look : scene.looks)
					EXPECT_FALSE(touches(scene, robotOfKind(kind), look.truth.map_from_robot))
					    << family.name << ' ' << nameOf(kind) << ' ' << index;
			}
}

TEST(ScenePoses, AreThoseOfTheRobots)
{
	std::vector<double> heights, altitudes, tilts;
	for (const char* family : {"single_wall_single_door", "corridor_side_doors", "alcove"})
		for (int index = 0; index < 40; ++index)
		{
			const TruthFrame ground = firstLook(sceneOf(family, index, RobotKind::ground));
			heights.push_back(ground.robot_from_camera->z());
			EXPECT_EQ(ground.map_from_robot.z(), 0);
			EXPECT_LE(std::abs(ground.map_from_robot.pitch()), 1.0001 * kDegree_rad);
			EXPECT_LE(std::abs(ground.map_from_robot.roll()), 1.0001 * kDegree_rad);
			const TruthFrame mav = firstLook(sceneOf(family, index, RobotKind::mav));
			altitudes.push_back(mav.map_from_robot.z());
			tilts.push_back(std::abs(mav.map_from_robot.roll()));
			tilts.push_back(std::abs(mav.map_from_robot.pitch()));
		}
	for (auto* values : {&heights, &altitudes, &tilts}) std::ranges::sort(*values);
	EXPECT_GE(heights.front(), 0.3);
	EXPECT_LT(heights.front(), 0.36);
	EXPECT_LE(heights.back(), 1.2);
	EXPECT_GT(heights.back(), 1.1);
	EXPECT_GE(altitudes.front(), 1.0);
	EXPECT_LE(altitudes.back(), 2.0);
	EXPECT_GT(altitudes.back(), 1.9);
	EXPECT_LE(tilts.back(), 10.0001 * kDegree_rad);
	EXPECT_GT(tilts.back(), 9 * kDegree_rad);
}

TEST(ScenePoses, OfTiltedViewsAreTilted)
{
	for (const RobotKind kind : {RobotKind::ground, RobotKind::mav})
		for (int index = 0; index < 30; ++index)
		{
			const TruthFrame frame = firstLook(sceneOf("tilted_view", index, kind));
			const mrpt::poses::CPose3D camera = frame.map_from_robot + *frame.robot_from_camera;
			const double roll = std::abs(camera.roll()) / kDegree_rad, pitch = camera.pitch() / kDegree_rad;
			EXPECT_TRUE(roll > 8.5 || pitch < -8.5) << roll << ' ' << pitch;
			EXPECT_LT(roll, 22);
			EXPECT_GT(pitch, -22);
		}
}

TEST(ScenePoses, OfUnseenFloorsSeeNone)
{
	const auto camera = depthCamera("xtion");
	for (const RobotKind kind : {RobotKind::ground, RobotKind::mav})
		for (int index = 0; index < 10; ++index)
		{
			const Scene scene = sceneOf("floor_unseen", index, kind);
			const Eigen::Isometry3d map_from_camera =
			    isometryOf(firstLook(scene).map_from_robot + *firstLook(scene).robot_from_camera);
			int floor = 0;
			for (int v = 0; v < 480; v += 7)
				for (int u = 0; u < 640; u += 7)
				{
					const auto hit =
					    scene.rays->cast(map_from_camera.translation(),
					                     map_from_camera.linear() * rayOfPixel(camera.intrinsics, u, v), 30);
					if (hit && scene.world->bodies[hit->body].name == "floor") ++floor;
				}
			EXPECT_LE(floor, 3) << nameOf(kind) << ' '
			                    << index;  // of 6348: a corner between the rays that were looked at
		}
}

TEST(ScenePoses, OfAnApproachAreLooksOfTheirOwnAndComeNearer)
{
	int nearer = 0;
	for (int index = 0; index < 20; ++index)
	{
		const Scene scene = sceneOf("single_wall_single_door", index, RobotKind::ground, 10);
		for (std::size_t i = 1; i < scene.looks.size(); ++i)
		{
			const auto &before = scene.looks[i - 1].truth.map_from_robot, &now = scene.looks[i].truth.map_from_robot;
			const double moved_m = std::hypot(now.x() - before.x(), now.y() - before.y());
			const double turned_rad = std::abs(wrapToPi(now.yaw() - before.yaw()));
			EXPECT_TRUE(moved_m >= 0.05 || turned_rad >= 2.99 * kDegree_rad) << moved_m << ' ' << turned_rad;
			const double dt_s = scene.looks[i].t_s - scene.looks[i - 1].t_s;
			EXPECT_GE(dt_s, 0.2);
			EXPECT_LE(dt_s, 0.5);
		}
		const auto distance = [](const TruthFrame& frame)
		{
			return (frame.doors.front().center_in_map.head<2>() -
			        Eigen::Vector2d(frame.map_from_robot.x(), frame.map_from_robot.y()))
			    .norm();
		};
		if (scene.looks.back().truth.doors.empty()) continue;
		nearer += distance(scene.looks.back().truth) < distance(firstLook(scene)) - 0.2 ? 1 : 0;
	}
	EXPECT_GT(nearer, 10);
}

TEST(ScenePoses, AndWorldsDependOnTheRequestAlone)
{
	for (const SceneFamily& family : sceneFamilies())
	{
		const Scene scene = sceneOf(family.name, 2), again = sceneOf(family.name, 2);
		const Scene longer = sceneOf(family.name, 2, RobotKind::ground, 4);
		EXPECT_TRUE(sameWorld(scene, again)) << family.name;
		EXPECT_TRUE(sameWorld(scene, longer)) << family.name;
		EXPECT_EQ(firstLook(scene).map_from_robot, firstLook(longer).map_from_robot);
		EXPECT_FALSE(sameWorld(scene, sceneOf(family.name, 3)));
		EXPECT_FALSE(sameWorld(scene, sceneOf(family.name, 2, RobotKind::mav)));
		EXPECT_FALSE(sameWorld(scene, sceneOf(family.name, 2, RobotKind::ground, 1, 6)));
	}
}

TEST(ScenePoses, AreFoundInFewTries)
{
	for (const SceneFamily& family : sceneFamilies())
		for (const RobotKind kind : {RobotKind::ground, RobotKind::mav})
		{
			int tries = 0;
			for (int index = 0; index < 5; ++index) tries += sceneOf(family.name, index, kind).tries;
			EXPECT_LT(tries, 60) << family.name << ' ' << nameOf(kind);
		}
}

#include <explore/core/geometry.h>
#include <explore/memory/door_sight.h>
#include <gtest/gtest.h>
#include <support/analytic_scene.h>

#include "door_looks.h"

namespace explore::test
{
namespace
{
const mrpt::poses::CPose3D kMount(0, 0, 0.5, 0, 0, 0);

DepthFrame frameOf(const Scene& scene, double x_m, double y_m, double yaw_rad)
{
	CameraNoise far_sighted;
	far_sighted.max_depth_m = 50;
	return renderFrame(scene, mrpt::poses::CPose3D(x_m, y_m, 0, yaw_rad, 0, 0), kMount, xtionIntrinsics(160, 120),
	                   far_sighted);
}

/** 6 m wide wall at x = 3 with an opening of 0.9 m in its middle, floor, and a wall 3 m behind. */
Scene doorInWall()
{
	Scene scene;
	scene.floor(-2, -4, 8, 4).wall({3, -3}, {3, 3}, 2.5, {{2.55, 0.9, 2.0}}).wall({6, -4}, {6, 4}, 2.5);
	return scene;
}
const KnownDoor kDoor{{3, 0}, std::numbers::pi};

std::optional<DoorView> seen(const DepthFrame& frame, const KnownDoor& door = kDoor)
{
	return viewOf(frame, placeOf(door), {}, {});
}

TEST(DoorSight, AnOpenDoorInPlainViewLetsRaysThrough)
{
	const auto view = seen(frameOf(doorInWall(), 0, 0, 0));
	ASSERT_TRUE(view);
	EXPECT_GT(view->through_share, 0.8) << "the highest rays meet nothing behind";
	EXPECT_LT(view->shut_share, 0.05);
}

TEST(DoorSight, AShutDoorStopsThem)
{
	Scene scene = doorInWall();
	scene.patch({{3.05, -0.45, 0}, {0, 0.9, 0}, {0, 0, 2.0}});
	const auto view = seen(frameOf(scene, 0, 0, 0));
	ASSERT_TRUE(view);
	EXPECT_LT(view->through_share, 0.02);
	EXPECT_GT(view->shut_share, 0.98);
}

TEST(DoorSight, SomethingBeforeItHidesIt)
{
	Scene person = doorInWall();
	person.box({1.8, 0.0, 0.9}, {0.3, 0.5, 1.8});
	EXPECT_FALSE(seen(frameOf(person, 0, 0, 0))) << "in front of the opening";
	Scene cabinet = doorInWall();
	cabinet.box({2.0, 0.45, 0.9}, {0.4, 0.5, 1.8});
	EXPECT_FALSE(seen(frameOf(cabinet, 0, 0, 0))) << "in front of a jamb";
	Scene low = doorInWall();
	low.box({2.0, 0.0, 0.15}, {0.3, 0.3, 0.3});
	EXPECT_TRUE(seen(frameOf(low, 0, 0, 0))) << "a low box";
}

TEST(DoorSight, OutOfViewTooFarTooGrazingOrWithoutImageIsNotSeen)
{
	const Scene scene = doorInWall();
	EXPECT_FALSE(seen(frameOf(scene, 0, 0, 40 * kDegree_rad)));
	EXPECT_FALSE(seen(frameOf(scene, 0, 0, 180 * kDegree_rad)));
	EXPECT_FALSE(seen(frameOf(scene, -2.3, 0, 0))) << "5.3 m";
	EXPECT_FALSE(seen(frameOf(scene, 2.6, 0, 0))) << "the jambs are beside the image";
	EXPECT_FALSE(seen(frameOf(scene, 2.3, -2.5, 74 * kDegree_rad))) << "74 degrees from the front";
	EXPECT_FALSE(seen(DepthFrame()));
}

TEST(DoorSight, JambsWithoutReturnAreNotSeen)
{
	DepthFrame frame = frameOf(doorInWall(), 0, 0, 0);
	for (float& depth_m : frame.image.depth_m) depth_m = 0;
	EXPECT_FALSE(seen(frame));
}

/** Share of the points of a vertical strip that a ray from the camera reaches, of those in the image; and of all. */
struct Shares
{
	double of_image = 0, of_all = 0;
};
Shares reached(const Scene& scene, const DepthFrame& frame, const DoorPlace& place, double from_m, double to_m)
{
	const Eigen::Isometry3d map_from_camera = isometryOf(frame.map_from_robot) * isometryOf(frame.robot_from_camera);
	int all = 0, in_image = 0, clear = 0;
	for (int i = 0; i < 15; ++i)
		for (int k = 0; k < 20; ++k)
		{
			const Eigen::Vector3d point = place.point(from_m + (to_m - from_m) * i / 14, 0.02 + 1.96 * k / 19);
			const auto pixel = pixelOfPoint(frame.image.intrinsics, map_from_camera.inverse() * point);
			++all;
			if (!pixel || pixel->x() < 0 || pixel->y() < 0 || pixel->x() > frame.image.intrinsics.width_px - 1 ||
			    pixel->y() > frame.image.intrinsics.height_px - 1)
				continue;
			++in_image;
			const Eigen::Vector3d ray = point - map_from_camera.translation();
			const double hit = castRay(scene, map_from_camera.translation(), ray);
			clear += hit == 0 || hit > 0.95 ? 1 : 0;
		}
	return {in_image > 0 ? static_cast<double>(clear) / in_image : 0.0, static_cast<double>(clear) / all};
}

TEST(DoorSight, AgreesWithRaysCastInTheSceneItself)
{
	// A hall of 7 m × 6 m with doors in three walls, furniture, and walls behind the doors.
	Scene scene;
	scene.floor(-4, -8, 12, 8)
	    .wall({0, 3}, {7, 3}, 2.5, {{2, 0.9, 2.0}, {4.5, 0.9, 2.0}})
	    .wall({0, -3}, {7, -3}, 2.5, {{1, 0.9, 2.0}, {4.8, 0.9, 2.0}})
	    .wall({7, -3}, {7, 3}, 2.5, {{2.5, 0.9, 2.0}})
	    .wall({-4, 6}, {12, 6}, 4)
	    .wall({-4, -6}, {12, -6}, 4)
	    .wall({10, -8}, {10, 8}, 4)
	    .box({3.5, 1.2, 0.6}, {0.5, 0.5, 1.2})
	    .box({4.5, -1.4, 0.9}, {0.4, 0.4, 1.8})
	    .box({2.0, 0, 0.9}, {0.4, 0.5, 1.8});
	const std::vector<KnownDoor> doors{{{2.45, 3}, -90 * kDegree_rad},
	                                   {{4.95, 3}, -90 * kDegree_rad},
	                                   {{1.45, -3}, 90 * kDegree_rad},
	                                   {{5.25, -3}, 90 * kDegree_rad},
	                                   {{7, -0.05}, 180 * kDegree_rad}};
	Dice dice(7);
	int clear = 0, hidden = 0;
	for (int round = 0; round < 150; ++round)
	{
		const DepthFrame frame =
		    frameOf(scene, dice.uniform(0.3, 6), dice.uniform(-2, 2), dice.uniform(-120, 120) * kDegree_rad);
		const Eigen::Vector2d camera(frame.map_from_robot.x(), frame.map_from_robot.y());
		for (const KnownDoor& door : doors)
		{
			const DoorPlace place = placeOf(door);
			const double left = reached(scene, frame, place, -0.53, -0.49).of_image;
			const double right = reached(scene, frame, place, 0.49, 0.53).of_image;
			const double opening = reached(scene, frame, place, -0.4, 0.4).of_all;
			const Eigen::Vector2d sight = door.center_in_map - camera;
			const double slant = std::acos(std::abs(sight.normalized().dot(place.normal())));
			const double farthest_m = sight.norm() + 0.5;
			const bool plain = std::min({left, right, opening}) > 0.75 && farthest_m < 4.9 && slant < 65 * kDegree_rad;
			const bool none = std::min({left, right, opening}) < 0.25 || sight.norm() > 5.0 || slant > 75 * kDegree_rad;
			clear += plain ? 1 : 0;
			hidden += none ? 1 : 0;
			const auto view = seen(frame, door);
			if (plain)
			{
				ASSERT_TRUE(view) << "round " << round << ", door at " << door.center_in_map.transpose();
				EXPECT_GT(view->through_share, 0.8) << "round " << round;
			}
			if (none)
			{
				EXPECT_FALSE(view) << "round " << round << ", door at " << door.center_in_map.transpose();
			}
		}
	}
	EXPECT_GE(clear, 30);
	EXPECT_GT(hidden, 300);
}
}  // namespace
}  // namespace explore::test

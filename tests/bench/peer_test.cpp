// Both sides of the comparison see the corridor's doors: a benchmark against a broken peer would mean nothing.
#include "corridor_frames.h"
#include "paper_with_pcl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace explore;
using namespace explore::test;

namespace
{
/** Doors whose two jambs with `margin_m` of wall beside them the camera sees within `max_depth_m`, unoccluded. */
std::vector<Eigen::Vector2d> doorsInView(const DepthFrame& frame, double max_depth_m, double margin_m)
{
	const Eigen::Isometry3d camera_from_map = isometryOf(frame.map_from_robot + frame.robot_from_camera).inverse();
	std::vector<Eigen::Vector2d> doors;
	for (const CorridorDoor& door : corridorDoors())
	{
		const auto in_view = [&](double offset)
		{
			// Both scan heights, so that the wall is there to be scanned.
			for (const double height : {0.7, 1.3})
			{
				const Eigen::Vector3d jamb = camera_from_map * Eigen::Vector3d(door.x_m + offset, door.y_m, height);
				const auto pixel = pixelOfPoint(frame.image.intrinsics, jamb);
				if (!pixel || jamb.x() > max_depth_m || jamb.x() < 0.5) return false;
				if (pixel->x() < 0 || pixel->x() > frame.image.intrinsics.width_px - 1) return false;
				if (pixel->y() < 0 || pixel->y() > frame.image.intrinsics.height_px - 1) return false;
			}
			return true;
		};
		const double reach = 0.5 * kCorridorDoorWidth_m + margin_m;
		if (in_view(-reach) && in_view(reach))
			doors.emplace_back(
			    (isometryOf(frame.map_from_robot).inverse() * Eigen::Vector3d(door.x_m, door.y_m, 0)).head<2>());
	}
	return doors;
}

/** Those of `expected` that none of `doors` lies within 0.15 m of. */
std::size_t missed(const std::vector<Eigen::Vector2d>& expected, const std::vector<Door>& doors)
{
	return static_cast<std::size_t>(std::ranges::count_if(
	    expected,
	    [&](const Eigen::Vector2d& truth)
	    {
		    return std::ranges::none_of(
		        doors, [&](const Door& door) { return (door.center.head<2>() - truth).norm() < 0.15; });
	    }));
}
}  // namespace

TEST(Peer, BothSidesFindTheDoorsInView)
{
	std::size_t expected = 0, missed_by_peer = 0, missed_by_us = 0;
	for (const DepthFrame& frame : corridorFrames({}))
	{
		const auto truth = doorsInView(frame, 4.7, 0.3);
		expected += truth.size();
		ExplorerState state;
		ExplorerConfig paper;
		paper.perception.method = PerceptionMethod::paper;
		missed_by_us += missed(truth, step(frame, state, paper).percepts.doors);
		missed_by_peer += missed(truth, exploreWithPcl(frame, {}).doors);
	}
	ASSERT_GE(expected, 10U);
	EXPECT_LE(missed_by_peer, expected / 10) << "of " << expected;
	EXPECT_LE(missed_by_us, expected / 10) << "of " << expected;
}

TEST(Peer, BothSidesSeeTheGround)
{
	for (const DepthFrame& frame : corridorFrames({}))
	{
		ExplorerState state;
		EXPECT_TRUE(exploreWithPcl(frame, {}).ground_seen) << "frame " << frame.index;
		const auto ground = step(frame, state, {}).percepts.ground;
		ASSERT_TRUE(ground) << "frame " << frame.index;
		EXPECT_NEAR(ground->camera_height_m, 0.6, 0.04) << "frame " << frame.index;
	}
}

#include <explore/pipeline/explorer.h>
#include <gtest/gtest.h>

#include <chrono>
#include <numbers>

#include "support/analytic_scene.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;
using namespace std::chrono_literals;
const CPose3D kMount(0.1, 0.0, 0.5, 0, 0, 0);

/** Frame number `index` at 10 Hz. */
DepthFrame frameOf(const test::Scene& scene, std::size_t index = 0,
                   const test::CameraNoise& noise = {.axial_scale = 1.0})
{
	DepthFrame frame = test::renderFrame(scene, {}, kMount, test::xtionIntrinsics(320, 240), noise);
	frame.index = index;
	frame.timestamp += index * 100ms;
	return frame;
}

test::Scene doorAhead(double center_y)
{
	test::Scene scene;
	scene.floor(-2, -4, 7, 4).wall({3, -4}, {3, 4}, 2.5, {{4 + center_y - 0.5, 1.0, 2.0}}).wall({7, -4}, {7, 4}, 2.5);
	return scene;
}

DepthFrame dark(std::size_t index)
{
	DepthFrame frame = frameOf(doorAhead(0.0), index);
	std::ranges::fill(frame.image.depth_m, 0.0F);
	return frame;
}

TEST(Step, HeadsForTheDoor)
{
	ExplorerState state;
	for (const double y : {-0.6, 0.0, 0.6})
	{
		const StepResult result = step(frameOf(doorAhead(y)), state = {}, {});
		const Headings& headings = result.decision.headings;
		ASSERT_TRUE(headings.door_rad) << y;
		EXPECT_NEAR(*headings.door_rad, std::atan2(y, 3.0), 0.05);
		EXPECT_EQ(headings.desired_rad, headings.door_rad);
		EXPECT_EQ(result.decision.goal.kind, GoalKind::door);
		ASSERT_TRUE(headings.chosen_rad);
		EXPECT_NEAR(*headings.chosen_rad, *headings.door_rad, 0.1);
		EXPECT_FALSE(result.decision.stop);
		EXPECT_GT(result.decision.command.velocity_mps.x(), 0.0);
	}
}

TEST(Step, FollowsTheCorridorWithoutADoor)
{
	ExplorerState state;
	const StepResult result = step(frameOf(test::corridorScene(9.0, {}, {})), state, {});
	EXPECT_FALSE(result.decision.headings.door_rad);
	ASSERT_TRUE(result.decision.headings.vanishing_point_rad);
	EXPECT_NEAR(*result.decision.headings.vanishing_point_rad, 0.0, 0.02);
	EXPECT_EQ(result.decision.goal.kind, GoalKind::corridor);
	EXPECT_FALSE(result.decision.headings.avoid_rad) << "nothing stands in the way";
}

TEST(Step, GoesAroundABoxOnTheWay)
{
	test::Scene scene = test::corridorScene(9.0, {}, {});
	scene.box({2.0, -0.5, 0.3}, {0.3, 0.9, 0.6});  // on the right, across the middle
	ExplorerState state;
	const StepResult result = step(frameOf(scene), state, {});
	ASSERT_TRUE(result.decision.headings.avoid_rad);
	EXPECT_GT(*result.decision.headings.avoid_rad, 0.0) << "the left side is free";
	EXPECT_EQ(result.decision.headings.chosen_rad, result.decision.headings.avoid_rad);
}

TEST(Step, WallCloseAheadStops)
{
	test::Scene scene;
	scene.floor(-2, -4, 7, 4).wall({0.30, -4}, {0.30, 4}, 2.5);
	ExplorerState state;
	const StepResult result = step(frameOf(scene), state, {});
	EXPECT_TRUE(result.decision.stop);
	EXPECT_FALSE(result.decision.headings.chosen_rad);
	EXPECT_EQ(result.decision.command.velocity_mps.norm(), 0.0);
}

TEST(Step, EmptyFrameStopsAndNeverKeepsTheLastHeading)
{
	ExplorerState state;
	ASSERT_FALSE(step(frameOf(doorAhead(0), 0), state, {}).decision.stop);
	const StepResult result = step(dark(1), state, {});
	EXPECT_TRUE(result.decision.stop);
	EXPECT_EQ(result.decision.stop_reason, StopReason::empty_frame);
	EXPECT_FALSE(result.decision.headings.chosen_rad);
	EXPECT_EQ(result.decision.command.velocity_mps.norm(), 0.0);
	EXPECT_FALSE(step(frameOf(doorAhead(0), 2), state, {}).decision.stop) << "goes on when it sees again";
}

TEST(Step, FrameThatIsNotNewerIsStale)
{
	ExplorerState state;
	step(frameOf(doorAhead(0), 5), state, {});
	EXPECT_EQ(step(frameOf(doorAhead(0), 5), state, {}).decision.stop_reason, StopReason::stale_frame);
	EXPECT_EQ(step(frameOf(doorAhead(0), 4), state, {}).decision.stop_reason, StopReason::stale_frame);
	EXPECT_FALSE(step(frameOf(doorAhead(0), 6), state, {}).decision.stop);
}

TEST(Step, ObstacleThatSlipsUnderTheMinimumRangeStops)
{
	const auto withBoxAt = [](double x_m)
	{
		test::Scene scene = test::corridorScene(9.0, {}, {});
		scene.box({x_m + 0.1, 0.0, 0.4}, {0.2, 0.4, 0.8});
		return scene;
	};
	const test::CameraNoise kinect{.axial_scale = 1.0, .min_depth_m = 0.5};
	ExplorerState state;
	step(frameOf(withBoxAt(0.75), 0, kinect), state, {});                           // 0.65 m before the camera
	const StepResult result = step(frameOf(withBoxAt(0.5), 1, kinect), state, {});  // 0.40 m: no return
	EXPECT_TRUE(result.decision.stop);
	EXPECT_EQ(result.decision.stop_reason, StopReason::near_obstacle_lost);
	EXPECT_TRUE(step(frameOf(withBoxAt(0.5), 2, kinect), state, {}).decision.stop) << "still there";
	EXPECT_FALSE(step(frameOf(test::corridorScene(9.0, {}, {}), 3, kinect), state, {}).decision.stop) << "it left";
}

TEST(Step, WhatHaltsTheRobotIsTheReasonUntilItIsOver)
{
	ExplorerState state;
	std::size_t index = 0;
	for (const auto& [halt, reason] : {std::pair{RobotHalt::bumper, StopReason::bumper},
	                                   {RobotHalt::cliff, StopReason::cliff},
	                                   {RobotHalt::link_lost, StopReason::link_lost}})
	{
		DepthFrame frame = frameOf(doorAhead(0), index++);
		frame.halt = halt;
		const Decision halted = step(frame, state, {}).decision;
		EXPECT_TRUE(halted.stop);
		EXPECT_EQ(halted.stop_reason, reason);
		EXPECT_FALSE(halted.headings.chosen_rad);
		EXPECT_EQ(halted.command.velocity_mps.norm(), 0.0);
		EXPECT_EQ(halted.command.yaw_rate_radps, 0.0);
		EXPECT_FALSE(step(frameOf(doorAhead(0), index++), state, {}).decision.stop) << "released";
	}
}

TEST(Step, WhatOtherSensorsSeeIsAvoided)
{
	// A row of posts across the corridor, 0.5 m ahead, that the camera does not see.
	DepthFrame frame = frameOf(test::corridorScene(9.0, {}, {}));
	ExplorerState free_way, blocked;
	ASSERT_GT(step(frame, free_way, {}).decision.open_path_m, 2.0);
	for (float y = -1.0F; y <= 1.0F; y += 0.05F) frame.more_obstacles_in_robot.push_back({0.5F, y, 0.2F});
	const Decision decision = step(frame, blocked, {}).decision;
	EXPECT_LT(decision.open_path_m, 0.5);
	EXPECT_LE(decision.command.velocity_mps.x(), 0.25);
}

TEST(Step, LastGroundIsCarriedOnAsUnseen)
{
	ExplorerState state;
	EXPECT_FALSE(step(dark(0), state, {}).percepts.ground) << "never seen yet";
	const StepResult seen = step(frameOf(doorAhead(0), 1), state, {});
	ASSERT_TRUE(seen.percepts.ground);
	EXPECT_TRUE(seen.percepts.ground->seen);
	const StepResult unseen = step(dark(2), state, {});
	ASSERT_TRUE(unseen.percepts.ground);
	EXPECT_FALSE(unseen.percepts.ground->seen);
	EXPECT_NEAR(unseen.percepts.ground->camera_height_m, seen.percepts.ground->camera_height_m, 1e-9);
}

TEST(Step, NamesEveryStageOnceInOrder)
{
	std::vector<std::string> stages;
	ExplorerState state;
	step(frameOf(doorAhead(0)), state, {}, [&](std::string_view stage) { stages.emplace_back(stage); });
	EXPECT_EQ(stages, (std::vector<std::string>{"perceive", "remember", "choose", "avoid", "heading"}));
}

TEST(Step, EveryAvoiderDrivesThroughAnOpenCorridor)
{
	for (const AvoiderMethod method : {AvoiderMethod::open_path, AvoiderMethod::holonomic_nd,
	                                   AvoiderMethod::holonomic_vff, AvoiderMethod::holonomic_full_eval})
	{
		ExplorerConfig config;
		config.avoider.method = method;
		ExplorerState state;
		const StepResult result = step(frameOf(test::corridorScene(9.0, {}, {})), state, config);
		ASSERT_TRUE(result.decision.headings.chosen_rad) << static_cast<int>(method);
		EXPECT_NEAR(*result.decision.headings.chosen_rad, 0.0, 0.3) << static_cast<int>(method);
	}
}
}  // namespace
}  // namespace explore

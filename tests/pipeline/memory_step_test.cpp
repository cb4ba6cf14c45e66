// Steps of an explorer that remembers: what the mission and the tracks make of frames with a pose.
#include <explore/pipeline/explorer.h>
#include <gtest/gtest.h>

#include <chrono>

#include "support/analytic_scene.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;
using namespace std::chrono_literals;
const CPose3D kMount(0.1, 0.0, 0.5, 0, 0, 0);

/** A corridor of 9 m with a door of 1 m at its left. */
const test::Scene& corridor()
{
	static const test::Scene kCorridor = test::corridorScene(9.0, {3.0}, {});
	return kCorridor;
}

/** Frame `index`, 10 cm further on than the one before. */
DepthFrame frameOf(const test::Scene& scene, std::size_t index, PoseOrigin origin = PoseOrigin::odometry)
{
	const CPose3D map_from_robot(0.1 * static_cast<double>(index), 0, 0, 0, 0, 0);
	DepthFrame frame =
	    test::renderFrame(scene, map_from_robot, kMount, test::xtionIntrinsics(320, 240), {.axial_scale = 1.0});
	frame.index = index;
	frame.timestamp += index * 250ms;
	frame.pose_origin = origin;
	return frame;
}

TEST(StepWithMemory, NothingIsRememberedWithoutAPose)
{
	ExplorerState state;
	step(frameOf(corridor(), 0, PoseOrigin::none), state, {});
	EXPECT_FALSE(state.memory);
	step(frameOf(corridor(), 1), state, {});
	EXPECT_TRUE(state.memory);
}

TEST(StepWithMemory, NorWhereTheConfigurationSaysSoNorByThePapersMethod)
{
	ExplorerConfig off, paper;
	off.memory.enabled = false;
	paper.perception.method = PerceptionMethod::paper;
	for (const ExplorerConfig& config : {off, paper})
	{
		ExplorerState state;
		const StepResult result = step(frameOf(corridor(), 0), state, config);
		EXPECT_FALSE(state.memory);
		EXPECT_FALSE(state.mission.goal);
		EXPECT_FALSE(result.finished);
		for (const Door& door : result.percepts.doors) EXPECT_FALSE(door.track);
	}
}

TEST(StepWithMemory, TheGoalIsTheMissions)
{
	ExplorerState state;
	const StepResult result = step(frameOf(corridor(), 0), state, {});
	ASSERT_TRUE(state.mission.goal);
	EXPECT_EQ(result.decision.goal.kind, state.mission.goal->kind);
	ASSERT_TRUE(result.decision.goal.point_in_robot);
	EXPECT_LT((*result.decision.goal.point_in_robot - state.mission.goal->stand_in_map).norm(), 1e-9)
	    << "the first pose is the map's origin";
	EXPECT_FALSE(result.finished);
}

TEST(StepWithMemory, HeadingsAreThoseOfConfirmedTracks)
{
	ExplorerConfig config;
	config.mission.policy = GoalPolicy::paper;
	ExplorerState state;
	const StepResult first = step(frameOf(corridor(), 0), state, config);
	EXPECT_FALSE(first.decision.headings.vanishing_point_rad) << "one look confirms nothing";
	EXPECT_FALSE(first.decision.headings.door_rad);
	StepResult last;
	for (std::size_t i = 1; i < 8; ++i) last = step(frameOf(corridor(), i), state, config);
	ASSERT_TRUE(last.decision.headings.vanishing_point_rad);
	EXPECT_NEAR(*last.decision.headings.vanishing_point_rad, 0.0, 0.03);
	// Nothing to see at all: what is remembered stays.
	DepthFrame dark = frameOf(corridor(), 8);
	std::ranges::fill(dark.image.depth_m, 0.0F);
	const StepResult blind = step(dark, state, config);
	ASSERT_TRUE(blind.decision.headings.vanishing_point_rad);
	EXPECT_NEAR(*blind.decision.headings.vanishing_point_rad, 0.0, 0.03);
	EXPECT_TRUE(blind.decision.stop);
}

TEST(StepWithMemory, SameFramesSameDecisions)
{
	ExplorerState a, b;
	for (std::size_t i = 0; i < 6; ++i)
	{
		const DepthFrame frame = frameOf(corridor(), i);
		const StepResult one = step(frame, a, {}), other = step(frame, b, {});
		EXPECT_EQ(one.decision.command.yaw_rate_radps, other.decision.command.yaw_rate_radps);
		EXPECT_EQ(one.decision.command.velocity_mps, other.decision.command.velocity_mps);
		EXPECT_EQ(a.mission.way_in_map, b.mission.way_in_map);
	}
}
}  // namespace
}  // namespace explore

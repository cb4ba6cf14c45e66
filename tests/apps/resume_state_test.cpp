// What a checkpoint holds is all that a run needs: explorer and robot go on from it as if they had never stopped.
#include <explore/core/byte_archive.h>
#include <explore/pipeline/explorer.h>
#include <explore/simulation/closed_loop.h>
#include <explore/sinks/json_lines.h>
#include <gtest/gtest.h>

#include <memory>
#include <sstream>

#include "simulation/box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;

namespace
{
/** Two rooms with a door between them; somebody walks up and down in the first one. */
World twoRooms()
{
	World world = hall();
	addBox(world, {{1.0, -2.5, 0.0}, {1.5, -2.0, 0.8}}, "box");
	for (const Box& box : boxesOf({.face_x = 3.5, .half_length_m = 3.0})) addBox(world, box, "wall");
	MovingBody walker;
	walker.name = walker.kind = "person";
	Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
	placed.translation().z() = 0.85;
	append(walker.mesh, boxMesh({0.3, 0.5, 1.7}), placed);
	walker.material = world.materialNamed("grey");
	walker.track = {{0.0, {2.5, 2.0}, 0.0, 0.0}, {4.0, {2.5, -1.0}, 0.0, 0.0}, {8.0, {2.5, 2.0}, 0.0, 0.0}};
	world.moving.push_back(walker);
	return world;
}

ClosedLoopConfig usual(RobotKind kind)
{
	ClosedLoopConfig config;
	config.recorder.camera = depthCamera("xtion", 160);
	config.recorder.robot_from_camera = usualMount(kind);
	config.recorder.start = mrpt::Clock::fromDouble(kUsualStart_s);
	config.recorder.seed = 7;
	config.exact_pose = false;
	config.recorder.robot = kind == RobotKind::mav ? mav() : RobotConfig{};
	if (kind == RobotKind::mav) config.map_from_start = {0.0, 0.0, 1.2, 0.0, 0.0, 0.0};
	return config;
}

/** A run, and all that goes on from frame to frame. */
struct Session
{
	explicit Session(RobotKind kind) : world(twoRooms()), scene(world), loop(scene, usual(kind))
	{
		config.robot = usual(kind).recorder.robot;
	}

	std::string go(int frames)
	{
		std::string lines;
		for (int i = 0; i < frames; ++i)
		{
			const DepthFrame frame = loop.next();
			const StepResult result = step(frame, state, config);
			loop.obey(result.decision.command);
			lines += frameLine(frame, result);
		}
		return lines;
	}
	std::string saved()
	{
		ByteWriter archive;
		exchange(archive, state, config);
		archive(loop);
		return archive.bytes();
	}
	void load(const std::string& bytes)
	{
		ByteReader archive(bytes);
		exchange(archive, state, config);
		archive(loop);
		EXPECT_TRUE(archive.good());
		EXPECT_TRUE(archive.atEnd());
	}
	std::string map()
	{
		std::ostringstream bytes;
		state.memory->map.tree().write(bytes);
		return bytes.str();
	}

	World world;
	RayScene scene;
	ClosedLoop loop;
	ExplorerConfig config;
	ExplorerState state;
};

class GoingOn : public testing::TestWithParam<RobotKind>
{
};
}  // namespace

TEST_P(GoingOn, FromAnyFrameGivesTheSameFramesStateAndMap)
{
	const int frames = GetParam() == RobotKind::ground ? 150 : 60;
	Session whole(GetParam());
	const std::string lines = whole.go(frames);
	const std::string map = whole.map(), state = whole.saved();
	for (const int stop : {0, 1, 2, 17, 41, 113, 149})
	{
		if (stop >= frames) break;
		Session before(GetParam());
		std::string both = before.go(stop);
		Session after(GetParam());
		after.load(before.saved());
		both += after.go(frames - stop);
		ASSERT_EQ(both, lines) << "stopped after " << stop;
		EXPECT_TRUE(after.map() == map) << stop;
		EXPECT_TRUE(after.saved() == state) << stop;
	}
}

TEST_P(GoingOn, KeepingTheStateChangesNothing)
{
	Session plain(GetParam()), kept(GetParam());
	for (int i = 0; i < 60; ++i)
	{
		ASSERT_EQ(kept.go(1), plain.go(1)) << i;
		if (i % 3 == 0) kept.saved();
	}
	EXPECT_TRUE(kept.map() == plain.map());
}

TEST_P(GoingOn, WhatIsLoadedIsSavedAgainAsItWas)
{
	Session before(GetParam());
	before.go(40);
	const std::string bytes = before.saved();
	Session after(GetParam());
	after.load(bytes);
	EXPECT_TRUE(after.saved() == bytes);
}

INSTANTIATE_TEST_SUITE_P(Robots, GoingOn, testing::Values(RobotKind::ground, RobotKind::mav),
                         [](const auto& kind) { return std::string(nameOf(kind.param)); });

#include <explore/config/ini.h>
#include <explore/memory/frontier_memory.h>
#include <explore/perception/perceive.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "support/analytic_scene.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;
using namespace std::chrono_literals;
const CPose3D kMount(0.1, 0.0, 0.5, 0, 0, 0);

/** A room with a door of 1 m in the wall 3 m ahead, 1 m to the left, and floor behind it. */
test::Scene roomWithDoor()
{
	test::Scene scene;
	scene.floor(-1, -3, 7, 3).wall({3, -3}, {3, 3}, 2.5, {{3.5, 1.0, 2.0}}).wall({7, -3}, {7, 3}, 2.5);
	scene.wall({-1, -3}, {7, -3}, 2.5).wall({-1, 3}, {7, 3}, 2.5);
	return scene;
}

/** What a robot remembers that drove toward the wall: frames 0.1 s and 10 cm apart. */
class Drive
{
public:
	explicit Drive(const MemoryConfig& config = {}) : m_config(config), m_memory(config, {}) {}

	Percepts frame()
	{
		DepthFrame frame = test::renderFrame(m_scene, CPose3D(0.1 * m_count, 0, 0, 0, 0, 0), kMount,
		                                     test::xtionIntrinsics(320, 240), {.axial_scale = 1.0});
		frame.index = static_cast<std::size_t>(m_count);
		frame.timestamp += m_count * 250ms;
		frame.pose_origin = PoseOrigin::odometry;
		++m_count;
		Percepts percepts = perceive(frame, {}, {}, m_perception);
		remember(m_memory, frame, percepts, {}, m_config);
		return percepts;
	}
	[[nodiscard]] FrontierMemory& memory() { return m_memory; }

private:
	test::Scene m_scene = roomWithDoor();
	MemoryConfig m_config;
	FrontierMemory m_memory;
	PerceptionMemory m_perception;
	int m_count = 0;
};

CellState stateAt(const FrontierMemory& memory, double x_m, double y_m)
{
	return memory.layers.stateOf(memory.layers.frame().cellAt({x_m, y_m}, 0));
}

TEST(FrontierMemory, OneFrameFillsMapLayersAndFrontiers)
{
	Drive drive;
	drive.frame();
	const FrontierMemory& memory = drive.memory();
	EXPECT_EQ(memory.map.stateAt({2.0, 0.02, 0.5}), VoxelState::free);
	EXPECT_EQ(memory.map.stateAt({3.02, -0.52, 0.5}), VoxelState::occupied);
	EXPECT_EQ(memory.map.stateAt({5.0, -0.5, 0.5}), VoxelState::unknown) << "behind the wall";
	EXPECT_EQ(stateAt(memory, 2.02, 0.02), CellState::free);
	EXPECT_EQ(stateAt(memory, 3.02, -0.52), CellState::occupied);
	EXPECT_EQ(stateAt(memory, 0.02, 2.02), CellState::unknown) << "beside the camera's view";
	EXPECT_FALSE(memory.frontiers.clusters().empty());
	EXPECT_EQ(stateAt(memory, 0.02, 0.17), CellState::free) << "the robot stands there";
}

TEST(FrontierMemory, ReportsGetTheNumbersOfTheirTracks)
{
	Drive drive;
	std::optional<int> track;
	int reports = 0;
	for (int i = 0; i < 6; ++i)
		for (const Door& door : drive.frame().doors)
		{
			if ((door.center.head<2>() - Eigen::Vector2d(3.0 - 0.1 * i, 1.0)).norm() > 0.4) continue;
			++reports;
			ASSERT_TRUE(door.track);
			EXPECT_EQ(track.value_or(*door.track), *door.track) << "one door, one number";
			track = door.track;
		}
	EXPECT_GE(reports, 4);
	const auto& tracks = drive.memory().doors.tracks;
	const auto found = std::ranges::find(tracks, track, [](const DoorTrack& one) { return std::optional(one.number); });
	ASSERT_NE(found, tracks.end());
	EXPECT_TRUE(found->existence.confirmed);
	EXPECT_LT((found->place.center_in_map - Eigen::Vector2d(3.0, 1.0)).norm(), 0.1);
}

TEST(FrontierMemory, WithoutTracksTheMapIsKeptAlone)
{
	MemoryConfig config;
	config.tracks = false;
	Drive drive(config);
	for (int i = 0; i < 4; ++i)
		for (const Door& door : drive.frame().doors) EXPECT_FALSE(door.track);
	EXPECT_TRUE(drive.memory().doors.tracks.empty());
	EXPECT_TRUE(drive.memory().corridors.tracks.empty());
	EXPECT_EQ(stateAt(drive.memory(), 2.02, 0.02), CellState::free);
}

TEST(FrontierMemory, AnOlderMapIsKnownFromTheStart)
{
	Drive drive;
	for (int i = 0; i < 3; ++i) drive.frame();
	const FrontierMemory again({}, {}, std::make_unique<octomap::OcTree>(drive.memory().map.tree()));
	const LayerFrame& frame = drive.memory().layers.frame();
	int known = 0;
	for (std::size_t i = 0; i < frame.size(); ++i)
	{
		const Eigen::Vector2d at = frame.centreOf(i);
		if (at.norm() < 0.7) continue;  // where the robot stood, which a map does not tell
		ASSERT_EQ(stateAt(again, at.x(), at.y()), drive.memory().layers.cells()[i]) << at.transpose();
		known += drive.memory().layers.cells()[i] != CellState::unknown ? 1 : 0;
	}
	EXPECT_GT(known, 1000);
	EXPECT_FALSE(again.frontiers.clusters().empty());
}

TEST(MemoryConfig, EveryFieldIsInTheIni)
{
	MemoryConfig config, loaded;
	config.enabled = false;
	config.tracks = false;
	config.frontiers.max_length_m = 2.5;
	const std::string ini = dumpIni([&](FieldVisitor& fields) { describe(fields, config); });
	for (const char* section : {"[memory]", "[map]", "[layers]", "[frontiers]", "[door_tracks]", "[corridor_tracks]"})
		EXPECT_NE(ini.find(section), std::string::npos) << section;
	loadIniText("test", ini, {}, [&](FieldVisitor& fields) { describe(fields, loaded); });
	EXPECT_FALSE(loaded.enabled || loaded.tracks);
	EXPECT_EQ(loaded.frontiers.max_length_m, 2.5);
}
}  // namespace
}  // namespace explore

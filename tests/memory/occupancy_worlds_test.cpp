// The IoU protocol of doc/definitions.md on a few frames of our worlds; occupancy_bench measures it on many.
#include <explore/memory/occupancy.h>
#include <gtest/gtest.h>

#include "support/octomap_peer.h"
#include "support/world_frames.h"

namespace explore
{
namespace
{
TEST(OccupancyInWorlds, AgreesWithPlainInsertionOfEveryPoint)
{
	for (const test::WorldDrive& drive : test::ourDrives(6, 320))
	{
		SCOPED_TRACE(drive.world);
		const OccupancyConfig config;
		Occupancy map(config);
		const auto reference = test::peerTree(config);
		for (const DepthFrame& frame : test::worldFrames(drive))
		{
			map.insert(frame);
			reference->insertPointCloud(test::cloudInMap(frame), test::cameraInMap(frame), config.range_m, true);
		}
		const test::MapAgreement found = test::agreement(map.tree(), *reference);
		EXPECT_GT(found.reference_occupied, 5000U);
		EXPECT_GE(found.occupiedIou(), 0.99);
		EXPECT_GE(found.freeIou(), 0.995);
		EXPECT_LE(found.wronglyFreedShare(), 0.003);
	}
}

TEST(OccupancyInWorlds, TheSameDriveMakesTheSameMap)
{
	const std::vector<DepthFrame> frames = test::worldFrames(test::ourDrives(4, 320).front());
	Occupancy first({}), second({});
	for (const DepthFrame& frame : frames) first.insert(frame);
	for (const DepthFrame& frame : frames)
	{
		second.insert(frame);
		second.tree();
	}
	EXPECT_TRUE(first.tree() == second.tree());
}
}  // namespace
}  // namespace explore

// The layers and frontiers of a robot that drives or flies through our worlds, against the whole map after every frame.
#include <explore/memory/body_layers.h>
#include <gtest/gtest.h>

#include "frontier_reference.h"
#include "layer_reference.h"
#include "support/world_frames.h"

namespace explore
{
namespace
{
TEST(BodyLayersInWorlds, TheyAndTheirFrontiersAreThoseOfTheWholeMapAfterEveryFrame)
{
	for (const test::WorldDrive& drive : test::ourDrives(6, 320))
	{
		SCOPED_TRACE(drive.world);
		Occupancy map({});
		BodyLayersConfig config;
		config.growth_m = 2.0;
		BodyLayers layers(config, test::robotOf(drive.kind), map.resolution_m());
		Frontiers frontiers;
		for (const DepthFrame& frame : test::worldFrames(drive))
		{
			map.insert(frame);
			layers.update(map.changes());
			ASSERT_EQ(layers.cells(), test::layersReference(map.tree(), layers.frame(), drive.kind));
			frontiers.update(layers);
			test::expectUpToDate(frontiers, layers, 1.5);
		}
		EXPECT_GT(frontiers.clusters().size(), 10U) << "the test saw too little";
		for (const CellState state : {CellState::free, CellState::occupied})
			EXPECT_GT(std::ranges::count(layers.cells(), state), 200) << "the test saw too little";
	}
}
}  // namespace
}  // namespace explore

// How long the map takes for a VGA frame, beside OctoMap's own insertion, and how far the two maps agree.
#include "support/octomap_peer.h"
#include "support/world_frames.h"

#include <benchmark/benchmark.h>
#include <explore/core/heap.h>
#include <explore/memory/occupancy.h>

#include <cstdio>
#include <ctime>
#include <map>
#include <string>

namespace explore::test
{
namespace
{
constexpr int kFrames = 50;
constexpr int kWidth_px = 640;

const std::vector<std::vector<DepthFrame>>& drives()
{
	static const auto kDrives = []
	{
		std::vector<std::vector<DepthFrame>> all;
		for (const WorldDrive& drive : ourDrives(kFrames, kWidth_px)) all.push_back(worldFrames(drive));
		return all;
	}();
	return kDrives;
}

const std::vector<DepthFrame>& driveOf(const benchmark::State& state)
{
	return drives()[static_cast<std::size_t>(state.range(0))];
}

/** One drive from an empty map on; items are frames. */
void insertDrive(benchmark::State& state)
{
	const auto& frames = driveOf(state);
	for ([[maybe_unused]] const auto _ : state)
	{
		Occupancy map(OccupancyConfig{});
		for (const DepthFrame& frame : frames) map.insert(frame);
		benchmark::DoNotOptimize(map.changes().data());
	}
	state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(frames.size()));
}

/** The same with OctoMap, which gets the points ready made. */
void insertDriveWithOctoMap(benchmark::State& state)
{
	const auto& frames = driveOf(state);
	const OccupancyConfig config;
	for ([[maybe_unused]] const auto _ : state)
	{
		const auto tree = peerTree(config);
		for (const DepthFrame& frame : frames)
		{
			state.PauseTiming();
			const octomap::Pointcloud cloud = cloudInMap(frame);
			state.ResumeTiming();
			tree->insertPointCloud(cloud, cameraInMap(frame), config.range_m, false, true);
		}
		benchmark::DoNotOptimize(tree->size());
	}
	state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(frames.size()));
}

/** The IoU protocol of doc/definitions.md, against plain insertion of every point. */
void agreeWithOctoMap(benchmark::State& state)
{
	const auto& frames = driveOf(state);
	const OccupancyConfig config;
	MapAgreement found;
	for ([[maybe_unused]] const auto _ : state)
	{
		const auto reference = peerTree(config);
		Occupancy map(config);
		for (const DepthFrame& frame : frames)
		{
			reference->insertPointCloud(cloudInMap(frame), cameraInMap(frame), config.range_m, true, false);
			map.insert(frame);
		}
		found = agreement(map.tree(), *reference);
	}
	state.counters["occupied_iou"] = found.occupiedIou();
	state.counters["free_iou"] = found.freeIou();
	state.counters["wrongly_freed"] = found.wronglyFreedShare();
	state.counters["occupied"] = static_cast<double>(found.reference_occupied);
}

BENCHMARK(insertDrive)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(insertDriveWithOctoMap)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(agreeWithOctoMap)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->Iterations(1);
}  // namespace
}  // namespace explore::test

int main(int argc, char** argv)
{
	explore::keepFreedMemory();
	benchmark::Initialize(&argc, argv);
	if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
	explore::test::drives();
	benchmark::RunSpecifiedBenchmarks();
	return 0;
}

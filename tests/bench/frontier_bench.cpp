// How long layers and frontiers take after a VGA frame, beside a scan of the whole octree for the same cells.
#include "support/world_frames.h"

#include <benchmark/benchmark.h>
#include <explore/core/heap.h>
#include <explore/memory/floor_map.h>
#include <explore/memory/frontiers.h>

#include <cstdio>

#include "frame_times.h"

namespace explore::test
{
namespace
{
constexpr int kFrames = 50;
constexpr int kWidth_px = 640;
/** Time between frames: as the camera delivers them, and with much new to see in each. */
constexpr double kCameraPeriod_s = 0.1, kLongPeriod_s = 0.5;

struct Drive
{
	std::string name;
	RobotKind kind;
	std::vector<DepthFrame> frames;
};

std::vector<Drive> makeDrives()
{
	std::vector<Drive> all;
	for (const double period_s : {kCameraPeriod_s, kLongPeriod_s})
		for (WorldDrive drive : ourDrives(kFrames, kWidth_px))
		{
			drive.period_s = period_s;
			all.push_back(
			    {drive.world + (period_s == kCameraPeriod_s ? " 10 Hz" : " 2 Hz"), drive.kind, worldFrames(drive)});
		}
	return all;
}

const std::vector<Drive>& drives()
{
	static const std::vector<Drive> kDrives = makeDrives();
	return kDrives;
}

RobotConfig robotOf(RobotKind kind)
{
	RobotConfig robot;
	robot.kind = kind;
	if (kind == RobotKind::mav)
	{
		robot.radius_m = 0.30;
		robot.height_m = 0.25;
	}
	return robot;
}

/** Heights that a body sweeps. */
struct Band
{
	double low_m, high_m;
};

std::vector<Band> bandsOf(const RobotConfig& robot, const LayerFrame& frame)
{
	if (robot.kind == RobotKind::ground) return {{0.10, robot.height_m}};
	std::vector<Band> bands;
	bands.reserve(frame.altitudes_m.size());
	for (const double altitude_m : frame.altitudes_m)
		bands.push_back({altitude_m - 0.5 * robot.height_m - 0.05, altitude_m + 0.5 * robot.height_m + 0.05});
	return bands;
}

/** The frontier cells of a layer from the octree alone, not clustered; a ground robot's drops are taken for free. */
std::size_t scan(const octomap::OcTree& map, const Band& band)
{
	const FloorMap floor = floorMap(map, {.floor_z_m = 0.0, .lowest_m = band.low_m, .highest_m = band.high_m});
	const auto state_at = [&](int column, int row)
	{
		if (column < 0 || column >= floor.columns || row < 0 || row >= floor.rows) return VoxelState::unknown;
		return floor.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(floor.columns) +
		                   static_cast<std::size_t>(column)];
	};
	std::size_t count = 0;
	for (int row = 0; row < floor.rows; ++row)
		for (int column = 0; column < floor.columns; ++column)
			if (state_at(column, row) == VoxelState::free &&
			    (state_at(column + 1, row) == VoxelState::unknown || state_at(column - 1, row) == VoxelState::unknown ||
			     state_at(column, row + 1) == VoxelState::unknown || state_at(column, row - 1) == VoxelState::unknown))
				++count;
	return count;
}

struct Times
{
	std::vector<double> layers_ms, both_ms, scan_ms;  ///< a frame each
	std::size_t clusters = 0;

	void add(const Times& other)
	{
		layers_ms.insert(layers_ms.end(), other.layers_ms.begin(), other.layers_ms.end());
		both_ms.insert(both_ms.end(), other.both_ms.begin(), other.both_ms.end());
		scan_ms.insert(scan_ms.end(), other.scan_ms.begin(), other.scan_ms.end());
	}
};

/** One drive from an empty map on. */
Times timesOver(const Drive& drive)
{
	const RobotConfig robot = robotOf(drive.kind);
	Occupancy map(OccupancyConfig{});
	BodyLayers layers({}, robot, map.resolution_m());
	Frontiers frontiers;
	Times times;
	for (const DepthFrame& frame : drive.frames)
	{
		map.insert(frame);
		const double start_ms = threadTime_ms();
		layers.stood({frame.map_from_robot.x(), frame.map_from_robot.y(), frame.map_from_robot.z()});
		layers.update(map.changes());
		const double layers_done_ms = threadTime_ms();
		frontiers.update(layers);
		times.both_ms.push_back(threadTime_ms() - start_ms);
		times.layers_ms.push_back(layers_done_ms - start_ms);
		const octomap::OcTree& tree = map.tree();
		const double scan_ms = threadTime_ms();
		for (const Band& band : bandsOf(robot, layers.frame())) benchmark::DoNotOptimize(scan(tree, band));
		times.scan_ms.push_back(threadTime_ms() - scan_ms);
	}
	times.clusters = frontiers.clusters().size();
	return times;
}

/** Over every drive that was followed. */
Times& timesOfAll()
{
	static Times all;
	return all;
}

void followDrive(benchmark::State& state)
{
	const Drive& drive = drives()[static_cast<std::size_t>(state.range(0))];
	Times all;
	for ([[maybe_unused]] const auto _ : state)
	{
		const Times once = timesOver(drive);
		all.add(once);
		all.clusters = once.clusters;
	}
	timesOfAll().add(all);
	state.SetLabel(drive.name);
	state.counters["layers_median_ms"] = quantile(all.layers_ms, 0.5);
	state.counters["median_ms"] = quantile(all.both_ms, 0.5);
	state.counters["p99_ms"] = quantile(all.both_ms, 0.99);
	state.counters["max_ms"] = quantile(all.both_ms, 1.0);
	state.counters["scan_median_ms"] = quantile(all.scan_ms, 0.5);
	state.counters["ratio"] = quantile(all.scan_ms, 0.5) / quantile(all.both_ms, 0.5);
	state.counters["clusters"] = static_cast<double>(all.clusters);
}
BENCHMARK(followDrive)->DenseRange(0, 5)->Unit(benchmark::kMillisecond)->Iterations(1);

void compareWithScan()
{
	const Times& all = timesOfAll();
	if (all.both_ms.empty()) return;
	std::printf(
	    "all frames: median %.2f ms, 99th percentile %.2f ms; a scan of the octree %.2f ms: %.0f times as long\n",
	    quantile(all.both_ms, 0.5), quantile(all.both_ms, 0.99), quantile(all.scan_ms, 0.5),
	    quantile(all.scan_ms, 0.5) / quantile(all.both_ms, 0.5));
}
}  // namespace
}  // namespace explore::test

int main(int argc, char** argv)
{
	explore::keepFreedMemory();
	benchmark::Initialize(&argc, argv);
	if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
	explore::test::drives();  // rendering the frames is nobody's time
	benchmark::RunSpecifiedBenchmarks();
	explore::test::compareWithScan();
	return 0;
}

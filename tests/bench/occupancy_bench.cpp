// How long the map takes for a VGA frame, beside OctoMap's own insertion, and how far the two maps agree.
#include "support/octomap_peer.h"
#include "support/world_frames.h"

#include <benchmark/benchmark.h>
#include <explore/core/heap.h>
#include <explore/memory/occupancy.h>

#include <cstdio>
#include <ctime>

#include "corridor_frames.h"

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
	std::vector<DepthFrame> frames;
};

std::vector<Drive> makeDrives()
{
	std::vector<Drive> all;
	for (const double period_s : {kCameraPeriod_s, kLongPeriod_s})
		for (WorldDrive drive : ourDrives(kFrames, kWidth_px))
		{
			drive.period_s = period_s;
			all.push_back({drive.world + (period_s == kCameraPeriod_s ? " 10 Hz" : " 2 Hz"), worldFrames(drive)});
		}
	all.push_back({"analytic corridor", corridorFrames({.axial_scale = 1.0, .dropout_share = 0.02})});
	return all;
}

const std::vector<Drive>& drives()
{
	static const std::vector<Drive> kDrives = makeDrives();
	return kDrives;
}

const Drive& driveOf(const benchmark::State& state)
{
	return drives()[static_cast<std::size_t>(state.range(0))];
}

/** One drive from an empty map on. */
template <class AfterFrame>
void insertAll(benchmark::State& state, const AfterFrame& after_frame)
{
	const Drive& drive = driveOf(state);
	for ([[maybe_unused]] const auto _ : state)
	{
		Occupancy map(OccupancyConfig{});
		for (const DepthFrame& frame : drive.frames)
		{
			map.insert(frame);
			after_frame(map);
		}
		benchmark::DoNotOptimize(map.changes().data());
	}
	state.SetLabel(drive.name);
	state.counters["s_per_frame"] =
	    benchmark::Counter(static_cast<double>(drive.frames.size()),
	                       benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void insertDrive(benchmark::State& state)
{
	insertAll(state, [](const Occupancy&) {});
}

/** For who reads the octree after each frame. */
void insertDriveAndWriteTree(benchmark::State& state)
{
	insertAll(state, [](Occupancy& map) { benchmark::DoNotOptimize(map.tree().size()); });
}

/** The IoU protocol of doc/definitions.md, against plain insertion of every point. */
void agreeWithOctoMap(benchmark::State& state)
{
	const Drive& drive = driveOf(state);
	const OccupancyConfig config;
	MapAgreement found;
	for ([[maybe_unused]] const auto _ : state)
	{
		const auto reference = peerTree(config);
		Occupancy map(config);
		for (const DepthFrame& frame : drive.frames)
		{
			reference->insertPointCloud(cloudInMap(frame), cameraInMap(frame), config.range_m, true);
			map.insert(frame);
		}
		found = agreement(map.tree(), *reference);
	}
	state.SetLabel(drive.name);
	state.counters["occupied_iou"] = found.occupiedIou();
	state.counters["free_iou"] = found.freeIou();
	state.counters["wrongly_freed"] = found.wronglyFreedShare();
}

constexpr int kLastWorldDrive = 5, kLastDrive = 6;
BENCHMARK(insertDrive)->DenseRange(0, kLastDrive)->Unit(benchmark::kMillisecond);
BENCHMARK(insertDriveAndWriteTree)->DenseRange(0, kLastDrive)->Unit(benchmark::kMillisecond);
BENCHMARK(agreeWithOctoMap)->DenseRange(3, kLastWorldDrive)->Unit(benchmark::kMillisecond)->Iterations(1);

/** Processor time of this thread [ms]: what other programs do on the machine does not count. */
double now_ms()
{
	timespec time{};
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
	return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

template <class Work>
double timeOf(const Work& work)
{
	const double start_ms = now_ms();
	work();
	return now_ms() - start_ms;
}

double oursOver(const Drive& drive)
{
	return timeOf(
	    [&]
	    {
		    Occupancy map(OccupancyConfig{});
		    for (const DepthFrame& frame : drive.frames) map.insert(frame);
		    benchmark::DoNotOptimize(map.changes().data());
	    });
}

/** OctoMap takes points: they are made from the image in its time. */
double peerOver(const Drive& drive)
{
	return timeOf(
	    [&]
	    {
		    const OccupancyConfig config;
		    const auto tree = peerTree(config);
		    for (const DepthFrame& frame : drive.frames)
			    tree->insertPointCloud(cloudInMap(frame), cameraInMap(frame), config.range_m, false, true);
		    benchmark::DoNotOptimize(tree->size());
	    });
}

/** Both over each drive in turn, several times over, so that whatever slows the machine slows both. */
void compareWithOctoMap()
{
	constexpr int kRounds = 3;
	double all_ours_ms = 0, all_peer_ms = 0;
	for (const Drive& drive : drives())
	{
		double ours_ms = 0, peer_ms = 0;
		for (int round = 0; round < kRounds; ++round)
		{
			ours_ms += oursOver(drive);
			peer_ms += peerOver(drive);
		}
		const auto frames = static_cast<double>(kRounds) * static_cast<double>(drive.frames.size());
		std::printf("%-18s %5.2f ms a frame, OctoMap (discretize) %6.1f ms: %4.1f times as long\n", drive.name.c_str(),
		            ours_ms / frames, peer_ms / frames, peer_ms / ours_ms);
		all_ours_ms += ours_ms;
		all_peer_ms += peer_ms;
	}
	std::printf("all frames, one core: OctoMap takes %.1f times as long\n", all_peer_ms / all_ours_ms);
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
	explore::test::compareWithOctoMap();
	return 0;
}

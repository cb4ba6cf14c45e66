// Time of method = full for a VGA frame on one core: the whole perception, the floor carried from frame to frame.
#include "corridor_frames.h"
#include "frame_times.h"

#ifdef EXPLORE_HAVE_SIMULATION
#include "room_frames.h"
#endif

#include <benchmark/benchmark.h>
#include <explore/perception/perceive.h>

#include <cstddef>
#include <vector>

namespace explore
{
namespace
{
constexpr double kMeasured_s = 3;  // some hundred frames and more, so that the slowest hundredth is several

/** perceive() on one frame after the other, from the start again after the last; the counters median_ms and p99_ms are
 *  over all of them. */
void perceiveAll(benchmark::State& state, const std::vector<DepthFrame>& frames)
{
	const PerceptionConfig config;  // method = full
	PerceptionMemory memory;
	std::vector<double> times_ms;
	std::size_t i = 0;
	for ([[maybe_unused]] const auto _ : state)
	{
		if (i == 0) memory = {};
		const double start_ms = test::threadTime_ms();
		benchmark::DoNotOptimize(perceive(frames[i], config, {}, memory));
		times_ms.push_back(test::threadTime_ms() - start_ms);
		i = (i + 1) % frames.size();
	}
	state.counters["median_ms"] = test::quantile(times_ms, 0.5);
	state.counters["p99_ms"] = test::quantile(times_ms, 0.99);
	state.counters["frames"] = static_cast<double>(frames.size());
}

void fullOnCorridor(benchmark::State& state)
{
	static const auto kFrames = test::corridorFrames({.axial_scale = 1.0, .dropout_share = 0.02});
	perceiveAll(state, kFrames);
}
BENCHMARK(fullOnCorridor)->Unit(benchmark::kMillisecond)->MinTime(kMeasured_s);

#ifdef EXPLORE_HAVE_SIMULATION
void fullInRooms(benchmark::State& state)
{
	static const auto kFrames = test::roomFrames();
	perceiveAll(state, kFrames);
}
BENCHMARK(fullInRooms)->Unit(benchmark::kMillisecond)->MinTime(kMeasured_s);
#endif
}  // namespace
}  // namespace explore

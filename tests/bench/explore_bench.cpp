// Time per VGA frame of method = paper: step() as a whole, each of its stages, and the same pipeline on PCL where that
// is built in. full_bench.cpp adds method = full.
#include "corridor_frames.h"

#ifdef EXPLORE_HAVE_PCL
#include "compare_with_pcl.h"
#include "paper_with_pcl.h"
#endif

#include <benchmark/benchmark.h>
#include <explore/core/heap.h>
#include <explore/perception/near_field.h>
#include <explore/perception/obstacles.h>
#include <explore/pipeline/explorer.h>

#include <algorithm>
#include <iterator>
#include <vector>

using namespace explore;

namespace
{
const std::vector<DepthFrame>& frames()
{
	static const auto kFrames = test::corridorFrames({.axial_scale = 1.0, .dropout_share = 0.02});
	return kFrames;
}

const ExplorerConfig& config()
{
	static const ExplorerConfig kConfig = []
	{
		ExplorerConfig paper;
		paper.perception.method = PerceptionMethod::paper;  // what the peer does
		return paper;
	}();
	return kConfig;
}

/** What each stage of perceive() gets from those before it. */
struct Stages
{
	PointCloud in_range, voxels, obstacles;
	std::optional<FoundPlane> ground;
	std::vector<WallPatch> walls;
	GoalChoice goal;
	Eigen::Vector3d camera_in_robot;
};

Stages stagesOf(const DepthFrame& frame)
{
	const PerceptionConfig& perception = config().perception;
	RandomEngine random(1);
	Stages stages;
	stages.camera_in_robot = isometryOf(frame.robot_from_camera).translation();
	stages.in_range = rangeFilter(frame, perception.range_filter);
	stages.voxels = voxelGrid(stages.in_range, perception.voxel_grid);
	stages.ground = findGround(stages.voxels, {Eigen::Vector3d::UnitZ(), stages.camera_in_robot}, perception.ground,
	                           perception.planes, random);
	stages.obstacles = obstaclePoints(stages.voxels, stages.ground);
	stages.walls = findWalls(stages.obstacles, stages.voxels.size(), stages.ground.value().plane,
	                         stages.camera_in_robot, perception.walls, perception.planes, random);
	ExplorerState state;
	stages.goal = chooseGoal(step(frame, state, config()).percepts, config().robot);
	return stages;
}

const std::vector<Stages>& prepared()
{
	static const auto kPrepared = []
	{
		std::vector<Stages> all;
		std::ranges::transform(frames(), std::back_inserter(all), stagesOf);
		return all;
	}();
	return kPrepared;
}

/** Runs `work(i)` for one frame after the other; items per second are frames per second. */
template <class Work>
void overFrames(benchmark::State& state, const Work& work)
{
	std::size_t i = 0;
	for ([[maybe_unused]] const auto _ : state)
	{
		benchmark::DoNotOptimize(work(i));
		i = (i + 1) % frames().size();
	}
	state.SetItemsProcessed(state.iterations());
}

StepResult stepOnce(const DepthFrame& frame)
{
	ExplorerState state;
	return step(frame, state, config());
}

void wholeStep(benchmark::State& state)
{
	overFrames(state, [](std::size_t i) { return stepOnce(frames()[i]); });
}

void rangeFilterStage(benchmark::State& state)
{
	overFrames(state, [](std::size_t i) { return rangeFilter(frames()[i], config().perception.range_filter); });
}

void voxelGridStage(benchmark::State& state)
{
	overFrames(state, [](std::size_t i) { return voxelGrid(prepared()[i].in_range, config().perception.voxel_grid); });
}

void groundStage(benchmark::State& state)
{
	const PerceptionConfig& perception = config().perception;
	overFrames(state,
	           [&](std::size_t i)
	           {
		           RandomEngine random(1);
		           return findGround(prepared()[i].voxels, {Eigen::Vector3d::UnitZ(), prepared()[i].camera_in_robot},
		                             perception.ground, perception.planes, random);
	           });
}

void wallsStage(benchmark::State& state)
{
	const PerceptionConfig& perception = config().perception;
	overFrames(state,
	           [&](std::size_t i)
	           {
		           RandomEngine random(1);
		           const Stages& before = prepared()[i];
		           return findWalls(before.obstacles, before.voxels.size(), before.ground->plane,
		                            before.camera_in_robot, perception.walls, perception.planes, random);
	           });
}

void doorsStage(benchmark::State& state)
{
	overFrames(state,
	           [](std::size_t i)
	           {
		           std::size_t doors = 0;
		           for (const WallPatch& wall : prepared()[i].walls)
			           doors += findDoors(wall, prepared()[i].ground->plane, config().perception.door_gaps).size();
		           return doors;
	           });
}

void nearFieldStage(benchmark::State& state)
{
	overFrames(state, [](std::size_t i) { return nearField(frames()[i], prepared()[i].ground->plane); });
}

void vanishingPointStage(benchmark::State& state)
{
	overFrames(state,
	           [](std::size_t i)
	           {
		           const Stages& before = prepared()[i];
		           return findVanishingPoints(before.walls, before.ground->plane, before.camera_in_robot,
		                                      config().perception.vanishing_points);
	           });
}

void avoidStage(benchmark::State& state)
{
	overFrames(state,
	           [](std::size_t i)
	           {
		           const Stages& before = prepared()[i];
		           AvoiderInput input;
		           input.obstacles_in_robot = &before.obstacles;
		           input.ground = before.ground->plane;
		           input.desired_rad = before.goal.desired_rad;
		           return avoid(input, config().robot, config().avoider);
	           });
}

BENCHMARK(wholeStep)->Unit(benchmark::kMillisecond);
BENCHMARK(rangeFilterStage)->Unit(benchmark::kMillisecond);
BENCHMARK(voxelGridStage)->Unit(benchmark::kMillisecond);
BENCHMARK(groundStage)->Unit(benchmark::kMillisecond);
BENCHMARK(wallsStage)->Unit(benchmark::kMillisecond);
BENCHMARK(doorsStage)->Unit(benchmark::kMillisecond);
BENCHMARK(vanishingPointStage)->Unit(benchmark::kMillisecond);
BENCHMARK(nearFieldStage)->Unit(benchmark::kMillisecond);
BENCHMARK(avoidStage)->Unit(benchmark::kMillisecond);

#ifdef EXPLORE_HAVE_PCL
void wholeStepWithPcl(benchmark::State& state)
{
	overFrames(state, [](std::size_t i) { return test::exploreWithPcl(frames()[i], config()); });
}
BENCHMARK(wholeStepWithPcl)->Unit(benchmark::kMillisecond);
#endif
}  // namespace

int main(int argc, char** argv)
{
	keepFreedMemory();
	benchmark::Initialize(&argc, argv);
	if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
	prepared();  // rendering the frames is nobody's time
	benchmark::RunSpecifiedBenchmarks();
#ifdef EXPLORE_HAVE_PCL
	test::compareWithPcl(frames(), config());
#endif
	return 0;
}

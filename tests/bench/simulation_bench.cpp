// How long the simulated camera takes for a frame in a world of about 150,000 triangles, on one core.
#include <benchmark/benchmark.h>
#include <explore/simulation/depth_camera.h>
#include <explore/simulation/noise_random.h>
#include <explore/simulation/shapes.h>

#include <array>
#include <cmath>
#include <vector>

namespace explore::simulation
{
namespace
{
/** A hall of 20 m × 10 m with round things of many facets standing and lying about. */
World crowdedHall(int moving)
{
	World world;
	const std::size_t wall = world.materialNamed("wall"), thing = world.materialNamed("thing");
	const auto put = [&](const TriangleMesh& mesh, const Eigen::Vector3d& at, std::size_t material)
	{
		TriangleMesh placed;
		append(placed, mesh, Eigen::Isometry3d(Eigen::Translation3d(at)));
		world.add("body", placed, material);
	};
	put(boxMesh({20.0, 10.0, 3.0}), {8.0, 0.0, 1.5}, wall);
	for (int i = 0; i < 6; ++i) put(boxMesh({0.2, 3.0, 3.0}), {3.0 + 2.0 * i, i % 2 == 0 ? 3.5 : -3.5, 1.5}, wall);
	const NoiseKey key = noiseKey(1, 1);
	const TriangleMesh ball = sphereMesh(0.3, 24), post = cylinderMesh(0.1, 1.0, 96);
	for (std::uint32_t i = 0; world.mesh.triangles.size() < 150'000; ++i)
		put(i % 3 == 0 ? post : ball,
		    {-1.5 + 19.0 * noiseUniform(key, 3 * i), -4.8 + 9.6 * noiseUniform(key, 3 * i + 1),
		     2.4 * noiseUniform(key, 3 * i + 2)},
		    thing);
	for (int i = 0; i < moving; ++i)
	{
		MovingBody person;
		person.mesh = capsuleMesh(0.25, 1.2);
		person.material = thing;
		person.track.push_back({0.0, {2.0 + i, 0.5 * i - 1.0}, 0.85, 0.0});
		world.moving.push_back(person);
	}
	return world;
}

/** Views from several places, one after the other: a frame's time depends on what it shows. */
class Views
{
public:
	explicit Views(const RayScene& scene) : m_scene(scene) {}
	CameraShot next(const DepthCameraConfig& config)
	{
		const double yaw = 0.3 * std::sin(static_cast<double>(m_shot));
		Eigen::Isometry3d map_from_camera(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
		map_from_camera.pretranslate(Eigen::Vector3d(-1.8 + 0.1 * static_cast<double>(m_shot % 8), 0.0, 0.9));
		return takeShot(m_scene, config, map_from_camera, m_shot++);
	}

private:
	const RayScene& m_scene;
	std::uint64_t m_shot = 0;
};

void takeShots(benchmark::State& state, NoiseModel noise, int moving, SameRays same = SameRays::on_every_processor)
{
	const World world = crowdedHall(moving);
	const RayScene scene(world, same);
	Views views(scene);
	DepthCameraConfig config = depthCamera("xtion", static_cast<int>(state.range(0)));
	config.noise = noise;
	for (auto _ : state) benchmark::DoNotOptimize(views.next(config).depth.depth_m.data());
	state.counters["triangles"] = static_cast<double>(world.mesh.triangles.size());
}

void exactShot(benchmark::State& state)
{
	takeShots(state, NoiseModel::none, 0);
}
void kinectShot(benchmark::State& state)
{
	takeShots(state, NoiseModel::kinect, 0);
}
void kinectShotFastest(benchmark::State& state)
{
	takeShots(state, NoiseModel::kinect, 0, SameRays::on_this_processor);
}
void kinectShotWithPeople(benchmark::State& state)
{
	takeShots(state, NoiseModel::kinect, 5);
}
void speckleShot(benchmark::State& state)
{
	takeShots(state, NoiseModel::speckle, 0);
}

void bakeWorld(benchmark::State& state)
{
	const World world = crowdedHall(0);
	for (auto _ : state) benchmark::DoNotOptimize(RayScene(world).clearance({0, 0, 1}, 1.0));
}

void touchCylinder(benchmark::State& state)
{
	const World world = crowdedHall(5);
	const RayScene scene(world);
	double x = 0.0;
	for (auto _ : state)
	{
		x = x > 12.0 ? 0.0 : x + 0.037;
		benchmark::DoNotOptimize(scene.touchesCylinder({x, 0.2, 0.05}, 0.22, 0.55));
	}
}

void placePeople(benchmark::State& state)
{
	const World world = crowdedHall(5);
	RayScene scene(world);
	std::vector<Eigen::Isometry3d> places(5, Eigen::Isometry3d::Identity());
	for (auto _ : state)
	{
		for (auto& place : places) place.pretranslate(Eigen::Vector3d(0.001, 0.0, 0.0));
		scene.place(places);
	}
}

BENCHMARK(exactShot)->Arg(320)->Arg(640)->Unit(benchmark::kMillisecond);
BENCHMARK(kinectShot)->Arg(320)->Arg(640)->Unit(benchmark::kMillisecond);
BENCHMARK(kinectShotFastest)->Arg(320)->Arg(640)->Unit(benchmark::kMillisecond);
BENCHMARK(kinectShotWithPeople)->Arg(640)->Unit(benchmark::kMillisecond);
BENCHMARK(speckleShot)->Arg(640)->Unit(benchmark::kMillisecond);
BENCHMARK(bakeWorld)->Unit(benchmark::kMillisecond);
BENCHMARK(touchCylinder)->Unit(benchmark::kMicrosecond);
BENCHMARK(placePeople)->Unit(benchmark::kMicrosecond);
}  // namespace
}  // namespace explore::simulation

BENCHMARK_MAIN();

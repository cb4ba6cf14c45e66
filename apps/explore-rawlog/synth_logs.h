// Writes the logs of explore-rawlog synth, several at a time.
#pragma once

#include <explore/simulation/depth_camera.h>
#include <explore/simulation/scenes/scene_families.h>

#include <filesystem>
#include <functional>
#include <vector>

namespace explore::app
{
/** What all logs have in common. */
struct SynthConfig
{
	std::uint64_t seed = 1;
	int count = 1, looks = 1;
	simulation::DepthCameraConfig camera;
	std::filesystem::path out;  ///< the folder; made where it is missing
};

/** One log: the scenes of a family for one kind of robot. */
struct SynthTask
{
	const simulation::SceneFamily* family = nullptr;
	RobotKind robot = RobotKind::ground;
};
/** `<out>/<family>-<robot>.rawlog` */
std::filesystem::path logPathOf(const SynthTask& task, const SynthConfig& config);
/** The command that makes the same log again, in the folder where it is run. */
std::string commandOf(const SynthTask& task, const SynthConfig& config);

/** Writes log and truth of each task, `jobs` at a time. `written` is called for each, in the order of `tasks`, as soon
 *  as it and those before it are there. Throws the error of the first task that failed; later ones may be missing. */
void writeLogs(const std::vector<SynthTask>& tasks, const SynthConfig& config, int jobs,
               const std::function<void(const SynthTask&)>& written);
}  // namespace explore::app

// Logs of random scenes: what the sensors of a robot say in one scene after another, and the truth.
#pragma once

#include <explore/simulation/recorder.h>
#include <explore/simulation/scenes/scene_families.h>

namespace explore::simulation
{
struct SceneLogConfig
{
	std::uint64_t seed = 1;
	int count = 1;  ///< scenes; more of them leave the first ones as they are
	int looks = 1;  ///< frames a scene
	RobotConfig robot;
	DepthCameraConfig camera;
	mrpt::Clock::time_point start;  ///< around the first look; scenes are more than 10 s apart
};

/** Scene after scene: a depth image a look, at its time the pose as the robot believes it (odometry on wheels, else a
 *  state estimate with a tilt error of 0.5°), IMU readings around it. Of the truth, `command` is left for the caller;
 *  ids of doors begin with the scene's number. The same arguments give the same observations. */
TruthLog recordScenes(const SceneFamily& family, const SceneLogConfig& config, const ObservationSink& sink);
}  // namespace explore::simulation

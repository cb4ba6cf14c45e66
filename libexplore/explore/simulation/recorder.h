// Records what a carried camera, odometry and IMU see of a simulated world, with the truth beside it.
#pragma once

#include <explore/core/truth.h>
#include <explore/simulation/carriers.h>
#include <explore/simulation/depth_camera.h>
#include <mrpt/obs/CObservation.h>

#include <functional>

namespace explore::simulation
{
struct RecorderConfig
{
	DepthCameraConfig camera;
	RobotConfig robot;
	double imu_rate_hz = 50;
	mrpt::poses::CPose3D robot_from_camera;
	mrpt::Clock::time_point start;  ///< time of the first frame
	double seconds = 0;             ///< at most; 0 = until the carrier has finished
	std::uint64_t seed = 0;
};

/** The mount of a robot of this kind that nobody described: a ground robot's 0.5 m up, both level and a little ahead of
 *  the centre. */
mrpt::poses::CPose3D usualMount(RobotKind kind);

/** Time of a run's first frame that no recorded poses give, seconds since 1970: fixed, so that the same command gives
 * the same bytes. */
inline constexpr double kUsualStart_s = 1'600'000'000.0;

/** `t_s` after the start. */
mrpt::Clock::time_point timeOf(const RecorderConfig& config, double t_s);
/** What the camera's frames are labelled with. */
std::string sensorLabel(const DepthCameraConfig& camera);
/** What the camera sees in the run's frame number `frame`, the robot being there. */
CameraShot takeFrame(const RayScene& scene, const RecorderConfig& config, const mrpt::poses::CPose3D& map_from_robot,
                     std::size_t frame);
/** The reading as the recorder writes it. */
mrpt::obs::CObservation::Ptr imuObservation(const RecorderConfig& config, const ImuReading& reading, double t_s);

/** Takes each observation as it is made, by time. */
using ObservationSink = std::function<void(const mrpt::obs::CObservation&)>;

/** From the start until the carrier has finished: a depth image at the camera's rate, the estimated pose just before it
 *  (odometry for a ground robot, else a robot pose), IMU readings at theirs. Returns the truth of each frame, with
 *  robot, noise, seed, intrinsics and mount; world, family and command are left for the caller. The same arguments
 *  give the same observations. */
TruthLog record(RayScene& scene, Carrier& carrier, const RecorderConfig& config, const ObservationSink& sink);
}  // namespace explore::simulation

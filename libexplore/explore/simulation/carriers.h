// What carries the camera while a log is recorded: a list of poses, or a robot that drives a route.
#pragma once

#include <explore/simulation/path_follower.h>
#include <explore/simulation/simulated_robot.h>

#include <memory>
#include <string>
#include <vector>

namespace explore::simulation
{
class Carrier
{
public:
	virtual ~Carrier() = default;
	/** Goes on to that time after the start; times do not decrease. */
	virtual void advanceTo(double t_s) = 0;
	/** True once there is nothing more to record. */
	[[nodiscard]] virtual bool finished() const = 0;
	[[nodiscard]] virtual mrpt::poses::CPose3D truePose() const = 0;
	/** map_from_robot as the robot has it. */
	[[nodiscard]] virtual mrpt::poses::CPose3D estimate() const = 0;
	[[nodiscard]] virtual ImuReading imu() const = 0;
	/** What a person should know about the way so far. */
	[[nodiscard]] virtual std::vector<std::string> warnings() const = 0;
};

struct PathPose
{
	double t_s = 0;  ///< after the start
	mrpt::poses::CPose3D map_from_robot;
};

/** Moves exactly along given poses, straight on and by slerp between them: nothing stops it, but where the robot's body
 *  touches something or is out of the world's bounds is told. The IMU shows attitude and turning; a list of poses has
 * no accelerations. People stop before it as before a robot. `scene` outlives it. Throws ConfigError without poses or
 *  where their times do not increase. */
std::unique_ptr<Carrier> carrierOnPath(RayScene& scene, const RobotConfig& robot, const SimulatedRobotConfig& config,
                                       std::vector<PathPose> path, std::uint64_t seed);

/** A simulated robot with dynamics, limits and contacts that follows `route` from its first point on, facing the
 * second. It stands still while something is in its way, and gives up after 15 s of that. `scene` outlives it. Throws
 *  ConfigError for a route of fewer than two points that differ, or where the robot does not fit at the first. */
std::unique_ptr<Carrier> carrierOnRoute(RayScene& scene, const RobotConfig& robot, const SimulatedRobotConfig& config,
                                        const Route& route, std::uint64_t seed);
}  // namespace explore::simulation

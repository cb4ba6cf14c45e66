// Which way is up before the floor is looked for: IMU, recorded pose, the last floor or the mount, and what the
// surfaces in view say about it (remedy 9).
#pragma once

#include <explore/perception/ground_memory.h>
#include <explore/perception/sample_grid.h>
#include <explore/perception/sensor_noise.h>

namespace explore
{
/** Standard deviations of what each source says, any direction. */
struct UpPriorConfig
{
	double imu_sigma_rad = 0.017453292519943295;         ///< 1°
	double pose_sigma_rad = 0.017453292519943295;        ///< 1°
	double mount_sigma_rad = 0.03490658503988659;        ///< 2°, ground robot
	double flying_mount_sigma_rad = 0.2617993877991494;  ///< 15°, MAV
};
void describe(FieldVisitor& fields, UpPriorConfig& config);

enum class UpOrigin
{
	imu,
	pose,
	memory,
	mount,
	surfaces  ///< floors and walls in view that contradict what was recorded
};

struct UpPrior
{
	Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< unit, against gravity; the user of the struct names the frame
	double sigma_rad = 0;
	UpOrigin origin = UpOrigin::mount;
};

/** The best recorded source, robot frame: IMU, else the roll and pitch of a robot pose, else the remembered floor, else
 *  the mount. A source that has the robot lie on its side (more than 60° off) is passed over. */
UpPrior recordedUp(const DepthFrame& frame, const RobotConfig& robot, const std::optional<UncertainGround>& remembered,
                   const UpPriorConfig& config);

/** `prior` (camera frame) corrected by the surfaces in view: floors and tables face up, walls sideways. Within its
 *  uncertainty the two are fused; further off the surfaces win only where they are dominant and the prior fits them
 *  clearly worse (origin `surfaces` then), as a recorded source can be wrong. */
UpPrior refineUp(const UpPrior& prior, const SampleGrid& grid, const SensorNoiseConfig& noise);
}  // namespace explore

// What a robot believes about its pose and motion: odometry or a state estimate that drifts, and an IMU.
#pragma once

#include <explore/config/simulated_robot.h>
#include <explore/core/robot.h>
#include <explore/simulation/random.h>
#include <explore/simulation/robot_motion.h>

#include <type_traits>

namespace explore::simulation
{
static_assert(std::has_unique_object_representations_v<Random>, "archives take its bytes for its value");

/** Adds up a robot's true movements with errors. A ground robot knows x, y and yaw from its wheels; a MAV's filter also
 *  knows its altitude, roll and pitch, whose errors do not grow. */
class Odometry
{
public:
	/** Begins without error. */
	Odometry(const OdometryConfig& config, RobotKind kind, const mrpt::poses::CPose3D& map_from_start,
	         std::uint64_t seed);

	/** From the last true pose (at first map_from_start) to this one, within `dt_s`. However a way is cut into steps,
	 * the error's distribution is the same. */
	void moveTo(const mrpt::poses::CPose3D& map_from_robot, double dt_s);
	[[nodiscard]] mrpt::poses::CPose3D estimate() const;
	/** Writes or reads what moveTo() changes. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_true), archive(m_position), archive(m_yaw_rad);
		for (Wander* wander : {&m_height, &m_pitch, &m_roll}) archive(wander->value);
		archive.raw(&m_random, sizeof(m_random));
	}

private:
	/** An error that wanders within its standard deviation and forgets within about a second. */
	struct Wander
	{
		double value = 0;
		void advance(Random& random, double sigma, double dt_s);
	};

	OdometryConfig m_config;
	RobotKind m_kind;
	mrpt::poses::CPose3D m_true;
	Eigen::Vector2d m_position;
	double m_yaw_rad;
	Wander m_height, m_pitch, m_roll;
	Random m_random;
};

struct ImuReading
{
	Eigen::Vector3d specific_force_mps2 = Eigen::Vector3d::Zero();  ///< in the robot frame; at rest 9.81 upward
	Eigen::Vector3d rate_radps = Eigen::Vector3d::Zero();           ///< in the robot frame
};

class Imu
{
public:
	Imu(const ImuConfig& config, std::uint64_t seed);

	/** The mean of `dt_s` > 0 that lead from one pose to the other under `acceleration_mps2` (map axes), with errors.
	 */
	ImuReading read(const mrpt::poses::CPose3D& map_from_before, const mrpt::poses::CPose3D& map_from_robot,
	                const Eigen::Vector3d& acceleration_mps2, double dt_s);
	/** Writes or reads what read() changes; the biases follow from the seed. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive.raw(&m_random, sizeof(m_random));
	}

private:
	Eigen::Vector3d noise(double sigma);

	ImuConfig m_config;
	Random m_random;
	Eigen::Vector3d m_acceleration_bias, m_rate_bias;
};
}  // namespace explore::simulation

// Which way is up, from a recorded accelerometer.
#include <mrpt/obs/CObservationIMU.h>

#include <cmath>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
using mrpt::poses::CPose3D;

Objects::value_type imu(double seconds, const Eigen::Vector3d& acceleration_mps2, const CPose3D& robot_from_imu = {},
                        const std::string& label = "IMU")
{
	auto observation = mrpt::obs::CObservationIMU::Create();
	observation->timestamp = at(seconds);
	observation->sensorLabel = label;
	observation->sensorPose = robot_from_imu;
	observation->set(mrpt::obs::IMU_X_ACC, acceleration_mps2.x());
	observation->set(mrpt::obs::IMU_Y_ACC, acceleration_mps2.y());
	observation->set(mrpt::obs::IMU_Z_ACC, acceleration_mps2.z());
	return observation;
}

std::optional<Eigen::Vector3d> upOf(const Objects& readings, bool use = true, Listener* listener = nullptr)
{
	Objects objects = {scanOf(sceneFrame(), 1.0)};
	objects.insert(objects.end(), readings.begin(), readings.end());
	const auto log = testFolder() / "imu.rawlog";
	writeRawlog(log, objects);
	SourceConfig config = configFor(log);
	config.gravity_from_imu = use;
	return replay(config, nullptr, listener).at(0).up_in_robot;
}

void expectDirection(const std::optional<Eigen::Vector3d>& up, const Eigen::Vector3d& truth)
{
	ASSERT_TRUE(up);
	EXPECT_LT((*up - truth.normalized()).norm(), 1e-9) << up->transpose();
}

TEST(Gravity, IsTheMeanAccelerationAroundTheFrame)
{
	// Outside ±0.1 s other readings must not count, and the frame waits for those that come after it.
	expectDirection(
	    upOf({imu(0.85, {9.8, 0, 0}), imu(0.95, {0.5, 0.2, 9.7}), imu(1.02, {-0.5, 0.4, 9.9}), imu(1.2, {9.8, 0, 0})}),
	    {0, 0.3, 9.8});
}

TEST(Gravity, IsTurnedFromTheSensorIntoTheRobot)
{
	const double pitch_rad = 0.3;
	// A sensor that looks down by 0.3 rad on a level robot feels the way up partly behind itself.
	expectDirection(
	    upOf({imu(1, {-9.8 * std::sin(pitch_rad), 0, 9.8 * std::cos(pitch_rad)}, CPose3D(0, 0, 0, 0, pitch_rad, 0))}),
	    {0, 0, 1});
}

TEST(Gravity, IsNotTakenWhileTheRobotAcceleratesHard)
{
	EXPECT_FALSE(upOf({imu(1, {7, 0, 9.8})}));
}
TEST(Gravity, IsNotTakenFromAReadingThatIsNotFinite)
{
	EXPECT_FALSE(upOf({imu(1, {NAN, 0, 9.8})}));
}
TEST(Gravity, IsNotThereWithoutAReadingNearby)
{
	EXPECT_FALSE(upOf({imu(1.5, {0, 0, 9.8})}));
}
TEST(Gravity, IsNotTakenWhereSwitchedOff)
{
	EXPECT_FALSE(upOf({imu(1, {0, 0, 9.8})}, false));
}

TEST(Gravity, OfTwoSensorsTheFirstCounts)
{
	Listener listener;
	expectDirection(upOf({imu(1, {0, 0, 9.8}), imu(1, {9.8, 0, 0}, {}, "SECOND")}, true, &listener), {0, 0, 1});
	EXPECT_EQ(listener.warnings("'SECOND' is not"), 1U);
}
}  // namespace
}  // namespace explore::test

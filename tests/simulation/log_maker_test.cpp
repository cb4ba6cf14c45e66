// Observations of the simulator as MRPT and our own source read them, and whole recordings.
#include <explore/simulation/log_maker.h>
#include <explore/simulation/recorder.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include <gmock/gmock.h>

#include <cmath>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using namespace mrpt::obs;
using mrpt::poses::CPose3D;

namespace
{
const auto kTime = mrpt::Clock::fromDouble(1'600'000'000.25);

CameraShot shotOf(bool color)
{
	CameraShot shot;
	shot.depth.intrinsics = {4, 3, 5.5, 5.25, 1.5, 1.25};
	shot.depth.depth_m = {0.0F, 0.5F, 1.2344F, 1.2346F, 65.535F, 65.6F, 2, 3, 4, 5, 6, 7};
	if (color)
		for (int i = 0; i < 12; ++i) shot.rgb.insert(shot.rgb.end(), {200, 100, 20});
	return shot;
}

std::string bytesOf(const std::vector<CObservation::Ptr>& observations)
{
	mrpt::io::CMemoryStream stream;
	for (const auto& observation : observations) mrpt::serialization::archiveFrom(stream).WriteObject(*observation);
	return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

/** What was recorded: copies of the observations. */
struct Recorded
{
	std::vector<CObservation::Ptr> observations;
	TruthLog truth;

	template <class Class>
	[[nodiscard]] std::vector<std::shared_ptr<const Class>> all() const
	{
		std::vector<std::shared_ptr<const Class>> found;
		for (const auto& observation : observations)
			if (auto match = std::dynamic_pointer_cast<const Class>(observation)) found.push_back(match);
		return found;
	}
};

RecorderConfig configOf(RobotKind kind)
{
	RecorderConfig config;
	config.camera = depthCamera("kinect", 64);
	config.camera.rate_hz = 5;
	config.camera.color = true;
	config.robot.kind = kind;
	if (kind == RobotKind::mav) config.robot.height_m = 0.25;
	config.robot_from_camera = usualMount(kind);
	config.start = kTime;
	config.seed = 7;
	return config;
}

Recorded recordedOn(const Route& route, const RecorderConfig& config)
{
	const World world = worldWith({.face_x = 4.0});
	RayScene scene(world);
	const auto carrier = carrierOnRoute(scene, config.robot, {}, route, config.seed);
	Recorded recorded;
	recorded.truth = record(scene, *carrier, config,
	                        [&](const CObservation& observation)
	                        {
		                        auto copy = std::dynamic_pointer_cast<CObservation>(observation.duplicateGetSmartPtr());
		                        recorded.observations.push_back(copy);
	                        });
	return recorded;
}
const Route kDriveAhead{"ahead", {{0, 0, 0}, {1.5, 0, 0}}};
}  // namespace

TEST(LogMaker, DepthIsStoredInMillimetres)
{
	const CPose3D mount(0.1, 0, 0.5, 0.2, 0.1, 0);
	const auto scan =
	    std::dynamic_pointer_cast<CObservation3DRangeScan>(depthObservation(shotOf(false), mount, kTime, "XTION"));
	ASSERT_TRUE(scan);
	EXPECT_EQ(scan->timestamp, kTime);
	EXPECT_EQ(scan->sensorLabel, "XTION");
	EXPECT_EQ(scan->sensorPose, mount);
	EXPECT_TRUE(scan->hasRangeImage && scan->range_is_depth);
	EXPECT_FALSE(scan->hasIntensityImage);
	EXPECT_FLOAT_EQ(scan->rangeUnits, 0.001F);
	ASSERT_EQ(scan->rangeImage.rows(), 3);
	ASSERT_EQ(scan->rangeImage.cols(), 4);
	EXPECT_EQ(scan->rangeImage(0, 0), 0);
	EXPECT_EQ(scan->rangeImage(0, 1), 500);
	EXPECT_EQ(scan->rangeImage(0, 2), 1234);
	EXPECT_EQ(scan->rangeImage(0, 3), 1235);
	EXPECT_EQ(scan->rangeImage(1, 0), 65535);
	EXPECT_EQ(scan->rangeImage(1, 1), 0) << "beyond what 16 bits hold";
	EXPECT_EQ(scan->rangeImage(2, 3), 7000);
	EXPECT_DOUBLE_EQ(scan->cameraParams.fx(), 5.5);
	EXPECT_DOUBLE_EQ(scan->cameraParams.cy(), 1.25);
	EXPECT_EQ(scan->cameraParams.ncols, 4U);
}

TEST(LogMaker, ColourComesAlongAndSurvivesTheFile)
{
	const auto scan =
	    std::dynamic_pointer_cast<CObservation3DRangeScan>(depthObservation(shotOf(true), {}, kTime, "XTION"));
	const std::string bytes = bytesOf({scan});
	EXPECT_EQ(bytes, bytesOf({scan}));
	mrpt::io::CMemoryStream stream(bytes.data(), bytes.size());
	const auto read = mrpt::serialization::archiveFrom(stream).ReadObject<CObservation3DRangeScan>();
	ASSERT_TRUE(read->hasIntensityImage);
	EXPECT_EQ(read->rangeImage(2, 3), 7000);
	ASSERT_EQ(read->intensityImage.getWidth(), 4U);
	// Red, green, blue as they were given; the file keeps them as JPEG.
	EXPECT_NEAR(read->intensityImage.at<std::uint8_t>(1, 1, 2), 200, 8);
	EXPECT_NEAR(read->intensityImage.at<std::uint8_t>(1, 1, 1), 100, 8);
	EXPECT_NEAR(read->intensityImage.at<std::uint8_t>(1, 1, 0), 20, 8);
}

TEST(LogMaker, PosesAndImu)
{
	const CPose3D pose(1, 2, 3, 0.4, 0.1, -0.2);
	EXPECT_EQ(std::dynamic_pointer_cast<CObservationRobotPose>(poseObservation(pose, kTime, "STATE"))->pose.mean, pose);
	const auto odometry =
	    std::dynamic_pointer_cast<CObservationOdometry>(odometryObservation(pose, kTime, "ODOMETRY"))->odometry;
	EXPECT_EQ(odometry, mrpt::poses::CPose2D(1, 2, 0.4));
	const auto imu = std::dynamic_pointer_cast<CObservationIMU>(imuObservation({1, 2, 3}, {4, 5, 6}, kTime, "IMU"));
	EXPECT_EQ(imu->get(IMU_Y_ACC), 2);
	EXPECT_EQ(imu->get(IMU_WZ), 6);
}

TEST(Recorder, WritesFramesOdometryAndImuAtTheirRatesByTime)
{
	const Recorded log = recordedOn(kDriveAhead, configOf(RobotKind::ground));
	const auto scans = log.all<CObservation3DRangeScan>();
	const auto odometry = log.all<CObservationOdometry>();
	const auto imu = log.all<CObservationIMU>();
	ASSERT_GT(scans.size(), 15U);
	ASSERT_EQ(scans.size(), log.truth.frames.size());
	ASSERT_EQ(scans.size(), odometry.size());
	EXPECT_EQ(imu.size(), 10 * (scans.size() - 1) + 1);
	for (std::size_t i = 1; i < log.observations.size(); ++i)
		EXPECT_GE(log.observations[i]->timestamp, log.observations[i - 1]->timestamp);
	for (std::size_t i = 0; i < scans.size(); ++i)
	{
		const TruthFrame& truth = log.truth.frames[i];
		EXPECT_NEAR(truth.t, 1'600'000'000.25 + 0.2 * static_cast<double>(i), 1e-6);
		EXPECT_EQ(mrpt::Clock::toDouble(scans[i]->timestamp), truth.t);
		EXPECT_EQ(odometry[i]->timestamp, scans[i]->timestamp);
		EXPECT_EQ(truth.index, i);
		EXPECT_NEAR(odometry[i]->odometry.x(), truth.map_from_robot.x(), 0.06);
		EXPECT_TRUE(truth.free_paths.has_value());
		EXPECT_EQ(truth.doors.size(), 1U);
	}
	EXPECT_EQ(log.truth.noise, "kinect");
	EXPECT_EQ(log.truth.seed, 7U);
	EXPECT_EQ(log.truth.intrinsics.width_px, 64);
	EXPECT_EQ(log.truth.robot_from_camera, usualMount(RobotKind::ground));
	EXPECT_NEAR(log.truth.frames.back().map_from_robot.x(), 1.5, 0.1);
}

TEST(Recorder, DepthIsThatOfTheTruePose)
{
	RecorderConfig config = configOf(RobotKind::ground);
	config.camera.noise = NoiseModel::none;
	const Recorded log = recordedOn(kDriveAhead, config);
	const auto scans = log.all<CObservation3DRangeScan>();
	for (std::size_t i = 0; i < scans.size(); ++i)
	{
		const CPose3D& robot = log.truth.frames[i].map_from_robot;
		// The wall beside the door, its face at x = 4: the pixel's ray ends there.
		const auto& camera = scans[i]->cameraParams;
		const Vector3d ray = rayOfPixel(log.truth.intrinsics, 8, camera.cy());
		const double yaw = robot.yaw(), toward_wall = std::cos(yaw) * ray.x() - std::sin(yaw) * ray.y();
		const double depth = (4.0 - robot.x() - 0.1 * std::cos(yaw)) / toward_wall;
		EXPECT_NEAR(0.001 * scans[i]->rangeImage(static_cast<int>(std::lround(camera.cy())), 8), depth, 0.02) << i;
	}
}

TEST(Recorder, AMavWritesRobotPoses)
{
	const Recorded log = recordedOn({"fly", {{0, 0, 1}, {1, 0.5, 1.4}}}, configOf(RobotKind::mav));
	EXPECT_EQ(log.all<CObservationRobotPose>().size(), log.truth.frames.size());
	EXPECT_TRUE(log.all<CObservationOdometry>().empty());
	EXPECT_EQ(log.truth.frames.front().free_paths->elevations_rad.size(), 7U);
	EXPECT_NEAR(log.truth.frames.back().map_from_robot.z(), 1.4, 0.1);
}

TEST(Recorder, StopsAfterTheAskedTime)
{
	RecorderConfig config = configOf(RobotKind::ground);
	config.seconds = 1.0;
	EXPECT_EQ(recordedOn(kDriveAhead, config).truth.frames.size(), 6U);
}

TEST(Recorder, TheSameArgumentsGiveTheSameBytesOnAnyNumberOfThreads)
{
	RecorderConfig config = configOf(RobotKind::ground);
	config.seconds = 1.0;
	const std::string one = bytesOf(recordedOn(kDriveAhead, config).observations);
	config.camera.threads = 3;
	EXPECT_TRUE(one == bytesOf(recordedOn(kDriveAhead, config).observations));
	config.seed = 8;
	EXPECT_FALSE(one == bytesOf(recordedOn(kDriveAhead, config).observations));
}

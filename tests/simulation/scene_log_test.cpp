// Logs of random scenes: their observations, times and truth.
#include <explore/core/geometry.h>
#include <explore/simulation/scenes/scene_log.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include <gmock/gmock.h>

#include <cmath>

#include "scene_support.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;

namespace
{
struct Recording
{
	std::vector<std::string> bytes;  ///< an observation each
	std::vector<mrpt::obs::CObservation::Ptr> observations;
	TruthLog truth;
};

SceneLogConfig smallLog(int count, int looks, RobotKind kind)
{
	SceneLogConfig config;
	config.seed = 9;
	config.count = count;
	config.looks = looks;
	config.robot = robotOfKind(kind);
	config.camera = depthCamera("xtion", 80);
	config.start = mrpt::Clock::fromDouble(1.5e9);
	return config;
}

Recording recordingOf(const char* family, const SceneLogConfig& config)
{
	Recording recording;
	recording.truth =
	    recordScenes(*sceneFamilyNamed(family), config,
	                 [&recording](const mrpt::obs::CObservation& observation)
	                 {
		                 mrpt::io::CMemoryStream stream;
		                 mrpt::serialization::archiveFrom(stream).WriteObject(observation);
		                 recording.bytes.emplace_back(static_cast<const char*>(stream.getRawBufferData()),
		                                              stream.getTotalBytesCount());
		                 recording.observations.push_back(
		                     std::dynamic_pointer_cast<mrpt::obs::CObservation>(observation.duplicateGetSmartPtr()));
	                 });
	return recording;
}

template <class Observation>
std::vector<std::shared_ptr<Observation>> only(const Recording& recording)
{
	std::vector<std::shared_ptr<Observation>> found;
	for (const auto& observation : recording.observations)
		if (auto cast = std::dynamic_pointer_cast<Observation>(observation)) found.push_back(cast);
	return found;
}
}  // namespace

TEST(SceneLog, HasADepthImageALookAtTheTruthsTimeAndMount)
{
	const Recording recording = recordingOf("two_doors", smallLog(4, 3, RobotKind::ground));
	const auto scans = only<mrpt::obs::CObservation3DRangeScan>(recording);
	const auto& frames = recording.truth.frames;
	ASSERT_EQ(scans.size(), 12U);
	ASSERT_EQ(frames.size(), 12U);
	EXPECT_EQ(only<mrpt::obs::CObservationOdometry>(recording).size(), 12U);
	for (std::size_t i = 0; i < scans.size(); ++i)
	{
		EXPECT_EQ(mrpt::Clock::toDouble(scans[i]->timestamp), frames[i].t);
		EXPECT_EQ(frames[i].index, i);
		EXPECT_EQ(frames[i].scene, static_cast<int>(i / 3));
		EXPECT_EQ(scans[i]->sensorPose, mountOf(recording.truth, frames[i]));
		const double since_s = i == 0 ? 0 : frames[i].t - frames[i - 1].t;
		EXPECT_TRUE(i == 0 || since_s > (i % 3 == 0 ? 10.0 : 0.2 - 1e-6));
	}
	EXPECT_EQ(recording.truth.family, "two_doors");
	EXPECT_EQ(recording.truth.world, "synth");
	EXPECT_FALSE(recording.truth.negative);
	EXPECT_NE(frames[0].doors.at(0).id, frames[3].doors.at(0).id) << "another scene has other doors";
	EXPECT_EQ(frames[0].doors.at(0).id, frames[1].doors.at(0).id);
}

TEST(SceneLog, ShowsWhatTheTruthSays)
{
	// The leaf of a shut door is where its label says: in the depth image too.
	SceneLogConfig config = smallLog(10, 1, RobotKind::ground);
	config.camera = depthCamera("xtion", 160);
	config.camera.noise = NoiseModel::none;
	const Recording recording = recordingOf("recessed_closed_door", config);
	const auto scans = only<mrpt::obs::CObservation3DRangeScan>(recording);
	int compared = 0;
	for (std::size_t i = 0; i < scans.size(); ++i)
	{
		const TruthFrame& frame = recording.truth.frames[i];
		const TruthDoor& door = frame.doors.at(0);
		const Eigen::Isometry3d map_from_camera = isometryOf(frame.map_from_robot + mountOf(recording.truth, frame));
		Eigen::Vector3d point = door.center_in_map;
		point.z() = map_from_camera.translation().z();
		const Eigen::Vector3d in_camera = map_from_camera.inverse() * point;
		const auto pixel = pixelOfPoint(recording.truth.intrinsics, in_camera);
		if (!pixel || pixel->x() < 0 || pixel->x() > 159 || pixel->y() < 0 || pixel->y() > 119) continue;
		const double depth_m = 0.001 * scans[i]->rangeImage(std::lround(pixel->y()), std::lround(pixel->x()));
		EXPECT_NEAR(depth_m, in_camera.x(), 0.2);  // the leaf is within the wall, seen at an angle
		++compared;
	}
	EXPECT_GT(compared, 5);
}

TEST(SceneLog, TellsGravityAndTheMavsPose)
{
	const Recording recording = recordingOf("frontal_door", smallLog(30, 2, RobotKind::mav));
	const auto poses = only<mrpt::obs::CObservationRobotPose>(recording);
	const auto imus = only<mrpt::obs::CObservationIMU>(recording);
	const auto& frames = recording.truth.frames;
	ASSERT_EQ(poses.size(), frames.size());
	EXPECT_TRUE(only<mrpt::obs::CObservationOdometry>(recording).empty());
	double tilt_squares = 0;
	for (std::size_t i = 0; i < frames.size(); ++i)
	{
		const auto &truth = frames[i].map_from_robot, &estimate = poses[i]->pose.mean;
		EXPECT_NEAR((estimate - truth).norm(), 0, 0.2);
		tilt_squares += std::pow(estimate.pitch() - truth.pitch(), 2) + std::pow(estimate.roll() - truth.roll(), 2);
		int near = 0;
		for (const auto& imu : imus)
		{
			if (std::abs(mrpt::Clock::toDouble(imu->timestamp) - frames[i].t) > 0.1) continue;
			++near;
			const Eigen::Vector3d force(imu->get(mrpt::obs::IMU_X_ACC), imu->get(mrpt::obs::IMU_Y_ACC),
			                            imu->get(mrpt::obs::IMU_Z_ACC));
			const Eigen::Vector3d up = isometryOf(truth).linear().transpose() * Eigen::Vector3d::UnitZ();
			EXPECT_NEAR(force.norm(), 9.81, 0.5);
			EXPECT_LT(std::acos(force.normalized().dot(up)), 0.03);
		}
		EXPECT_EQ(near, 5);
	}
	const double tilt_deg = std::sqrt(tilt_squares / (2.0 * static_cast<double>(frames.size()))) * 57.29578;
	EXPECT_GT(tilt_deg, 0.3);
	EXPECT_LT(tilt_deg, 0.75);
}

TEST(SceneLog, OfMoreScenesBeginsWithThoseOfFewer)
{
	for (const RobotKind kind : {RobotKind::ground, RobotKind::mav})
	{
		const Recording few = recordingOf("corridor_side_doors", smallLog(2, 2, kind));
		const Recording many = recordingOf("corridor_side_doors", smallLog(4, 2, kind));
		ASSERT_EQ(many.bytes.size(), 2 * few.bytes.size());
		EXPECT_TRUE(std::equal(few.bytes.begin(), few.bytes.end(), many.bytes.begin()));
	}
}

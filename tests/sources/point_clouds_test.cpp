// Observations that are clouds of points, made here and recorded by others.
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
using mrpt::obs::CObservation3DRangeScan;

PointCloud somePoints()
{
	PointCloud points;
	for (int i = 0; i < 50; ++i)
		points.push_back({1.0F + 0.1F * static_cast<float>(i), 0.5F, -0.02F * static_cast<float>(i)});
	return points;
}

void expectSamePoints(const PointCloud& points, const PointCloud& truth)
{
	EXPECT_EQ(points.x, truth.x);
	EXPECT_EQ(points.y, truth.y);
	EXPECT_EQ(points.z, truth.z);
}

CObservation3DRangeScan::Ptr pointsScan(const PointCloud& points)
{
	auto scan = CObservation3DRangeScan::Create();
	scan->timestamp = at(0);
	scan->sensorLabel = "TOF";
	scan->hasPoints3D = true;
	scan->resizePoints3DVectors(points.size());
	scan->points3D_x = points.x, scan->points3D_y = points.y, scan->points3D_z = points.z;
	return scan;
}

TEST(Clouds, PointsOfAScanWithoutRangeImage)
{
	const auto log = testFolder() / "a.rawlog";
	writeRawlog(log, {pointsScan(somePoints())});
	const auto frames = replay(configFor(log));
	ASSERT_EQ(frames.size(), 1U);
	EXPECT_TRUE(frames[0].image.empty());
	expectSamePoints(frames[0].points_in_camera, somePoints());
}

TEST(Clouds, ExternallyStoredPoints)
{
	const auto log = testFolder() / "a.rawlog", images = testFolder() / "elsewhere";
	std::filesystem::create_directories(images);
	const auto scan = pointsScan(somePoints());
	CObservation3DRangeScan::EXTERNALS_AS_TEXT(false);
	scan->points3D_convertToExternalStorage("points.bin", images.string() + "/");
	writeRawlog(log, {scan});
	SourceConfig config = configFor(log);
	config.images_folder = images.string();
	const auto frames = replay(config);
	ASSERT_EQ(frames.size(), 1U);
	expectSamePoints(frames[0].points_in_camera, somePoints());
}

TEST(Clouds, PointsWithoutReturnAreLeftOut)
{
	PointCloud points = somePoints();
	const float nan = std::nanf("");
	points.push_back({0, 0, 0});
	points.push_back({nan, 1, 1});
	points.push_back({1, INFINITY, 1});
	points.push_back({1, 1, 1e30F});
	const auto log = testFolder() / "a.rawlog";
	writeRawlog(log, {pointsScan(points)});
	expectSamePoints(replay(configFor(log)).at(0).points_in_camera, somePoints());
}

TEST(Clouds, DepthCorrectionMovesPointsOfAScanAlongTheirRays)
{
	const auto log = testFolder() / "a.rawlog";
	writeRawlog(log, {pointsScan(somePoints())});
	SourceConfig config = configFor(log);
	config.camera.depth_scale = 1.1;
	config.camera.depth_offset_m = -0.05;
	const PointCloud corrected = replay(config).at(0).points_in_camera;
	const PointCloud truth = somePoints();
	for (std::size_t i = 0; i < truth.size(); ++i)
	{
		EXPECT_NEAR(corrected.x[i], 1.1 * truth.x[i] - 0.05, 1e-5);
		EXPECT_NEAR(corrected.y[i] / corrected.x[i], truth.y[i] / truth.x[i], 1e-5);
		EXPECT_NEAR(corrected.z[i] / corrected.x[i], truth.z[i] / truth.x[i], 1e-5);
	}
}

TEST(Clouds, PointCloudObservation)
{
	auto map = mrpt::maps::CSimplePointsMap::Create();
	const PointCloud truth = somePoints();
	for (std::size_t i = 0; i < truth.size(); ++i) map->insertPoint(truth.x[i], truth.y[i], truth.z[i]);
	auto observation = mrpt::obs::CObservationPointCloud::Create();
	observation->pointcloud = map;
	observation->sensorLabel = "LIDAR";
	observation->sensorPose = mrpt::poses::CPose3D(1, 2, 3, 0.1, 0.2, 0.3);
	observation->timestamp = at(0);
	const auto log = testFolder() / "a.rawlog";
	writeRawlog(log, {observation});
	const auto frames = replay(configFor(log));
	ASSERT_EQ(frames.size(), 1U);
	expectSamePoints(frames[0].points_in_camera, truth);
	expectSamePose(frames[0].robot_from_camera, observation->sensorPose);
}

TEST(Recorded, VelodyneScanGivesPointsAllAround)
{
	const std::filesystem::path log = "/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog";
	if (!std::filesystem::exists(log)) GTEST_SKIP() << log << " is not there (Debian package mrpt-common)";
	const auto frames = replay(configFor(log));
	ASSERT_EQ(frames.size(), 1U);
	const PointCloud& points = frames[0].points_in_camera;
	ASSERT_GT(points.size(), 10'000U);
	std::array<int, 4> quadrant{};
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		++quadrant[(points.x[i] > 0 ? 1U : 0U) + (points.y[i] > 0 ? 2U : 0U)];
		// The beams of this sensor lie within ±15° of its plane.
		ASSERT_LE(std::abs(points.z[i]), std::tan(0.27) * std::hypot(points.x[i], points.y[i]));
	}
	for (const int count : quadrant) EXPECT_GT(count, 500);
	EXPECT_NEAR(frames[0].robot_from_camera.z(), 0.09, 1e-6);
}

TEST(Recorded, XtionScanOfTheMrptDatasets)
{
	const std::filesystem::path log = "/usr/share/mrpt/datasets/tests_rgbd.rawlog";
	if (!std::filesystem::exists(log)) GTEST_SKIP() << log << " is not there (Debian package mrpt-common)";
	SourceReport report;
	Listener listener;
	const auto frames = replay(configFor(log), &report, &listener);
	ASSERT_EQ(frames.size(), 1U);
	EXPECT_EQ(frames[0].image.intrinsics.width_px, 640);
	EXPECT_NEAR(frames[0].image.intrinsics.fx_px, 572.9, 0.1);
	EXPECT_NEAR(frames[0].image.intrinsics.fy_px, 542.7, 0.1);
	const auto& depths = frames[0].image.depth_m;
	EXPECT_GT(std::count_if(depths.begin(), depths.end(), [](float z) { return z > 0.3F && z < 10.0F; }), 100'000);
	expectFinite(frames[0]);
	EXPECT_TRUE(report.identity_mount);
	EXPECT_EQ(listener.warnings("the camera is taken for the robot"), 1U);
	EXPECT_EQ(listener.warnings("no robot pose"), 1U);
	EXPECT_EQ(report.pose_origin, PoseOrigin::none);
}

}  // namespace
}  // namespace explore::test

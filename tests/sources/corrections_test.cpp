// Mount, self mask, depth correction and lens distortion.
#include <explore/config/ini.h>
#include <explore/core/errors.h>
#include <explore/core/geometry.h>
#include <explore/sources/depth_conversion.h>
#include <mrpt/img/CImage.h>

#include <cmath>
#include <numbers>
#include <random>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
using mrpt::poses::CPose3D;

SourceConfig oneFrameLog()
{
	const auto log = testFolder() / "one.rawlog";
	writeRawlog(log, {scanOf(sceneFrame(), 0)});
	return configFor(log);
}

TEST(Mount, FromTheIniReplacesTheRecordedOne)
{
	SourceConfig config = oneFrameLog();
	loadIniText("test.ini",
	            "[camera]\nmount = ini\npose_x = 0.1\npose_y = 0.2\npose_z = 0.3\npose_yaw = 90\npose_pitch = "
	            "10\npose_roll = -5\n",
	            {}, [&](FieldVisitor& fields) { describe(fields, config); });
	expectSamePose(replay(config).at(0).robot_from_camera,
	               {0.1, 0.2, 0.3, 90 * kDegree_rad, 10 * kDegree_rad, -5 * kDegree_rad});
}

TEST(Mount, ByLabelReplacesTheRecordedOneOfThatSensorOnly)
{
	SourceConfig config = oneFrameLog();
	config.sensor_poses["ELSE"] = CPose3D(9, 9, 9, 0, 0, 0);
	expectSamePose(replay(config).at(0).robot_from_camera, sceneFrame().robot_from_camera);
	config.sensor_poses["CAM"] = CPose3D(1, 2, 3, 0.1, 0.2, 0.3);
	expectSamePose(replay(config).at(0).robot_from_camera, CPose3D(1, 2, 3, 0.1, 0.2, 0.3));
}

TEST(SourceIni, HasTheSectionsAndKeysThatUsersKnow)
{
	SourceConfig config;
	loadIniText(
	    "test.ini",
	    "[source]\nkind = rawlog\nrawlog = a b.rawlog\nimages_folder = img\nsensorLabel = KINECT\npose = odometry\n"
	    "gravity_from_imu = false\n[camera]\nmount = estimate\ndepth_scale = 1.02\ndepth_offset = -0.01\n"
	    "depth_quadratic = 0.001\nself_mask = me.png\n",
	    {}, [&](FieldVisitor& fields) { describe(fields, config); });
	EXPECT_EQ(config.rawlog, "a b.rawlog");
	EXPECT_EQ(config.images_folder, "img");
	EXPECT_EQ(config.sensor_label, "KINECT");
	EXPECT_EQ(config.pose, PosePolicy::odometry);
	EXPECT_FALSE(config.gravity_from_imu);
	EXPECT_EQ(config.camera.mount, MountPolicy::estimate);
	EXPECT_EQ(config.camera.depth_scale, 1.02);
	EXPECT_EQ(config.camera.depth_offset_m, -0.01);
	EXPECT_EQ(config.camera.depth_quadratic_per_m, 0.001);
	EXPECT_EQ(config.camera.self_mask, "me.png");
}

TEST(DepthCorrection, IsTheQuadraticOfTheIni)
{
	SourceConfig config = oneFrameLog();
	config.camera.depth_scale = 0.98;
	config.camera.depth_offset_m = 0.02;
	config.camera.depth_quadratic_per_m = 0.004;
	DepthImage truth = sceneFrame().image;
	for (float& z : truth.depth_m)
		if (z > 0) z = 0.02F + 0.98F * z + 0.004F * z * z;
	expectSameDepths(replay(config).at(0).image, truth, 1e-5);
}

TEST(DepthCorrection, NeverMakesADepthNegative)
{
	CameraConfig camera;
	camera.depth_offset_m = -1.0;
	EXPECT_EQ(correctedDepth(camera, 0.5F), 0.0F);
	EXPECT_EQ(correctedDepth(camera, 0.0F), 0.0F);
	EXPECT_NEAR(correctedDepth(camera, 1.5F), 0.5F, 1e-6);
}

void writeMask(const std::filesystem::path& path, int width, int height, int robot_rows)
{
	mrpt::img::CImage mask(static_cast<unsigned>(width), static_cast<unsigned>(height), mrpt::img::CH_GRAY);
	for (int v = 0; v < height; ++v)
		for (int u = 0; u < width; ++u)
			mask.at<std::uint8_t>(static_cast<unsigned>(u), static_cast<unsigned>(v)) =
			    v >= height - robot_rows ? 1 : 0;
	ASSERT_TRUE(mask.saveToFile(path.string()));
}

TEST(SelfMask, BlanksThePixelsThatSeeTheRobot)
{
	writeMask(testFolder() / "mask.png", 80, 60, 20);
	SourceConfig config = oneFrameLog();
	config.camera.self_mask = (testFolder() / "mask.png").string();
	DepthImage truth = sceneFrame().image;
	std::fill(truth.depth_m.begin() + 40 * 80, truth.depth_m.end(), 0.0F);
	expectSameDepths(replay(config).at(0).image, truth, 1e-6);
}

TEST(SelfMask, OfAnotherSizeOrMissingIsAConfigurationError)
{
	writeMask(testFolder() / "mask.png", 40, 30, 5);
	SourceConfig config = oneFrameLog();
	config.camera.self_mask = (testFolder() / "mask.png").string();
	EXPECT_THROW(replay(config), ConfigError);
	config.camera.self_mask = (testFolder() / "missing.png").string();
	EXPECT_THROW(replay(config), ConfigError);
	writeBytes(testFolder() / "text.png", "no image");
	config.camera.self_mask = (testFolder() / "text.png").string();
	EXPECT_THROW(replay(config), ConfigError);
}

/** The ideal ray that a plumb-bob lens shows at `seen`, by fixed-point iteration on the model of the OpenCV manual. */
Eigen::Vector2d idealOf(const Eigen::Vector2d& seen, const std::array<double, 8>& k)
{
	Eigen::Vector2d p = seen;
	for (int i = 0; i < 50; ++i)
	{
		const double r2 = p.squaredNorm(), radial = 1 + k[0] * r2 + k[1] * r2 * r2 + k[4] * r2 * r2 * r2;
		const Eigen::Vector2d tangential(2 * k[2] * p.x() * p.y() + k[3] * (r2 + 2 * p.x() * p.x()),
		                                 k[2] * (r2 + 2 * p.y() * p.y()) + 2 * k[3] * p.x() * p.y());
		p = (seen - tangential) / radial;
	}
	return p;
}

TEST(LensDistortion, OfAPlumbBobCameraIsRemoved)
{
	// A slanted plane x = 2 + 0.5 y (camera frame), seen through the lens: each distorted pixel by its own ray.
	auto scan = scanOf(sceneFrame(), 0);
	scan->cameraParams.distortion = mrpt::img::DistortionModel::plumb_bob;
	scan->cameraParams.dist = {-0.2, 0.05, 0.002, -0.001, 0.01, 0, 0, 0};
	const CameraIntrinsics camera = sceneFrame().image.intrinsics;
	const auto depth_along = [](double right) { return 2.0 / (1.0 + 0.5 * right); };
	for (int v = 0; v < camera.height_px; ++v)
		for (int u = 0; u < camera.width_px; ++u)
		{
			const Eigen::Vector2d seen((u - camera.cx_px) / camera.fx_px, (v - camera.cy_px) / camera.fy_px);
			const double depth_m = depth_along(idealOf(seen, scan->cameraParams.dist).x());
			scan->rangeImage(v, u) = static_cast<std::uint16_t>(std::lround(depth_m * 1000));
		}
	const auto log = testFolder() / "distorted.rawlog";
	writeRawlog(log, {scan});
	const DepthImage image = replay(configFor(log)).at(0).image;
	double worst_m = 0, worst_uncorrected_m = 0;
	for (int v = 0; v < camera.height_px; ++v)
		for (int u = 0; u < camera.width_px; ++u)
		{
			const double truth_m = depth_along((u - camera.cx_px) / camera.fx_px);
			worst_uncorrected_m = std::max(worst_uncorrected_m, std::abs(0.001 * scan->rangeImage(v, u) - truth_m));
			if (image.at(u, v) > 0) worst_m = std::max(worst_m, std::abs(image.at(u, v) - truth_m));
		}
	// The nearest neighbour is up to 0.71 pixel away: 0.71 / 73.5 of 2 m²·0.5 / (1 − 0.27)², and the millimetre.
	EXPECT_LT(worst_m, 0.020);
	EXPECT_GT(worst_uncorrected_m, 0.035);
}

TEST(LensDistortion, OfAFisheyeFollowsTheAngle)
{
	mrpt::img::TCamera camera;
	camera.ncols = 640, camera.nrows = 480;
	camera.setIntrinsicParamsFromValues(300, 310, 320, 240);
	camera.distortion = mrpt::img::DistortionModel::kannala_brandt;
	EXPECT_TRUE(hasDistortion(camera));
	// Without coefficients the image radius is the angle itself: 45° to the right and down by equal parts.
	const double at_45 = std::tan(std::numbers::pi / 4) / std::numbers::sqrt2;
	const Eigen::Vector2d seen = distortPixel(camera, 320 + 300 * at_45, 240 + 310 * at_45);
	EXPECT_NEAR((seen.x() - 320) / 300, std::numbers::pi / 4 / std::numbers::sqrt2, 1e-9);
	EXPECT_NEAR((seen.y() - 240) / 310, std::numbers::pi / 4 / std::numbers::sqrt2, 1e-9);
}

TEST(LensDistortion, IsNoneWhereTheModelOrItsCoefficientsSaySo)
{
	mrpt::img::TCamera camera;
	camera.dist = {0.1, 0, 0, 0, 0, 0, 0, 0};
	camera.distortion = mrpt::img::DistortionModel::none;
	EXPECT_FALSE(hasDistortion(camera));
	camera.distortion = mrpt::img::DistortionModel::plumb_bob;
	EXPECT_TRUE(hasDistortion(camera));
	camera.dist.fill(0);
	EXPECT_FALSE(hasDistortion(camera));
}
}  // namespace
}  // namespace explore::test

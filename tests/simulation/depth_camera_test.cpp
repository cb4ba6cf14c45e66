#include "depth_camera_worlds.h"

#include <explore/config/ini.h>
#include <explore/core/errors.h>
#include <explore/core/geometry.h>
#include <explore/simulation/pane_optics.h>
#include <gtest/gtest.h>

namespace explore::simulation::test
{
namespace
{
DepthCameraConfig exactCamera(int width_px = 320)
{
	DepthCameraConfig config = depthCamera("xtion", width_px);
	config.noise = NoiseModel::none;
	return config;
}

TEST(DepthCamera, ExactDepthOfWallsAtAnyTilt)
{
	for (const double tilt_deg : {0.0, 20.0, -50.0})
		for (const double distance_m : {0.8, 2.0, 4.0})
		{
			World world;
			addWall(world, distance_m, tilt_deg * kDegree_rad);
			const DepthImage image = shotOf(world, exactCamera()).depth;
			for (int v = 0; v < image.intrinsics.height_px; v += 7)
				for (int u = 0; u < image.intrinsics.width_px; u += 7)
				{
					const double depth = wallDepth(image.intrinsics, u, v, distance_m, tilt_deg * kDegree_rad);
					const bool in_range = depth >= 0.5 && depth <= 8.0;
					ASSERT_NEAR(image.at(u, v), in_range ? depth : 0.0, 5e-6 * depth)
					    << tilt_deg << " deg, " << distance_m << " m";
				}
		}
}

TEST(DepthCamera, FollowsItsPose)
{
	World world;
	addWall(world, 5.0);
	const RayScene scene(world);
	Eigen::Isometry3d map_from_camera(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
	map_from_camera.pretranslate(Eigen::Vector3d(2.0, -1.0, 0.4));
	const DepthCameraConfig config = exactCamera();
	const DepthImage image = takeShot(scene, config, map_from_camera, 1).depth;
	for (int u = 0; u < 320; u += 13)
	{
		const Eigen::Vector3d along = map_from_camera.linear() * rayOfPixel(config.intrinsics, u, 100);
		EXPECT_NEAR(image.at(u, 100), 3.0 / along.x(), 1e-5);
	}
}

TEST(DepthCamera, AnyPinhole)
{
	World world;
	addWall(world, 3.0, 0.4);
	DepthCameraConfig config = exactCamera();
	config.intrinsics = {101, 37, 90.0, 120.0, 20.5, 30.25};
	const DepthImage image = shotOf(world, config).depth;
	ASSERT_EQ(image.depth_m.size(), 101U * 37U);
	for (int v = 0; v < 37; v += 4)
		for (int u = 0; u < 101; u += 5)
			EXPECT_NEAR(image.at(u, v), wallDepth(config.intrinsics, u, v, 3.0, 0.4), 1e-5);
}

TEST(DepthCamera, NothingOutsideTheRange)
{
	for (const NoiseModel noise : {NoiseModel::none, NoiseModel::kinect, NoiseModel::speckle})
		for (const double distance_m : {0.4, 9.0})
		{
			World world;
			addWall(world, distance_m);
			DepthCameraConfig config = depthCamera("xtion", 320);
			config.noise = noise;
			EXPECT_EQ(returnShare(shotOf(world, config).depth), 0.0) << static_cast<int>(noise) << " " << distance_m;
		}
}

TEST(DepthCamera, BlackGivesNothingAndAMirrorShowsTheRoomBehind)
{
	for (const NoiseModel noise : {NoiseModel::none, NoiseModel::kinect})
	{
		World world;
		addWall(world, 2.0, 0.0, "black leather");
		DepthCameraConfig config = depthCamera("xtion", 160);
		config.noise = noise;
		EXPECT_EQ(returnShare(shotOf(world, config).depth), 0.0);
	}
	World world;
	addWall(world, 2.0, 0.0, "mirror");
	addWall(world, -1.5);  // behind the camera: 2 m there, 3.5 m back
	const DepthImage image = shotOf(world, exactCamera()).depth;
	for (const float depth : image.depth_m) ASSERT_NEAR(depth, 5.5F, 1e-3F);
}

TEST(DepthCamera, ATiltedMirrorShowsTheWallAroundTheCorner)
{
	World world;
	addWall(world, 2.0, 45.0 * kDegree_rad, "mirror");  // turns the view along x into one along −y
	addWall(world, 0.0, 90.0 * kDegree_rad, "wall", {60, 60}, {0.0, -3.0, 0.0});
	const DepthImage image = shotOf(world, exactCamera()).depth;
	EXPECT_NEAR(image.at(160, 120), 5.0, 0.03);
	EXPECT_GT(returnShare(image), 0.99);
}

TEST(DepthCamera, PanesLoseAFifthOfTheirPixelsAtLeastAndMoreWithIncidence)
{
	for (const double dropout : {0.2, 0.4})
	{
		double last = 0.0;
		for (const double tilt_deg : {0.0, 45.0, 65.0, 80.0})
		{
			World world;
			addWall(world, 1.5, tilt_deg * kDegree_rad, "window glass", {0.8, 0.8});
			DepthCameraConfig config = exactCamera(640);
			config.intrinsics = {240, 240, 1200.0, 1200.0, 119.5, 119.5};  // a narrow view: one incidence
			config.glass_dropout = dropout;
			addWall(world, 4.0);
			if (tilt_deg > 70.0) config.intrinsics = {60, 240, 1200.0, 1200.0, 29.5, 119.5};
			std::size_t lost = 0, pane = 0, behind = 0, total = 0;
			for (std::uint64_t seed = 0; seed < 8; ++seed)
				for (const float depth : shotOf(world, config, seed).depth.depth_m)
				{
					lost += depth == 0.0F ? 1 : 0;
					behind += std::abs(depth - 4.0F) < 1e-3F ? 1 : 0;
					pane += depth > 0.5F && depth < 2.5F ? 1 : 0;
					++total;
				}
			const double share = static_cast<double>(lost) / static_cast<double>(total);
			EXPECT_EQ(lost + pane + behind, total) << "either nothing, the pane or what is behind";
			EXPECT_GT(behind, 0U);
			EXPECT_GT(pane, 0U);
			EXPECT_NEAR(share, 1.0 - (1.0 - dropout) * paneTransmission(std::cos(tilt_deg * kDegree_rad)), 0.03);
			EXPECT_GE(share, last - 0.02);
			EXPECT_GE(share, 0.18);
			last = share;
		}
		EXPECT_GT(last, 0.6);
	}
}

TEST(DepthCamera, BothFacesOfAPaneCountOnce)
{
	World world;
	addWall(world, 1.5, 0.0, "glass");
	addWall(world, 1.51, 0.0, "glass");
	addWall(world, 3.0);
	const double share = 1.0 - returnShare(shotOf(world, exactCamera()).depth);
	EXPECT_NEAR(share, 0.4, 0.04);
}

TEST(DepthCamera, WindowPanesLetLessThroughTheSteeperTheyAreSeen)
{
	EXPECT_DOUBLE_EQ(paneTransmission(1.0), 1.0);
	EXPECT_NEAR(paneTransmission(0.0), 0.0, 1e-9);
	// Published transmittance of a pane of index 1.52: 0.918 at 0°, 0.84 at 60°, 0.46 at 80°.
	EXPECT_NEAR(std::sqrt(paneTransmission(std::cos(60.0 * kDegree_rad))) * 0.918, 0.84, 0.01);
	double last = 1.0;
	for (int tilt_deg = 0; tilt_deg <= 90; ++tilt_deg)
	{
		const double through = paneTransmission(std::cos(tilt_deg * kDegree_rad));
		EXPECT_LE(through, last + 1e-3);
		last = through;
	}
}

TEST(DepthCamera, HolesTakeTheirShareInBlotchesAndPixelByPixel)
{
	World world;
	addWall(world, 2.0);
	for (const double share : {0.1, 0.3, 0.6})
	{
		DepthCameraConfig config = exactCamera(640);
		config.hole_share = share;
		const DepthImage image = shotOf(world, config).depth;
		EXPECT_NEAR(1.0 - returnShare(image), share, 0.03);
		double lost = 0, beside_lost = 0, alone = 0;
		for (int v = 1; v < 479; ++v)
			for (int u = 1; u < 639; ++u)
			{
				if (image.at(u, v) != 0.0F) continue;
				const bool left = image.at(u - 1, v) == 0.0F, right = image.at(u + 1, v) == 0.0F;
				lost += 1;
				beside_lost += left ? 1 : 0;
				alone += !left && !right && image.at(u, v - 1) != 0.0F && image.at(u, v + 1) != 0.0F ? 1 : 0;
			}
		EXPECT_GT(beside_lost / lost, share + 0.4 * (1.0 - share)) << "lone pixels would be " << share;
		EXPECT_GT(alone / lost, 0.02) << "some are lone pixels";
	}
}

TEST(DepthCamera, PictureShowsMaterialsShadedByTheirOrientation)
{
	World world;
	addWall(world, 2.0, 0.0, "red", {1.0, 60.0}, {0.0, 0.5, 0.0});
	world.materials[0].color = {0.9F, 0.1F, 0.1F};
	addWall(world, 3.0, 0.0, "green");
	world.materials[1].color = {0.1F, 0.9F, 0.1F};
	DepthCameraConfig config = exactCamera();
	EXPECT_TRUE(shotOf(world, config).rgb.empty());
	const std::vector<float> without = shotOf(world, config).depth.depth_m;
	config.color = true;
	const CameraShot shot = shotOf(world, config);
	ASSERT_EQ(shot.rgb.size(), 3U * 320U * 240U);
	EXPECT_EQ(shot.depth.depth_m, without) << "the picture does not change the depth";
	const auto* red = &shot.rgb[static_cast<std::size_t>(3 * (120 * 320 + 140))];
	const auto* green = &shot.rgb[static_cast<std::size_t>(3 * (120 * 320 + 180))];
	EXPECT_GT(red[0], 4 * red[1]);
	EXPECT_GT(green[1], 4 * green[0]);
}

TEST(DepthCamera, SameBytesForAnyNumberOfThreadsAndOthersForAnotherSeed)
{
	World world;
	addWall(world, 4.0, 0.3);
	addWall(world, 1.5, 0.0, "glass", {0.5, 0.5}, {0.0, 0.4, 0.0});
	addWall(world, 2.0, 0.5, "wood", {0.5, 0.5}, {0.0, -0.4, 0.0});
	for (const NoiseModel noise : {NoiseModel::kinect, NoiseModel::speckle})
	{
		DepthCameraConfig config = depthCamera("xtion", noise == NoiseModel::kinect ? 320 : 640);
		config.noise = noise;
		config.color = true;
		config.hole_share = 0.05;
		const CameraShot one = shotOf(world, config, 7);
		for (const int threads : {2, 3})
		{
			config.threads = threads;
			const CameraShot more = shotOf(world, config, 7);
			EXPECT_EQ(one.depth.depth_m, more.depth.depth_m);
			EXPECT_EQ(one.rgb, more.rgb);
		}
		std::size_t differences = 0;
		const CameraShot other = shotOf(world, config, 8);
		for (std::size_t i = 0; i < one.depth.depth_m.size(); ++i)
			differences += one.depth.depth_m[i] != other.depth.depth_m[i] ? 1 : 0;
		EXPECT_GT(differences, one.depth.depth_m.size() / 10);
	}
}

TEST(DepthCamera, PresetsAndTheirNames)
{
	const DepthCameraConfig xtion = depthCamera("xtion");
	EXPECT_EQ(xtion.intrinsics.width_px, 640);
	EXPECT_EQ(xtion.intrinsics.height_px, 480);
	EXPECT_NEAR(2.0 * std::atan(320.0 / xtion.intrinsics.fx_px), 57.0 * kDegree_rad, 1e-9);
	EXPECT_NEAR(2.0 * std::atan(240.0 / xtion.intrinsics.fy_px), 45.0 * kDegree_rad, 1e-9);
	EXPECT_EQ(depthCamera("ideal", 320).noise, NoiseModel::none);
	EXPECT_EQ(depthCamera("kinect").noise, NoiseModel::kinect);
	EXPECT_THROW(depthCamera("laser"), ConfigError);
	// The device rounds in its own VGA picture: half the width, half the step in pixels, the same in metres.
	EXPECT_DOUBLE_EQ(depthCamera("xtion", 320).disparity_step_px, 0.0625);
}

TEST(DepthCamera, IniNameAndWidthComeFirst)
{
	DepthCameraConfig config = depthCamera("xtion");
	const DescribeFields fields = [&](FieldVisitor& visitor) { describe(visitor, config); };
	loadIniText("test.ini",
	            "[simulated_camera]\nfx_px = 300\nwidth_px = 320\nname = kinect\nnoise = speckle\nmax_range = 5\n", {},
	            fields);
	EXPECT_EQ(config.name, "kinect");
	EXPECT_EQ(config.intrinsics.width_px, 320);
	EXPECT_EQ(config.intrinsics.height_px, 240);
	EXPECT_EQ(config.intrinsics.fx_px, 300.0);
	EXPECT_EQ(config.intrinsics.cx_px, 159.5);
	EXPECT_EQ(config.noise, NoiseModel::speckle);
	EXPECT_EQ(config.max_range_m, 5.0);
	EXPECT_EQ(config.min_range_m, 0.6);

	const std::string dump = dumpIni(fields);
	DepthCameraConfig back = depthCamera("ideal", 100);
	const DescribeFields back_fields = [&](FieldVisitor& visitor) { describe(visitor, back); };
	loadIniText("dump.ini", dump, {}, back_fields);
	EXPECT_EQ(dumpIni(back_fields), dump);
	EXPECT_THROW(loadIniText("bad.ini", "[simulated_camera]\nglass_dropout = 0.1\n", {}, fields), ConfigError);
	EXPECT_THROW(loadIniText("bad.ini", "[simulated_camera]\nname = sonar\n", {}, fields), ConfigError);
}
}  // namespace
}  // namespace explore::simulation::test

#include <explore/core/geometry.h>

#include "depth_camera_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>

namespace explore::simulation::test
{
namespace
{
double axialSigma(double z)
{
	return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
}

TEST(NoiseKinect, ResidualOfAFrontalWallIsNguyens)
{
	for (const int width_px : {640, 320})
		for (const double distance_m : {1.0, 2.0, 4.0})
		{
			World world;
			addWall(world, distance_m);
			const DepthImage image = shotOf(world, depthCamera("xtion", width_px)).depth;
			EXPECT_EQ(returnShare(image), 1.0);
			const Spread spread = spreadOf(residuals(image, distance_m, 0.0));
			EXPECT_NEAR(spread.sigma / axialSigma(distance_m), 1.0, 0.05) << width_px << " px, " << distance_m << " m";
			// Rounding disparities shifts the mean by up to half a step, and a symmetric error of disparity is a
			// slightly skewed one of depth.
			EXPECT_NEAR(spread.mean, 0.0, 0.3 * axialSigma(distance_m));
		}
}

TEST(NoiseKinect, ScaleActsOnTheNoise)
{
	World world;
	addWall(world, 3.0);
	DepthCameraConfig config = depthCamera("xtion");
	config.noise_scale = 3.0;
	EXPECT_NEAR(spreadOf(residuals(shotOf(world, config).depth, 3.0, 0.0)).sigma / (3.0 * axialSigma(3.0)), 1.0, 0.05);
}

TEST(NoiseKinect, DepthsAreStepsOfDisparity)
{
	World world;
	addWall(world, 3.0, 0.6);
	const DepthCameraConfig config = depthCamera("xtion");
	const DepthImage image = shotOf(world, config).depth;
	const double focal_baseline = config.intrinsics.fx_px * 0.075;
	std::set<float> depths;
	for (const float depth : image.depth_m)
		if (depth > 0.0F)
		{
			depths.insert(depth);
			const double eighths = 8.0 * focal_baseline / static_cast<double>(depth);
			ASSERT_NEAR(eighths, std::round(eighths), 1e-3);
		}
	// Neighbouring depths lie z²/(8 f B) apart.
	const auto above = std::next(depths.lower_bound(3.0F));
	const double step = static_cast<double>(*above - *std::prev(above)),
	             middle = static_cast<double>(*above + *std::prev(above)) / 2;
	EXPECT_NEAR(step / (middle * middle / (8.0 * focal_baseline)), 1.0, 0.01);
}

TEST(NoiseKinect, SidewaysShiftsShowOnATiltedWall)
{
	// Seen in disparity a tilted wall has a constant slope: a shift of the line of sight adds slope × shift.
	constexpr double kTilt = 55.0 * kDegree_rad;
	World world;
	addWall(world, 1.0, kTilt);
	DepthCameraConfig config = depthCamera("xtion");
	config.disparity_step_px = 0.001;
	const double focal_baseline = config.intrinsics.fx_px * 0.075, slope = 0.075 * std::tan(kTilt) / 1.0;
	const DepthImage image = shotOf(world, config).depth;
	std::vector<double> errors;
	double axial = 0.0;
	for (int v = 100; v < 380; ++v)
		for (int u = 300; u < 340; ++u)
		{
			const double depth = wallDepth(config.intrinsics, u, v, 1.0, kTilt);
			errors.push_back(focal_baseline / static_cast<double>(image.at(u, v)) - focal_baseline / depth);
			axial += std::pow(focal_baseline / (depth * depth) * axialSigma(depth), 2) / (280.0 * 40.0);
		}
	EXPECT_NEAR(spreadOf(errors).sigma, std::sqrt(axial + std::pow(0.5 * slope, 2)), 0.03 * std::sqrt(axial));
	config.lateral_noise_px = 0.0;
	errors.clear();
	const DepthImage still = shotOf(world, config).depth;
	for (int v = 100; v < 380; ++v)
		for (int u = 300; u < 340; ++u)
			errors.push_back(focal_baseline / static_cast<double>(still.at(u, v)) -
			                 focal_baseline / wallDepth(config.intrinsics, u, v, 1.0, kTilt));
	EXPECT_NEAR(spreadOf(errors).sigma, std::sqrt(axial), 0.03 * std::sqrt(axial));
}

TEST(NoiseKinect, SteepIncidenceAddsToTheAxialNoise)
{
	constexpr double kTilt = 80.0 * kDegree_rad;
	World world;
	addWall(world, 2.0, kTilt);
	DepthCameraConfig config = depthCamera("xtion");
	config.intrinsics = {64, 480, 6000.0, 6000.0, 31.5, 239.5};  // a narrow view: one incidence
	config.disparity_step_px = 0.001;
	config.lateral_noise_px = 0.0;
	const Spread spread = spreadOf(residuals(shotOf(world, config).depth, 2.0, kTilt));
	const double rest = std::numbers::pi / 2 - kTilt;
	const double expected = axialSigma(2.0) + 0.0001 * kTilt * kTilt / (std::sqrt(2.0) * rest * rest);
	EXPECT_GT(spread.count, 20000U);
	EXPECT_NEAR(spread.sigma / expected, 1.0, 0.05);
}

TEST(NoiseKinect, ShadowOfANearObjectFallsToItsLeftAsWideAsTheDisparitiesDiffer)
{
	World world;
	addWall(world, 1.5, 0.0, "box", {0.4, 1.0});
	addWall(world, 3.0);
	DepthCameraConfig config = depthCamera("xtion");
	config.noise_scale = 0.0;
	config.edge_dropout = 0.0;
	const DepthImage image = shotOf(world, config).depth;
	const double focal = config.intrinsics.fx_px, expected_px = focal * 0.075 * (1.0 / 1.5 - 1.0 / 3.0);
	for (int v = 150; v < 330; v += 10)
	{
		int shadow_px = 0, last_px = 0;
		for (int u = 0; u < 640; ++u)
			if (image.at(u, v) == 0.0F)
			{
				++shadow_px;
				last_px = u;
			}
		EXPECT_NEAR(shadow_px, expected_px, 1.5);
		EXPECT_NEAR(last_px, config.intrinsics.cx_px - focal * 0.2 / 1.5, 1.5) << "up to the left edge of the object";
	}
}

TEST(NoiseKinect, EdgesLoseTheirShareOfPixels)
{
	World world;
	addWall(world, 1.5, 0.0, "box", {8.0, 8.0}, {0.0, -4.0, 0.0});  // its left edge in the middle of the picture
	addWall(world, 3.0);
	DepthCameraConfig config = depthCamera("xtion");
	config.noise_scale = 0.0;
	const auto missingRightOfEdge = [&]
	{
		const DepthImage image = shotOf(world, config).depth;
		int missing = 0;
		for (int v = 0; v < 480; ++v) missing += image.at(320, v) == 0.0F ? 1 : 0;
		return missing / 480.0;
	};
	EXPECT_NEAR(missingRightOfEdge(), 0.5, 0.1);
	config.edge_dropout = 0.0;
	EXPECT_EQ(missingRightOfEdge(), 0.0);
}
}  // namespace
}  // namespace explore::simulation::test

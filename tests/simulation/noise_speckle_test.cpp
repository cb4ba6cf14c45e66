#include <explore/core/geometry.h>
#include <explore/simulation/noise_random.h>
#include <explore/simulation/speckle_match.h>
#include <explore/simulation/speckle_pattern.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "depth_camera_worlds.h"

namespace explore::simulation::test
{
namespace
{
DepthCameraConfig speckleCamera()
{
	DepthCameraConfig config = depthCamera("xtion");
	config.noise = NoiseModel::speckle;
	return config;
}

/** The pattern as a camera sees it with this disparity everywhere, without noise. */
std::vector<std::uint16_t> flatPicture(int width, int height, float disparity_px)
{
	std::vector<std::uint16_t> picture;
	for (int v = 0; v < height; ++v)
		for (int u = 0; u < width; ++u)
			picture.push_back(static_cast<std::uint16_t>(
			    20.0F + 400.0F * specklePattern().brightness(static_cast<float>(u) - disparity_px, v)));
	return picture;
}

TEST(NoiseSpeckle, MatcherFindsDisparitiesToAFractionOfAPixel)
{
	SpeckleSearch search;
	search.width_px = 160;
	search.height_px = 60;
	for (const float disparity_px : {5.0F, 12.25F, 37.5F, 60.7F, 84.9F})
	{
		const std::vector<float> found = matchSpeckles(flatPicture(160, 60, disparity_px), search);
		std::vector<double> errors;
		for (int v = 4; v < 56; ++v)
			for (int u = 4; u < 156; ++u)
				if (const float value = found[static_cast<std::size_t>(v * 160 + u)]; value > 0.0F)
					errors.push_back(static_cast<double>(value - disparity_px));
		const auto [least, most] = std::minmax_element(errors.begin(), errors.end());
		EXPECT_GE(errors.size(), 152U * 52U * 97U / 100U) << disparity_px;
		EXPECT_LT(spreadOf(errors).sigma, 0.1) << disparity_px;
		EXPECT_LT(std::abs(spreadOf(errors).mean), 0.06) << disparity_px;
		EXPECT_LT(std::max(-*least, *most), 1.0) << disparity_px;
		EXPECT_EQ(found[0], 0.0F) << "no whole block at the border";
	}
}

TEST(NoiseSpeckle, ScaleActsOnTheDisparities)
{
	World world;
	addWall(world, 2.5, 0.3);
	const auto sigma = [&](double scale)
	{
		DepthCameraConfig config = speckleCamera();
		config.noise_scale = scale;
		const DepthImage image = shotOf(world, config).depth;
		const double focal_baseline = config.intrinsics.fx_px * config.baseline_m;
		std::vector<double> errors_px;
		for (int v = 0; v < 480; ++v)
			for (int u = 100; u < 600; ++u)
				if (const double depth_m = static_cast<double>(image.at(u, v)); depth_m > 0.0)
					errors_px.push_back(focal_baseline / depth_m -
					                    focal_baseline / wallDepth(image.intrinsics, u, v, 2.5, 0.3));
		EXPECT_GT(errors_px.size(), 230000U);
		return spreadOf(errors_px).sigma;
	};
	const double usual = sigma(1.0);
	EXPECT_NEAR(sigma(2.0) / usual, 2.0, 0.35);
	EXPECT_NEAR(sigma(3.0) / usual, 3.0, 0.6);
	EXPECT_LE(sigma(0.5), usual);
}

TEST(NoiseSpeckle, NothingMatchesWithoutThePattern)
{
	SpeckleSearch search;
	search.width_px = 120;
	search.height_px = 40;
	std::vector<std::uint16_t> noise(120 * 40);
	for (std::size_t i = 0; i < noise.size(); ++i)
		noise[i] = static_cast<std::uint16_t>(1000.0F * noiseUniform(noiseKey(3, 4), static_cast<std::uint32_t>(i)));
	const std::vector<float> found = matchSpeckles(noise, search);
	EXPECT_LT(std::count_if(found.begin(), found.end(), [](float value) { return value > 0.0F; }), 40);
	const std::vector<std::uint16_t> dull(noise.size(), 300);
	const std::vector<float> nothing = matchSpeckles(dull, search);
	EXPECT_EQ(std::count(nothing.begin(), nothing.end(), 0.0F), static_cast<std::ptrdiff_t>(nothing.size()));
}

TEST(NoiseSpeckle, FrontalWallsAreMeasuredAsWellAsDevicesDo)
{
	// Published for devices of this kind: about 2 mm at 1 m, 1 cm at 2 m, 3 cm at 4 m, 5 cm at 5 m at the most.
	const std::vector<std::pair<double, double>> most{
	    {1.0, 0.003}, {2.0, 0.010}, {3.0, 0.020}, {4.0, 0.035}, {5.0, 0.060}};
	double last = 0.0;
	for (const auto& [distance_m, most_m] : most)
	{
		World world;
		addWall(world, distance_m);
		const DepthImage image = shotOf(world, speckleCamera()).depth;
		const Spread spread = spreadOf(residuals(image, distance_m, 0.0));
		EXPECT_GT(returnShare(image), 0.95) << distance_m;
		EXPECT_LT(spread.sigma, most_m) << distance_m;
		EXPECT_GT(spread.sigma, last) << "grows with distance";
		EXPECT_LT(std::abs(spread.mean), most_m);
		last = spread.sigma;
		RecordProperty("sigma_mm_at_" + std::to_string(static_cast<int>(distance_m)),
		               std::to_string(1000.0 * spread.sigma));
	}
}

TEST(NoiseSpeckle, NeighbouringPixelsErrAlike)
{
	// They share most of their blocks, unlike those of the formulas.
	World world;
	addWall(world, 3.0, 0.3);
	DepthCameraConfig config = speckleCamera();
	config.disparity_step_px = 0.01;
	const DepthImage image = shotOf(world, config).depth;
	double product = 0.0, square = 0.0;
	for (int v = 40; v < 440; ++v)
		for (int u = 40; u < 600; ++u)
		{
			if (image.at(u, v) == 0.0F || image.at(u + 1, v) == 0.0F) continue;
			const double here = image.at(u, v) - wallDepth(config.intrinsics, u, v, 3.0, 0.3);
			product += here * (image.at(u + 1, v) - wallDepth(config.intrinsics, u + 1, v, 3.0, 0.3));
			square += here * here;
		}
	EXPECT_GT(product / square, 0.5);
}

TEST(NoiseSpeckle, NothingFromBlackFromShadowsAndFromGrazingWalls)
{
	World world;
	addWall(world, 2.0, 0.0, "black");
	EXPECT_EQ(returnShare(shotOf(world, speckleCamera()).depth), 0.0);

	World box;
	addWall(box, 1.2, 0.0, "box", {0.3, 3.0});
	addWall(box, 3.0);
	const DepthImage image = shotOf(box, speckleCamera()).depth;
	const double focal = image.intrinsics.fx_px;
	const int edge_px = static_cast<int>(image.intrinsics.cx_px - focal * 0.15 / 1.2);
	const int shadow_px = static_cast<int>(focal * 0.075 * (1.0 / 1.2 - 1.0 / 3.0));  // 22 px
	int holes = 0;
	for (int v = 100; v < 380; ++v)
		for (int u = edge_px - shadow_px + 6; u < edge_px - 6; ++u) holes += image.at(u, v) == 0.0F ? 1 : 0;
	EXPECT_GT(holes, 0.9 * 280 * (shadow_px - 12));

	World grazing;
	addWall(grazing, 3.0, 86.0 * kDegree_rad);
	DepthCameraConfig narrow = speckleCamera();
	narrow.intrinsics = {80, 480, narrow.intrinsics.fx_px, narrow.intrinsics.fy_px, 39.5, 239.5};
	EXPECT_LT(returnShare(shotOf(grazing, narrow).depth), 0.5);
}

TEST(NoiseSpeckle, EdgesAreRaggedWithinABlock)
{
	World world;
	addWall(world, 1.5, 0.0, "box", {8.0, 8.0}, {0.0, 4.0, 0.0});  // its right edge in the middle of the picture
	addWall(world, 3.0);
	const DepthImage image = shotOf(world, speckleCamera()).depth;
	int least = 640, most = 0;
	for (int v = 20; v < 460; ++v)
	{
		int edge = 0;
		for (int u = 200; u < 440; ++u)
			if (image.at(u, v) > 0.0F && image.at(u, v) < 2.0F) edge = u;
		least = std::min(least, edge);
		most = std::max(most, edge);
	}
	EXPECT_NEAR(least, 319, 6);
	EXPECT_NEAR(most, 319, 6);
	EXPECT_GE(most - least, 3) << "not a straight line";
}

TEST(NoiseSpeckle, SmallPicturesAreMatchedInAFinerOne)
{
	World world;
	addWall(world, 3.0, 0.5);
	DepthCameraConfig config = depthCamera("xtion", 320);
	config.noise = NoiseModel::speckle;
	const DepthImage image = shotOf(world, config).depth;
	ASSERT_EQ(image.depth_m.size(), 320U * 240U);
	const Spread spread = spreadOf(residuals(image, 3.0, 0.5));
	EXPECT_GT(returnShare(image), 0.9);
	EXPECT_LT(spread.sigma, 0.025);
	EXPECT_LT(std::abs(spread.mean), 0.005);
}
}  // namespace
}  // namespace explore::simulation::test

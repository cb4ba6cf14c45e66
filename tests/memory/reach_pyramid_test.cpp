#include <explore/memory/reach_pyramid.h>
#include <gtest/gtest.h>

#include <random>

namespace explore
{
namespace
{
/** Random reaches, dark in places. */
FrameRays randomRays(std::mt19937& random, int width, int height)
{
	FrameRays rays;
	rays.width_px = width;
	rays.height_px = height;
	rays.reach_m.assign(static_cast<std::size_t>(width * height) + FrameRays::kLanes, 0.0F);
	for (int i = 0; i < width * height; ++i)
		rays.reach_m[static_cast<std::size_t>(i)] =
		    (i / 7) % 5 == 0 ? 0.0F : static_cast<float>(random() % 1000) * 0.005F * static_cast<float>(random() % 2);
	return rays;
}

/** The plain reading of every pixel in a rectangle. */
float farthestPixel(const FrameRays& rays, const PixelRect& rect)
{
	float farthest_m = 0.0F;
	for (int v = std::max(rect.v0, 0); v <= std::min(rect.v1, rays.height_px - 1); ++v)
		for (int u = std::max(rect.u0, 0); u <= std::min(rect.u1, rays.width_px - 1); ++u)
			farthest_m = std::max(farthest_m, rays.reach(u, v));
	return farthest_m;
}

int within(std::mt19937& random, int low, int high)
{
	return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

TEST(ReachPyramid, NeverLessThanTheFarthestPixelNorMoreThanThatOfTheNeighbourhood)
{
	std::mt19937 random(4);
	for (const auto& [width, height] : {std::pair{160, 120}, {61, 47}, {5, 3}, {1, 1}})
	{
		const FrameRays rays = randomRays(random, width, height);
		const ReachPyramid pyramid(rays);
		for (int trial = 0; trial < 2000; ++trial)
		{
			const int u = within(random, -30, width + 30), v = within(random, -30, height + 30);
			const PixelRect rect{u, v, u + within(random, -1, 40), v + within(random, -1, 40)};
			const float found_m = pyramid.farthestIn(rect);
			ASSERT_GE(found_m, farthestPixel(rays, rect));
			const int slack = 32;  // the cells that four of cover 40 pixels are 16 wide
			ASSERT_LE(found_m,
			          farthestPixel(rays, {rect.u0 - slack, rect.v0 - slack, rect.u1 + slack, rect.v1 + slack}));
		}
	}
}

TEST(ReachPyramid, AroundAPixelNothingFartherIsMissed)
{
	std::mt19937 random(5);
	const FrameRays rays = randomRays(random, 160, 120);
	const ReachPyramid pyramid(rays);
	for (const float radius_px : {0.5F, 3.0F, 7.5F, 20.0F, 90.0F, 1e30F})
	{
		const auto around = pyramid.around(radius_px);
		for (int trial = 0; trial < 500; ++trial)
		{
			const int u = within(random, -60, 220), v = within(random, -60, 180);
			const int r = static_cast<int>(std::min(radius_px, 1000.0F));
			ASSERT_GE(around(u, v), farthestPixel(rays, {u - r, v - r, u + r, v + r})) << radius_px;
		}
	}
}

TEST(ReachPyramid, FindsDarkPartsOfTheImage)
{
	FrameRays rays;
	rays.width_px = 160;
	rays.height_px = 120;
	rays.reach_m.assign(160 * 120 + FrameRays::kLanes, 2.0F);
	for (int v = 40; v < 48; ++v)
		for (int u = 80; u < 88; ++u)
			rays.reach_m[160U * static_cast<std::size_t>(v) + static_cast<std::size_t>(u)] = 0.0F;
	const ReachPyramid pyramid(rays);
	EXPECT_TRUE(pyramid.anyDarkIn({70, 30, 100, 60}));
	EXPECT_TRUE(pyramid.anyDarkIn({-1000, -1000, 1000, 1000}));
	EXPECT_FALSE(pyramid.anyDarkIn({0, 0, 30, 30}));
	EXPECT_FALSE(pyramid.anyDarkIn({300, 30, 400, 60}));
}
}  // namespace
}  // namespace explore

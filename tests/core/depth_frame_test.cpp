#include <explore/core/depth_frame.h>
#include <gtest/gtest.h>

#include "support/random_points.h"

namespace explore
{
namespace
{
const CameraIntrinsics kCamera{640, 480, 572.9, 542.7, 319.5, 239.5};

TEST(RayOfPixel, AxesAreForwardLeftUp)
{
	EXPECT_EQ(rayOfPixel(kCamera, 319.5, 239.5), Eigen::Vector3d(1, 0, 0));
	EXPECT_LT(rayOfPixel(kCamera, 600, 239.5).y(), 0.0) << "right of the centre is negative y";
	EXPECT_LT(rayOfPixel(kCamera, 319.5, 400).z(), 0.0) << "below the centre is negative z";
	EXPECT_DOUBLE_EQ(rayOfPixel(kCamera, 319.5 - 572.9, 239.5).y(), 1.0) << "f pixels aside are 45 degrees";
}

TEST(PixelOfPoint, InvertsRayOfPixel)
{
	std::mt19937 random(3);
	for (int run = 0; run < 500; ++run)
	{
		const Eigen::Vector2d pixel(test::uniform(random, -50, 700), test::uniform(random, -50, 500));
		const double depth_m = test::uniform(random, 0.1, 10);
		const auto seen_at = pixelOfPoint(kCamera, depth_m * rayOfPixel(kCamera, pixel.x(), pixel.y()));
		ASSERT_TRUE(seen_at);
		EXPECT_LT((*seen_at - pixel).norm(), 1e-9);
	}
	EXPECT_FALSE(pixelOfPoint(kCamera, {-1.0, 0.0, 0.0}));
	EXPECT_FALSE(pixelOfPoint(kCamera, {0.0, 1.0, 0.0}));
}

TEST(DepthImage, IsRowMajor)
{
	DepthImage image;
	image.intrinsics = {3, 2, 1, 1, 1, 0.5};
	image.depth_m = {1, 2, 3, 4, 5, 6};
	EXPECT_EQ(image.at(2, 0), 3.0F);
	EXPECT_EQ(image.at(0, 1), 4.0F);
}
}  // namespace
}  // namespace explore

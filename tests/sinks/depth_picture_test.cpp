#include "support/test_files.h"

#include <explore/sinks/report/depth_picture.h>
#include <mrpt/img/CImage.h>

using namespace explore;

namespace
{
DepthImage imageOf(int width, int height, float depth_m)
{
	DepthImage image;
	image.intrinsics = {width, height, 500, 500, 0.5 * width, 0.5 * height};
	image.depth_m.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), depth_m);
	return image;
}

mrpt::img::CImage decoded(const std::string& jpeg)
{
	const auto path = test::freshFolder() / "a.jpg";
	test::writeFile(path, jpeg);
	mrpt::img::CImage image;
	EXPECT_TRUE(image.loadFromFile(path.string(), 0));
	return image;
}

int greyAt(const mrpt::img::CImage& image, unsigned x, unsigned y)
{
	return image.at<std::uint8_t>(x, y, 0);
}
}  // namespace

TEST(DepthPicture, GreySaysHowFar)
{
	for (const auto& [depth_m, grey] : {std::pair{0.0F, 0}, {0.001F, 255}, {2.5F, 152}, {5.0F, 48}, {9.0F, 48}})
	{
		const auto picture = decoded(depthJpeg(imageOf(640, 480, depth_m), 5.0, 320));
		EXPECT_EQ(picture.getWidth(), 320U);
		EXPECT_EQ(picture.getHeight(), 240U);
		EXPECT_NEAR(greyAt(picture, 160, 120), grey, 3) << depth_m;
	}
}

TEST(DepthPicture, HolesAndStepsStayWhereTheyAre)
{
	DepthImage image = imageOf(640, 480, 1.0F);
	for (int v = 0; v < 480; ++v)
		for (int u = 0; u < 640; ++u)
			if (u >= 320) image.depth_m[static_cast<std::size_t>(v * 640 + u)] = v < 240 ? 0.0F : 4.0F;
	const auto picture = decoded(depthJpeg(image, 5.0, 320));
	EXPECT_NEAR(greyAt(picture, 80, 60), 214, 6);
	EXPECT_NEAR(greyAt(picture, 240, 60), 0, 12);
	EXPECT_NEAR(greyAt(picture, 240, 180), 89, 6);
}

TEST(DepthPicture, SmallImagesAreNotEnlargedAndEmptyOnesGiveNone)
{
	EXPECT_EQ(decoded(depthJpeg(imageOf(160, 120, 1.0F), 5.0, 320)).getWidth(), 160U);
	EXPECT_EQ(depthJpeg({}, 5.0, 320), "");
}

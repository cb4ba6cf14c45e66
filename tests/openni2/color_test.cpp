// Colour images beside the depth: as the camera sees them, with the depth image that they belong to, or not at all.
#include "openni2/virtual_camera.h"
#include "support/test_files.h"

#include <explore/core/errors.h>
#include <explore/openni2/frame_maker.h>
#include <explore/openni2/live_camera.h>
#include <explore/openni2/oni_file.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

using namespace explore;
using namespace explore::openni2;
using namespace explore::test;
using namespace std::chrono_literals;
using testing::HasSubstr;

namespace
{
Openni2Config withColor(const VirtualCamera& camera)
{
	Openni2Config config = camera.config().openni2;
	config.color = true;
	return config;
}

/** The number of the served image that is this depth. */
int imageOf(const RawDepth& raw, const VirtualCamera& camera)
{
	const auto& images = camera.served().images;
	const auto found = std::ranges::find(images, raw.depth);
	return found == images.end() ? -1 : static_cast<int>(found - images.begin());
}

/** The same of its colour image; -1 where its sides are not the right way round. */
double imageOf(const ColorImage& color, const VirtualCamera& camera)
{
	const auto width = static_cast<std::size_t>(color.intrinsics.width_px);
	const std::size_t row = color.pixels.size() / width / 2 * width;
	const Rgb left = color.pixels.at(row + width / 4), right = color.pixels.at(row + width - width / 4);
	if (left[0] < left[1] || right[1] < right[0]) return -1;
	return imageOfBlue(0.5 * (left[2] + right[2]), camera.served().images.size());
}

/** How many images the colour is older than the depth. */
double lagOf(const RawDepth& raw, const VirtualCamera& camera)
{
	const auto count = static_cast<double>(camera.served().images.size());
	return std::remainder(imageOf(raw, camera) - imageOf(*raw.color, camera), count);
}

RawDepth nextOf(LiveCamera& camera)
{
	for (int i = 0; i < 20; ++i)
		if (auto raw = camera.take(500ms)) return *std::move(raw);
	throw std::runtime_error("no frame");
}

std::string startError(const Openni2Config& config)
{
	try
	{
		LiveCamera camera(config);
	}
	catch (const ConfigError& error)
	{
		return error.what();
	}
	return "";
}
}  // namespace

TEST(Color, ComesWithItsDepthAndTheRightWayRound)
{
	const VirtualCamera camera(160, 120, 20);
	LiveCamera live(withColor(camera));
	int with_color = 0;
	for (int i = 0; i < 40; ++i)
	{
		const RawDepth raw = nextOf(live);
		ASSERT_GE(imageOf(raw, camera), 0);
		if (!raw.color) continue;
		++with_color;
		EXPECT_EQ(raw.color->pixels.size(), 160U * 120U);
		EXPECT_NEAR(raw.color->intrinsics.fx_px, camera.served().fx_px, 1e-3);
		ASSERT_GT(imageOf(*raw.color, camera), -0.5);
		// Its own, or the one before where that was quicker.
		EXPECT_GT(lagOf(raw, camera), -1.2);
		EXPECT_LT(lagOf(raw, camera), 1.2);
	}
	EXPECT_GE(with_color, 5) << "fewer on a busy machine, which gets both too late";
}

TEST(Color, IsNotThereWhenNobodyAsks)
{
	const VirtualCamera camera;
	LiveCamera live(camera.config().openni2);
	for (int i = 0; i < 10; ++i) EXPECT_FALSE(nextOf(live).color);
}

TEST(Color, DepthDoesNotWaitForIt)
{
	VirtualCamera camera;
	LiveCamera live(withColor(camera));
	for (int i = 0; i < 10; ++i) nextOf(live);
	camera.set("color", "stalled");
	std::uint64_t last_us = nextOf(live).device_time_us;
	for (int i = 0; i < 3; ++i) nextOf(live);  // with the last colour, which soon is too old
	for (int i = 0; i < 10; ++i)
	{
		const RawDepth raw = nextOf(live);
		EXPECT_FALSE(raw.color) << "the colour of a time that is over";
		EXPECT_GT(raw.device_time_us, last_us);
		last_us = raw.device_time_us;
	}
	camera.set("color", "rgb");
	for (int i = 0; i < 5; ++i) nextOf(live);
	EXPECT_TRUE(nextOf(live).color);
}

TEST(Color, ACameraWithoutOrOneThatRefusesIsRefused)
{
	VirtualCamera camera;
	const auto told = [&](const char* kind)
	{
		camera.set("color", kind);
		return startError(withColor(camera));
	};
	EXPECT_THAT(told("none"), HasSubstr("[openni2] color = true: the camera has no colour images"));
	EXPECT_THAT(told("yuv"), HasSubstr("[openni2] color = true: the camera has no colour images of 8-bit RGB"));
	EXPECT_THAT(told("refused"), HasSubstr("[openni2] color = true: the colour stream does not start"));
	EXPECT_EQ(told("rgb"), "");
	camera.set("color", "none");
	EXPECT_EQ(startError(camera.config().openni2), "") << "depth alone suffices";
}

TEST(Color, RegisteredDepthIsSeenThroughTheColourCamerasLens)
{
	VirtualCamera camera;
	camera.set("registers", "1");
	Openni2Config config = withColor(camera);
	config.fx_px = 150, config.fy_px = 151, config.cx_px = 80, config.cy_px = 60;
	const CameraIntrinsics calibrated{160, 120, 150, 151, 80, 60};
	for (const bool registered : {false, true})
	{
		config.registration = registered;
		LiveCamera live(config);
		RawDepth raw = nextOf(live);
		for (int i = 0; i < 10 && !raw.color; ++i) raw = nextOf(live);
		ASSERT_TRUE(raw.color);
		EXPECT_EQ(raw.intrinsics, calibrated);
		EXPECT_EQ(raw.color->intrinsics == calibrated, registered);
	}
}

class RecordedColor : public testing::TestWithParam<bool>
{
};

TEST_P(RecordedColor, IsReadWithEveryFrame)
{
	const VirtualCamera camera(160, 120, 20);
	const auto path = testFolder() / "camera.oni";
	recordOni(path, 30, {.mirrored = GetParam(), .color = true});
	const auto read = [&](const Openni2Config& config)
	{
		std::vector<RawDepth> frames;
		OniFile file(path, config);
		while (auto raw = file.next()) frames.push_back(*std::move(raw));
		EXPECT_EQ(file.damage(), "");
		return frames;
	};
	const auto frames = read(withColor(camera)), again = read(withColor(camera)), depth = read(camera.config().openni2);
	ASSERT_GE(frames.size(), 30U);
	ASSERT_EQ(again.size(), frames.size());
	ASSERT_EQ(depth.size(), frames.size());
	std::size_t with_color = 0;
	for (std::size_t i = 0; i < frames.size(); ++i)
	{
		EXPECT_GE(imageOf(frames[i], camera), 0);
		EXPECT_EQ(depth[i].depth, frames[i].depth);
		EXPECT_EQ(again[i].depth, frames[i].depth);
		EXPECT_FALSE(depth[i].color);
		ASSERT_EQ(again[i].color.has_value(), frames[i].color.has_value());
		if (!frames[i].color) continue;
		++with_color;
		EXPECT_EQ(again[i].color->pixels, frames[i].color->pixels);
		ASSERT_GT(imageOf(*frames[i].color, camera), -0.5);
		EXPECT_LT(std::abs(lagOf(frames[i], camera)), 1.4);
	}
	EXPECT_GE(with_color, 5U) << "fewer from a busy machine, whose recorder leaves images out";
}
INSTANTIATE_TEST_SUITE_P(Mirrored, RecordedColor, testing::Bool());

TEST(Color, ARecordingWithoutIsRefused)
{
	const VirtualCamera camera;
	const auto path = testFolder() / "camera.oni";
	recordOni(path, 5);
	try
	{
		OniFile file(path, withColor(camera));
		FAIL();
	}
	catch (const ConfigError& error)
	{
		EXPECT_THAT(error.what(), HasSubstr("[openni2] color = true: the recording has no colour images"));
	}
}

TEST(Color, IsKeptInTheObservation)
{
	RawDepth raw;
	raw.intrinsics = {2, 1, 100, 100, 0.5, 0};
	raw.depth = {1000, 2000};
	EXPECT_FALSE(scanOf(raw, recordingStart(), {}).hasIntensityImage);
	raw.color = ColorImage{{3, 1, 140, 141, 1, 0}, {{10, 20, 30}, {40, 50, 60}, {70, 80, 90}}};
	const auto scan = scanOf(raw, recordingStart(), {});
	ASSERT_TRUE(scan.hasIntensityImage);
	EXPECT_EQ(scan.intensityImageChannel, mrpt::obs::CObservation3DRangeScan::CH_VISIBLE);
	EXPECT_EQ(scan.intensityImage.getWidth(), 3U);
	EXPECT_EQ(scan.cameraParamsIntensity.ncols, 3U);
	EXPECT_EQ(scan.cameraParamsIntensity.fx(), 140.0);
	EXPECT_EQ(scan.cameraParams.fx(), 100.0);
	// OpenCV's order.
	EXPECT_EQ(scan.intensityImage.at<std::uint8_t>(1, 0, 2), 40);
	EXPECT_EQ(scan.intensityImage.at<std::uint8_t>(1, 0, 0), 60);
	EXPECT_EQ(scan.rangeImage(0, 1), 2000);
}

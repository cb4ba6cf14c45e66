// Folders of depth images become rawlogs that replay to the same depths and poses.
#include <explore/core/errors.h>
#include <explore/sources/depth_png.h>
#include <mrpt/img/CImage.h>

#include <algorithm>

#include "import_fixture.h"

namespace explore::test
{
namespace
{
TEST(PngFolder, RoundTripsInNaturalOrder)
{
	const std::vector<std::string> names = {"9.png", "10.png", "frame_2.PNG", "frame_11.PNG"};
	for (std::size_t i = 0; i < names.size(); ++i)
		writePng(testFolder() / (names[i] + ".png"), sceneFrame(0.3 * static_cast<double>(i)).image, 1000);
	for (const std::string& name : names) std::filesystem::rename(testFolder() / (name + ".png"), testFolder() / name);
	writeBytes(testFolder() / "notes.txt", "not an image");

	const auto log = testFolder() / "log.rawlog";
	importTo(log, {listPngFolder(testFolder(), at(0), 10.0), {}}, importConfigOf(sceneFrame().image, 1000));
	const auto frames = replay(configFor(log));
	ASSERT_EQ(frames.size(), names.size());
	for (std::size_t i = 0; i < names.size(); ++i)
	{
		expectSameDepths(frames[i].image, sceneFrame(0.3 * static_cast<double>(i)).image, 1e-6);
		EXPECT_NEAR(secondsBetween(at(0), frames[i].timestamp), 0.1 * static_cast<double>(i), 1e-6);
	}
}

TEST(PngFolder, GivesTheSameBytesEachTime)
{
	writePng(testFolder() / "0.png", sceneFrame().image, 1000);
	const auto frames = listPngFolder(testFolder(), at(0), 30.0);
	importTo(testFolder() / "a.rawlog", {frames, {}}, importConfigOf(sceneFrame().image, 1000));
	importTo(testFolder() / "b.rawlog", {frames, {}}, importConfigOf(sceneFrame().image, 1000));
	EXPECT_EQ(readBytes(testFolder() / "a.rawlog"), readBytes(testFolder() / "b.rawlog"));
}

TEST(PngFolder, KeepsAllSixteenBits)
{
	DepthImage image = sceneFrame().image;
	for (std::size_t i = 0; i < image.depth_m.size(); ++i) image.depth_m[i] = static_cast<float>((i * 13) % 65536);
	writePng(testFolder() / "0.png", image, 1.0);
	const auto counts = readDepthPng(testFolder() / "0.png");
	ASSERT_EQ(counts.cols(), 80);
	ASSERT_EQ(counts.rows(), 60);
	for (int v = 0; v < 60; ++v)
		for (int u = 0; u < 80; ++u) ASSERT_EQ(counts(v, u), static_cast<std::uint16_t>(image.at(u, v)));
}

TEST(PngFolder, RefusesImagesThatAreNoDepth)
{
	mrpt::img::CImage gray8(8, 6, mrpt::img::CH_GRAY), color(8, 6, mrpt::img::CH_RGB);
	ASSERT_TRUE(gray8.saveToFile((testFolder() / "gray.png").string()));
	ASSERT_TRUE(color.saveToFile((testFolder() / "color.png").string()));
	writePng(testFolder() / "good.png", sceneFrame().image, 1000);
	const std::string good = readBytes(testFolder() / "good.png");
	writeBytes(testFolder() / "cut.png", good.substr(0, good.size() / 2));
	writeBytes(testFolder() / "text.png", "some text that is long enough to be looked at");
	writeBytes(testFolder() / "empty.png", "");
	const auto refusal = [](const char* name)
	{ return messageOf<InputError>([&] { readDepthPng(testFolder() / name); }); };
	EXPECT_THAT(refusal("gray.png"), testing::HasSubstr("8 bits"));
	EXPECT_THAT(refusal("color.png"), testing::HasSubstr("colour"));
	EXPECT_THAT(refusal("cut.png"), testing::HasSubstr("cut off"));
	EXPECT_THAT(refusal("text.png"), testing::HasSubstr("no PNG"));
	EXPECT_THAT(refusal("empty.png"), testing::HasSubstr("no PNG"));
	EXPECT_THAT(refusal("missing.png"), testing::HasSubstr("No such file"));
}

TEST(PngFolder, RefusesAnEmptyOrMissingFolder)
{
	EXPECT_THAT(messageOf<InputError>([] { listPngFolder(testFolder(), at(0), 30); }), testing::HasSubstr("no .png"));
	EXPECT_THAT(messageOf<InputError>([] { listPngFolder(testFolder() / "none", at(0), 30); }),
	            testing::HasSubstr("No such file"));
}

TEST(PngFolder, RefusesIntrinsicsOfAnotherImageSizeAndMixedSizes)
{
	writePng(testFolder() / "0.png", sceneFrame().image, 1000);
	ImportConfig config = importConfigOf(sceneFrame().image, 1000);
	config.cx_px = 319.5;
	const auto import = [&] {
		importTo(testFolder() / "log.rawlog", {listPngFolder(testFolder(), at(0), 30), {}}, config);
	};
	EXPECT_THAT(messageOf<InputError>(import), testing::HasSubstr("80x60"));
	EXPECT_FALSE(std::filesystem::exists(testFolder() / "log.rawlog")) << "half a log must not pass for a whole one";

	config = importConfigOf(sceneFrame().image, 1000);
	DepthImage small = sceneFrame().image;
	small.intrinsics.height_px = 30;
	writePng(testFolder() / "1.png", small, 1000);
	EXPECT_THAT(messageOf<InputError>(import), testing::HasSubstr("80x30"));
}

TEST(NaturalOrder, ComparesNumbersAsNumbers)
{
	EXPECT_TRUE(naturallyLess("2.png", "10.png"));
	EXPECT_FALSE(naturallyLess("10.png", "2.png"));
	EXPECT_TRUE(naturallyLess("a9b2", "a9b10"));
	EXPECT_TRUE(naturallyLess("000009", "000010"));
	EXPECT_TRUE(naturallyLess("a", "a1"));
	EXPECT_TRUE(naturallyLess("a1", "b0"));
	EXPECT_FALSE(naturallyLess("x1", "x1"));
	// Beyond 64 bits, and equal numbers of other length in one order only.
	EXPECT_TRUE(naturallyLess("99999999999999999999998", "99999999999999999999999"));
	EXPECT_NE(naturallyLess("01", "1"), naturallyLess("1", "01"));
}

TEST(Writer, NoticesAFullDiskAndAFolderThatIsNotThere)
{
	EXPECT_THAT(messageOf<OutputError>([] { RawlogWriter(testFolder() / "none" / "a.rawlog"); }),
	            testing::HasSubstr("No such file"));
	if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "/dev/full is not there";
	const auto fill = []
	{
		RawlogWriter writer("/dev/full");
		for (int i = 0; i < 3; ++i) writer.write(*scanOf(sceneFrame(), i));
		writer.close();
	};
	EXPECT_THAT(messageOf<OutputError>(fill), testing::HasSubstr("No space left"));
}

struct SharedFolder
{
	const char* name;
	double fx, fy, cx, cy;
	std::size_t frames;
};

class SharedRecording : public testing::TestWithParam<SharedFolder>
{
};

TEST_P(SharedRecording, BecomesARawlogOfPlausibleDepths)
{
	const auto folder = std::filesystem::path(EXPLORE_SOURCE_DIR) / ".." / "shared" / "data" / GetParam().name;
	if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
	ImportConfig config;
	config.fx_px = GetParam().fx, config.fy_px = GetParam().fy, config.cx_px = GetParam().cx,
	config.cy_px = GetParam().cy;
	const auto log = testFolder() / "real.rawlog";
	importTo(log, {listPngFolder(folder, at(0), 30), {}}, config);
	SourceReport report;
	const auto frames = replay(configFor(log), &report);
	EXPECT_EQ(frames.size(), GetParam().frames);
	EXPECT_EQ(report.damage, "");
	for (const DepthFrame& frame : frames)
	{
		expectFinite(frame);
		EXPECT_EQ(frame.image.intrinsics.width_px, 640);
		const auto& depths = frame.image.depth_m;
		EXPECT_GT(std::count_if(depths.begin(), depths.end(), [](float z) { return z > 0.2F && z < 12.0F; }), 60'000);
	}
}

INSTANTIATE_TEST_SUITE_P(Shared, SharedRecording,
                         testing::Values(SharedFolder{"kinect_stills", 525, 525, 319.5, 239.5, 5},
                                         SharedFolder{"pedestrian_tunnel", 575.9, 576.4, 315.2, 230.6, 1},
                                         SharedFolder{"realsense_boxes", 617.25, 617.55, 317.4, 246.0, 10},
                                         SharedFolder{"realsense_floor", 386, 386, 319.5, 239.5, 50}),
                         [](const auto& param_info) { return std::string(param_info.param.name); });
}  // namespace
}  // namespace explore::test

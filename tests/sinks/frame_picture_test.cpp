#include "sinks/results_maker.h"
#include "support/analytic_scene.h"
#include "support/test_files.h"

#include <explore/core/errors.h>
#include <explore/sinks/frame_picture.h>

using namespace explore;
namespace fs = std::filesystem;

namespace
{
DepthFrame corridorFrame()
{
	const auto scene = test::corridorScene(8.0, {2.0}, {});
	return test::renderFrame(scene, {}, mrpt::poses::CPose3D(0, 0, 0.5, 0, 0, 0), test::xtionIntrinsics(160, 120));
}

/** Pixels whose colour is near `color`, in columns [from, to). */
int countOf(const mrpt::img::CImage& image, const mrpt::img::TColor& color, unsigned from, unsigned to)
{
	int count = 0;
	for (unsigned y = 30; y < 510; ++y)
		for (unsigned x = from; x < to; ++x)
		{
			const int db = image.at<std::uint8_t>(x, y, 0) - color.B, dg = image.at<std::uint8_t>(x, y, 1) - color.G,
			          dr = image.at<std::uint8_t>(x, y, 2) - color.R;
			if (db * db + dg * dg + dr * dr < 300) ++count;
		}
	return count;
}
}  // namespace

TEST(FramePicture, ShowsDoorWallVanishingPointAndHeadingInBothViews)
{
	StepResult result = test::fullResult();
	result.percepts.obstacles_in_robot = {{3.0F, 3.1F, 3.2F}, {1.0F, 1.0F, 1.0F}, {0.5F, 0.5F, 0.5F}};
	const auto with = drawFramePicture(corridorFrame(), result, {});
	const auto without = drawFramePicture(corridorFrame(), StepResult{}, {});
	for (const auto& color : {style::kDoor, style::kWall, style::kVanishingPoint, style::kChosen, style::kDoorHeading})
		for (const auto& [from, to] : {std::pair{0U, 640U}, {648U, 1128U}})
		{
			EXPECT_GT(countOf(with, color, from, to), 20) << color << " columns from " << from;
			EXPECT_EQ(countOf(without, color, from, to), 0) << color << " columns from " << from;
		}
}

TEST(FramePicture, NotesAreDrawnBesideTheResults)
{
	const mrpt::img::TColor violet(167, 139, 250);
	DoorMark mark = markOf(test::fullResult().percepts.doors.front(), std::nullopt);
	mark.color = violet;
	const PictureNotes notes{"a title", {mark}};
	const auto with = drawFramePicture(corridorFrame(), StepResult{}, {}, notes);
	const auto without = drawFramePicture(corridorFrame(), StepResult{}, {});
	for (const auto& [from, to] : {std::pair{0U, 640U}, {648U, 1128U}})
	{
		EXPECT_GT(countOf(with, violet, from, to), 20) << "columns from " << from;
		EXPECT_EQ(countOf(without, violet, from, to), 0) << "columns from " << from;
	}
}

TEST(FramePicture, NearIsPalerThanFar)
{
	double before = 1000;
	for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
	{
		const auto color = style::depthColor(share);
		const double lightness = 0.3 * color.R + 0.6 * color.G + 0.1 * color.B;
		EXPECT_LT(lightness, before - 10);
		before = lightness;
	}
}

TEST(FramePicture, EveryNthFrameGetsAFile)
{
	const auto folder = test::freshFolder() / "pictures";
	const FramePictures pictures(folder, 3, {});
	DepthFrame frame = corridorFrame();
	for (frame.index = 0; frame.index < 7; ++frame.index) pictures.write(frame, test::fullResult());
	std::vector<std::string> names;
	for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
	std::sort(names.begin(), names.end());
	EXPECT_EQ(names, (std::vector<std::string>{"000000.png", "000003.png", "000006.png"}));
	mrpt::img::CImage image;
	ASSERT_TRUE(image.loadFromFile((folder / "000003.png").string()));
	EXPECT_EQ(image.getWidth(), 1136U);
	EXPECT_EQ(image.getHeight(), 548U);
}

TEST(FramePicture, FolderThatCannotBeMadeIsAnOutputError)
{
	const auto file = test::freshFolder() / "file";
	test::writeFile(file, "in the way");
	EXPECT_THROW(FramePictures(file / "pictures", 1, {}).write(corridorFrame(), test::fullResult()), OutputError);
}

TEST(FramePicture, CloudWithoutImageIsDrawnAsPlan)
{
	DepthFrame frame;
	frame.points_in_camera = {{1.0F}, {0.0F}, {0.0F}};
	const auto image = drawFramePicture(frame, test::fullResult(), {});
	EXPECT_GT(countOf(image, style::kDoor, 648, 1128), 20);
}

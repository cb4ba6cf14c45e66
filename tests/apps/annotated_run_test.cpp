// annotated.rawlog with every end of a run, of other inputs, and as an input itself.
#include "apps/annotated_files.h"
#include "apps/rawlog_maker.h"

#include <gmock/gmock.h>
#include <mrpt/io/lazy_load_path.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservation3DScene.h>
#include <mrpt/obs/CObservation6DFeatures.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <fstream>

using namespace explore::test;
using namespace mrpt::obs;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(AnnotatedRun, OfARunThatGoesOnIsThatOfAWholeOne)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog";
	writeManySensors(log, 9);
	ASSERT_EQ(annotate(log, folder / "whole").exit_code, 0);
	ASSERT_EQ(annotate(log, folder / "o", {"--max-frames", "4"}).exit_code, 0);
	EXPECT_EQ(annotationsIn<CObservation3DScene>(folder / "o").size(), 4U);
	{
		std::ofstream more(folder / "o" / "annotated.rawlog", std::ios::app | std::ios::binary);
		more << "what came after the state was kept";
	}
	ASSERT_EQ(exploreMrpt({"--resume", (folder / "o").string(), "--max-frames", "99", "--quiet"}).exit_code, 0);
	EXPECT_TRUE(readFile(folder / "o" / "annotated.rawlog") == readFile(folder / "whole" / "annotated.rawlog"));
}

TEST(AnnotatedRun, OfDamagedInputHasWhatCameBefore)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeCorridorRawlog(log, {10});
	const std::string bytes = readFile(log);
	writeFile(folder / "cut.rawlog", bytes.substr(0, bytes.size() / 2));
	ASSERT_EQ(annotate(folder / "cut.rawlog", out).exit_code, 3);
	const std::size_t frames = framesOf(out).size();
	ASSERT_GT(frames, 2U);
	EXPECT_EQ(annotationsIn<CObservation6DFeatures>(out).size(), frames);
	const std::size_t inputs = objectsIn(folder / "cut.rawlog").size();
	EXPECT_EQ(objectsIn(out / "annotated.rawlog").size(), 1 + inputs + 4 * frames);
}

TEST(AnnotatedRun, AFullDiskLeavesWholeFrames)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeCorridorRawlog(log, {12});
	ASSERT_EQ(annotate(log, folder / "whole", {"--set", "output.report=false"}).exit_code, 0);
	Program::Setup setup;
	setup.file_size_limit = fs::file_size(folder / "whole" / "annotated.rawlog") * 2 / 3;
	const auto result = annotate(log, out, {"--set", "output.report=false"}, setup);
	EXPECT_EQ(result.exit_code, 5);
	EXPECT_THAT(result.err, HasSubstr("annotated.rawlog"));
	const std::string file = readFile(out / "annotated.rawlog");
	EXPECT_TRUE(readFile(folder / "whole" / "annotated.rawlog").substr(0, file.size()) == file);
	const std::size_t frames = annotationsIn<CObservationRobotPose>(out).size();
	EXPECT_GE(frames, 4U);
	EXPECT_EQ(framesOf(out).size(), frames + 1) << "the line is written first";
	EXPECT_THAT(json::parse(readFile(out / "summary.json"))["exploration"]["reason"].get<std::string>(),
	            HasSubstr("annotated.rawlog"));
}

TEST(AnnotatedRun, ExternalImagesAreFoundFromItsPlace)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	fs::create_directory(folder / "log_Images");
	std::vector<mrpt::math::CMatrix_u16> images;
	writeCorridorRawlog(log, {3, [&](std::size_t i, CObservation3DRangeScan& scan)
	                          {
		                          images.push_back(scan.rangeImage);
		                          scan.rangeImage_convertToExternalStorage("range_" + std::to_string(i) + ".bin",
		                                                                   (folder / "log_Images").string());
	                          }});
	for (int run = 0; run < 2; ++run)  // also over the files of the first
		ASSERT_EQ(annotate(log, out).exit_code, 0);
	expectInputUnchanged(log, out / "annotated.rawlog");
	EXPECT_EQ(fs::canonical(out / "annotated_Images"), fs::canonical(folder / "log_Images"));
	const std::string before = mrpt::io::getLazyLoadPathBase();
	mrpt::io::setLazyLoadPathBase((out / "annotated_Images").string());
	std::size_t met = 0;
	for (const auto& object : objectsIn(out / "annotated.rawlog"))
		if (const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(object))
		{
			scan->load();
			EXPECT_EQ(scan->rangeImage, images[met++]);
		}
	mrpt::io::setLazyLoadPathBase(before);
	EXPECT_EQ(met, 3U);
	ASSERT_EQ(exploreMrpt({"--ini", "corridor.ini", "--rawlog", (out / "annotated.rawlog").string(), "--out",
	                       (folder / "again").string(), "--quiet"})
	              .exit_code,
	          0);
	EXPECT_EQ(framesOf(folder / "again").size(), 3U);
	ASSERT_EQ(exploreMrpt({"--rawlog", log.string(), "--out", out.string(), "--quiet"}).exit_code, 0);
	EXPECT_FALSE(fs::is_symlink(out / "annotated_Images"));
	EXPECT_TRUE(fs::exists(folder / "log_Images" / "range_2.bin"));
}

TEST(AnnotatedRun, IsNotReplacedWhileItIsRead)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeCorridorRawlog(log, {2});
	ASSERT_EQ(annotate(log, out).exit_code, 0);
	const std::string before = readFile(out / "annotated.rawlog");
	const auto result = annotate(out / "annotated.rawlog", out);
	EXPECT_EQ(result.exit_code, 2);
	EXPECT_THAT(result.err, AllOf(HasSubstr("annotated.rawlog"), HasSubstr("--out")));
	EXPECT_TRUE(readFile(out / "annotated.rawlog") == before);
	EXPECT_EQ(framesOf(out).size(), 2U);
}

TEST(AnnotatedRun, ReplayedGivesTheSameFrames)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeCorridorRawlog(log, {8});
	ASSERT_EQ(annotate(log, out).exit_code, 0);
	ASSERT_EQ(annotate(out / "annotated.rawlog", folder / "again").exit_code, 0);
	auto first = framesOf(out), again = framesOf(folder / "again");
	ASSERT_EQ(first.size(), again.size());
	for (std::size_t i = 0; i < first.size(); ++i)
	{
		EXPECT_EQ(first[i]["pose"]["from"], "odometry");
		EXPECT_EQ(again[i]["pose"]["from"], "robot_pose");
		first[i]["pose"].erase("from"), again[i]["pose"].erase("from");
		EXPECT_EQ(first[i], again[i]);
	}
}

TEST(AnnotatedRun, OfASimulatedRobotHasTheFramesThatWereUsed)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	const auto result = exploreMrpt({"--ini", "corridor.ini", "--world", "corridor.sdf", "--max-frames", "5", "--quiet",
	                                 "--out", out.string(), "--set", "output.annotated=true"});
	if (result.exit_code == 2) GTEST_SKIP() << "without simulator: " << result.err;
	ASSERT_EQ(result.exit_code, 0) << result.err;
	std::vector<CObservation3DRangeScan::Ptr> scans;
	for (const auto& object : objectsIn(out / "annotated.rawlog"))
		if (const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(object)) scans.push_back(scan);
	ASSERT_EQ(scans.size(), 5U);
	const auto lines = framesOf(out);
	EXPECT_EQ(scans[2]->sensorLabel, lines[2]["sensor"]);
	EXPECT_NEAR(mrpt::Clock::toDouble(scans[4]->timestamp), lines[4]["t"], 1e-6);
	// A replay takes the frames, rounded to millimetres, for the same.
	ASSERT_EQ(annotate(out / "annotated.rawlog", folder / "again").exit_code, 0);
	const auto again = framesOf(folder / "again");
	ASSERT_EQ(again.size(), 5U);
	for (std::size_t i = 0; i < 5; ++i)
	{
		EXPECT_EQ(again[i]["pose"]["x"], lines[i]["pose"]["x"]);
		ASSERT_FALSE(lines[i]["ground"].is_null());
		EXPECT_NEAR(again[i]["ground"]["camera_height"], lines[i]["ground"]["camera_height"], 0.003);
		EXPECT_EQ(again[i]["walls"].size(), lines[i]["walls"].size());
	}
}

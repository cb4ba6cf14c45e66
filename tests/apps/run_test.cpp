#include "apps/program.h"
#include "apps/rawlog_maker.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <csignal>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

using namespace explore::test;
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
constexpr const char* kMrptExample = "/usr/share/mrpt/datasets/tests_rgbd.rawlog";

std::vector<json> framesIn(const fs::path& out)
{
	std::vector<json> frames;
	for (const auto& line : linesOf(readFile(out / "frames.jsonl"))) frames.push_back(json::parse(line));
	return frames;
}
}  // namespace

TEST(Run, CorridorLeavesAllFilesAndFindsWhatIsThere)
{
	const auto folder = freshFolder();
	writeCorridorRawlog(folder / "log.rawlog", {12});
	const auto result = exploreMrpt(
	    {"--ini", "corridor.ini", "--rawlog", (folder / "log.rawlog").string(), "--out", (folder / "o").string()});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const auto frames = framesIn(folder / "o");
	ASSERT_EQ(frames.size(), 12U);
	for (std::size_t i = 0; i < frames.size(); ++i)
	{
		EXPECT_EQ(frames[i]["frame"], i);
		EXPECT_NEAR(frames[i]["t"].get<double>(), 1.5e9 + 0.1 * static_cast<double>(i), 1e-5);
		EXPECT_NEAR(frames[i]["pose"]["x"].get<double>(), 0.05 * static_cast<double>(i), 1e-6);
		EXPECT_EQ(frames[i]["pose"]["from"], "odometry");
		EXPECT_NEAR(frames[i]["ground"]["camera_height"].get<double>(), 0.5, 0.02);
		EXPECT_GE(frames[i]["walls"].size(), 2U);
	}
	EXPECT_EQ(linesOf(readFile(folder / "o" / "timing.csv")).size(), 13U);
	EXPECT_EQ(linesOf(readFile(folder / "o" / "trajectory.tum")).size(), 12U);

	const json summary = json::parse(readFile(folder / "o" / "summary.json"));
	EXPECT_EQ(summary["source"]["frames"], 12);
	EXPECT_EQ(summary["source"]["lost_bytes"], 0);
	EXPECT_EQ(summary["exploration"]["reason"], "log ended");
	EXPECT_NEAR(summary["exploration"]["path_m"].get<double>(), 0.55, 1e-6);
	EXPECT_NEAR(summary["exploration"]["time_s"].get<double>(), 1.1, 1e-4);
	EXPECT_GT(summary["timing_ms"]["perceive"]["median"].get<double>(), 0.0);
	EXPECT_EQ(summary["config"], "corridor.ini");
	EXPECT_THAT(result.out, HasSubstr("12 frames"));
}

TEST(Run, SameInputGivesTheSameBytes)
{
	const auto folder = freshFolder();
	writeCorridorRawlog(folder / "log.rawlog", {8});
	for (const char* out : {"a", "b"})
		ASSERT_EQ(
		    exploreMrpt({"--rawlog", (folder / "log.rawlog").string(), "--out", (folder / out).string()}).exit_code, 0);
	const std::string frames = readFile(folder / "a" / "frames.jsonl");
	EXPECT_FALSE(frames.empty());
	EXPECT_EQ(frames, readFile(folder / "b" / "frames.jsonl"));
}

TEST(Run, ExampleOfMrptGivesAValidLine)
{
	if (!fs::exists(kMrptExample))
		GTEST_SKIP() << "needs " << kMrptExample << " (package mrpt-apps or libmrpt-common-dev)";
	const auto folder = freshFolder();
	const auto result =
	    exploreMrpt({"--ini", "corridor.ini", "--rawlog", kMrptExample, "--out", (folder / "o").string()});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const auto frames = framesIn(folder / "o");
	ASSERT_EQ(frames.size(), 1U);
	EXPECT_EQ(frames[0]["pose"]["from"], "none");
}

TEST(Run, MaxFramesEndsTheRun)
{
	const auto folder = freshFolder();
	writeCorridorRawlog(folder / "log.rawlog", {12});
	const auto result = exploreMrpt(
	    {"--rawlog", (folder / "log.rawlog").string(), "--out", (folder / "o").string(), "--max-frames", "3"});
	EXPECT_EQ(result.exit_code, 0);
	EXPECT_EQ(framesIn(folder / "o").size(), 3U);
	EXPECT_EQ(json::parse(readFile(folder / "o" / "summary.json"))["exploration"]["reason"], "max frames");
}

TEST(Run, MountEstimateIsUsed)
{
	const auto folder = freshFolder();
	RawlogShape shape{3};
	shape.camera_height_m = 0.8;
	shape.camera_pitch_rad = 0.25;
	shape.record_mount = false;
	writeCorridorRawlog(folder / "log.rawlog", shape);
	const auto result = exploreMrpt({"--rawlog", (folder / "log.rawlog").string(), "--out", (folder / "o").string(),
	                                 "--set", "camera.mount=estimate"});
	ASSERT_EQ(result.exit_code, 0);
	EXPECT_THAT(result.err, HasSubstr("camera mount from the floor in 3 of 3 frames: 0.8"));
	const auto plane = framesIn(folder / "o").at(0)["ground"]["plane"];
	EXPECT_NEAR(plane[2].get<double>(), 1.0, 1e-3);  // level in the robot frame
	EXPECT_NEAR(plane[3].get<double>(), 0.0, 0.01);  // and at the robot's feet
}

TEST(Run, FramesWithoutMeasurementsMeanStop)
{
	const auto folder = freshFolder();
	writeCorridorRawlog(folder / "log.rawlog", {4, [](std::size_t i, auto& scan)
	                                            {
		                                            if (i == 2) scan.rangeImage.fill(0);
	                                            }});
	const auto result = exploreMrpt({"--rawlog", (folder / "log.rawlog").string(), "--out", (folder / "o").string()});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const auto frames = framesIn(folder / "o");
	ASSERT_EQ(frames.size(), 4U);
	EXPECT_EQ(frames[1]["stop"], false);
	EXPECT_EQ(frames[2]["stop"], true);
	EXPECT_EQ(frames[2]["stop_reason"], "empty_frame");
	EXPECT_TRUE(frames[2]["headings"]["chosen"].is_null());
	EXPECT_EQ(frames[2]["command"], json::parse(R"({"v":[0,0,0],"yaw_rate":0})"));
	EXPECT_EQ(frames[3]["stop"], false);
}

TEST(Run, PointsThatAreNoNumbersMeanStop)
{
	const auto folder = freshFolder();
	const auto make_nan = [](std::size_t, mrpt::obs::CObservation3DRangeScan& scan)
	{
		scan.hasRangeImage = false;
		scan.hasPoints3D = true;
		scan.resizePoints3DVectors(1000);
		const float nan = std::numeric_limits<float>::quiet_NaN();
		std::fill(scan.points3D_x.begin(), scan.points3D_x.end(), nan);
		std::fill(scan.points3D_y.begin(), scan.points3D_y.end(), nan);
		std::fill(scan.points3D_z.begin(), scan.points3D_z.end(), std::numeric_limits<float>::infinity());
	};
	writeCorridorRawlog(folder / "log.rawlog", {2, make_nan});
	const auto result = exploreMrpt({"--rawlog", (folder / "log.rawlog").string(), "--out", (folder / "o").string()});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const auto frames = framesIn(folder / "o");
	ASSERT_EQ(frames.size(), 2U);
	for (const auto& frame : frames) EXPECT_EQ(frame["stop"], true);
}

TEST(Run, InterruptLeavesValidFiles)
{
	for (const int signal : {SIGINT, SIGTERM})
	{
		const auto folder = freshFolder();
		writeCorridorRawlog(folder / "log.rawlog", {200});
		// A picture of every frame makes the run last for seconds.
		Program program(EXPLORE_MRPT_PROGRAM,
		                {"--rawlog", (folder / "log.rawlog").string(), "--out", (folder / "o").string(), "--set",
		                 "output.pictures_every=1"},
		                {});
		while (program.running() && linesOf(readFile(folder / "o" / "frames.jsonl")).size() < 2)
			std::this_thread::sleep_for(std::chrono::milliseconds(5));
		program.signal(signal);
		EXPECT_EQ(program.wait().exit_code, 128 + signal);
		const auto frames = framesIn(folder / "o");
		EXPECT_LT(frames.size(), 200U);
		const json summary = json::parse(readFile(folder / "o" / "summary.json"));
		EXPECT_EQ(summary["exploration"]["reason"], "interrupted");
		EXPECT_EQ(summary["source"]["frames"], frames.size());
	}
}

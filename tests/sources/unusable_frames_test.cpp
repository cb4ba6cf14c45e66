// Single frames that are missing or spoilt: the rest of the log is replayed, and the loss is counted.
#include <cmath>
#include <functional>
#include <limits>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
using mrpt::obs::CObservation3DRangeScan;

TEST(ExternalImages, AMissingOneLosesItsFrameOnly)
{
	const auto log = testFolder() / "run.rawlog", images = testFolder() / "run_Images";
	std::filesystem::create_directories(images);
	CObservation3DRangeScan::EXTERNALS_AS_TEXT(false);
	Objects objects;
	for (int i = 0; i < 3; ++i)
	{
		const auto scan = scanOf(sceneFrame(), 0.1 * i);
		scan->rangeImage_convertToExternalStorage("range_" + std::to_string(i) + ".bin", images.string() + "/");
		objects.push_back(scan);
	}
	writeRawlog(log, objects);
	std::filesystem::remove(images / "range_1.bin");
	SourceReport report;
	Listener listener;
	EXPECT_EQ(replay(configFor(log), &report, &listener).size(), 2U);
	EXPECT_EQ(report.skipped_frames, 1U);
	EXPECT_EQ(report.lost_objects, 1U);
	EXPECT_THAT(report.damage, testing::HasSubstr("range_1.bin"));
	EXPECT_EQ(listener.warnings("range_1.bin"), 1U);

	writeBytes(images / "range_1.bin", readBytes(images / "range_0.bin").substr(0, 200));
	EXPECT_EQ(replay(configFor(log), &report).size(), 2U);
	EXPECT_THAT(report.damage, testing::HasSubstr("ends early"));
}

using Spoil = std::function<void(CObservation3DRangeScan&)>;

TEST(UnusableFrames, AreLeftOutAndCounted)
{
	const double nan = std::numeric_limits<double>::quiet_NaN();
	const std::vector<Spoil> spoils = {
	    [&](auto& scan) { scan.sensorPose.x(nan); },          [&](auto& scan) { scan.sensorPose.x(1e200); },
	    [&](auto& scan) { scan.cameraParams.fx(nan); },       [&](auto& scan) { scan.cameraParams.fy(0); },
	    [&](auto& scan) { scan.cameraParams.fx(-500); },      [&](auto& scan) { scan.cameraParams.cx(INFINITY); },
	    [&](auto& scan) { scan.rangeUnits = std::nanf(""); }, [&](auto& scan) { scan.rangeUnits = 0; }};
	for (std::size_t i = 0; i < spoils.size(); ++i)
	{
		const auto bad = scanOf(sceneFrame(), 0.1);
		spoils[i](*bad);
		writeRawlog(testFolder() / "bad.rawlog", {scanOf(sceneFrame(), 0), bad, scanOf(sceneFrame(), 0.2)});
		SourceReport report;
		const auto frames = replay(configFor(testFolder() / "bad.rawlog"), &report);
		ASSERT_EQ(frames.size(), 2U) << "spoil " << i;
		EXPECT_EQ(frames[1].index, 1U);
		EXPECT_EQ(report.skipped_frames, 1U) << "spoil " << i;
		EXPECT_NE(report.damage, "") << "spoil " << i;
	}
}

TEST(UnusableFrames, AScanWithoutDepthIsNoDamage)
{
	auto bare = CObservation3DRangeScan::Create();
	bare->sensorLabel = "CAM";
	bare->timestamp = at(0.1);
	writeRawlog(testFolder() / "bare.rawlog", {scanOf(sceneFrame(), 0), bare});
	SourceReport report;
	EXPECT_EQ(replay(configFor(testFolder() / "bare.rawlog"), &report).size(), 1U);
	EXPECT_EQ(report.skipped_frames, 1U);
	EXPECT_EQ(report.damage, "");
}

}  // namespace
}  // namespace explore::test

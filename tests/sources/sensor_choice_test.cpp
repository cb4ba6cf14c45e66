// Which of a log's depth sensors is used.
#include <explore/core/errors.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
TEST(Sensors, TheFirstIsUsedWithoutALabelAndAllAreReported)
{
	auto other = scanOf(sceneFrame(0.7), 0.05);
	other->sensorLabel = "OTHER";
	const auto log = testFolder() / "a.rawlog";
	writeRawlog(log, {scanOf(sceneFrame(), 0.0), other, scanOf(sceneFrame(), 0.1)});
	SourceReport report;
	Listener listener;
	EXPECT_EQ(replay(configFor(log), &report, &listener).size(), 2U);
	EXPECT_EQ(report.sensor_label, "CAM");
	EXPECT_THAT(report.sensors_found, testing::ElementsAre("CAM", "OTHER"));
	EXPECT_TRUE(listener.said("'OTHER'"));
}

TEST(Sensors, TheLabelChooses)
{
	auto other = scanOf(sceneFrame(0.7), 0.05);
	other->sensorLabel = "OTHER";
	const auto log = testFolder() / "a.rawlog";
	writeRawlog(log, {scanOf(sceneFrame(), 0.0), other, scanOf(sceneFrame(), 0.1)});
	SourceConfig config = configFor(log);
	config.sensor_label = "OTHER";
	const auto frames = replay(config);
	ASSERT_EQ(frames.size(), 1U);
	expectSameDepths(frames[0].image, sceneFrame(0.7).image, 1e-6);
}

TEST(Sensors, AnAskedLabelThatIsNotThereIsRefusedWithThoseThatAre)
{
	const auto log = testFolder() / "a.rawlog";
	writeRawlog(log, {scanOf(sceneFrame(), 0.0)});
	SourceConfig config = configFor(log);
	config.sensor_label = "KINECT";
	try
	{
		replay(config);
		FAIL() << "accepted";
	}
	catch (const InputError& error)
	{
		EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("'KINECT'"), testing::HasSubstr("'CAM'")));
	}
}

TEST(Sensors, ALogWithoutDepthIsRefused)
{
	const auto log = testFolder() / "a.rawlog";
	writeRawlog(log, {mrpt::obs::CActionCollection::Create(), mrpt::obs::CSensoryFrame::Create()});
	EXPECT_THROW(replay(configFor(log)), InputError);
}
}  // namespace
}  // namespace explore::test

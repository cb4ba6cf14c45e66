// annotated.rawlog read back by MRPT, object by object, beside its input and frames.jsonl.
#include "apps/annotated_files.h"
#include "apps/rawlog_maker.h"

#include <gmock/gmock.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservation3DScene.h>
#include <mrpt/obs/CObservation6DFeatures.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/opengl/CText.h>
#include <mrpt/serialization/CArchive.h>

#include <map>

using namespace explore::test;
using namespace mrpt::obs;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(AnnotatedLog, IsWrittenOnRequestOnly)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeCorridorRawlog(log, {2});
	ASSERT_EQ(annotate(log, out).exit_code, 0);
	EXPECT_TRUE(fs::exists(out / "annotated.rawlog"));
	ASSERT_EQ(exploreMrpt({"--rawlog", log.string(), "--out", out.string(), "--quiet"}).exit_code, 0);
	EXPECT_FALSE(fs::exists(out / "annotated.rawlog")) << "of an earlier run";
}

TEST(AnnotatedLog, HoldsAllOfTheInputUnchanged)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeManySensors(log, 6);
	ASSERT_EQ(annotate(log, out).exit_code, 0);
	expectInputUnchanged(log, out / "annotated.rawlog");
	CRawlog read;
	ASSERT_TRUE(read.loadFromRawLogFile((out / "annotated.rawlog").string()));
	// Of the comments, one of ours and one that has the input's as well, CRawlog keeps the last and lists none.
	EXPECT_EQ(read.size(), objectsIn(log).size() - 1 + 6 * 4);
	EXPECT_THAT(read.getCommentText(), AllOf(HasSubstr("explore-mrpt 0."), HasSubstr("[avoider]"),
	                                         HasSubstr("annotated = true"), HasSubstr("recorded on a Monday")));
}

TEST(AnnotatedLog, AfterEachFrameComesWhatWasMadeOfIt)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeManySensors(log, 12);
	ASSERT_EQ(annotate(log, out, {"--set", "source.sensorLabel=TEST"}).exit_code, 0);
	const std::vector<json> frames = framesOf(out);
	ASSERT_EQ(frames.size(), 12U);
	const Objects objects = objectsIn(out / "annotated.rawlog");
	std::size_t frame = 0;
	for (std::size_t i = 0; i < objects.size(); ++i)
	{
		const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(objects[i]);
		if (!scan || scan->sensorLabel != "TEST") continue;
		ASSERT_LT(i + 4, objects.size());
		const auto scene = std::dynamic_pointer_cast<CObservation3DScene>(objects[i + 1]);
		const auto doors = std::dynamic_pointer_cast<CObservation6DFeatures>(objects[i + 2]);
		const auto headings = std::dynamic_pointer_cast<CObservationBearingRange>(objects[i + 3]);
		const auto pose = std::dynamic_pointer_cast<CObservationRobotPose>(objects[i + 4]);
		ASSERT_TRUE(scene && doors && headings && pose) << frame;
		EXPECT_EQ(doors->sensorLabel, "explore.doors");
		EXPECT_EQ(headings->sensorLabel, "explore.headings");
		EXPECT_EQ(pose->sensorLabel, "explore.pose");
		for (std::size_t k = 1; k <= 4; ++k)
			EXPECT_EQ(std::dynamic_pointer_cast<CObservation>(objects[i + k])->timestamp, scan->timestamp);
		EXPECT_NEAR(mrpt::Clock::toDouble(scan->timestamp), frames[frame]["t"], 1e-6);
		EXPECT_NEAR(pose->pose.mean.x(), frames[frame]["pose"]["x"], 1e-9);
		EXPECT_NEAR(pose->pose.mean.x(), 0.05 * static_cast<double>(frame), 1e-6);
		ASSERT_TRUE(scene->scene);
		const auto text = std::dynamic_pointer_cast<mrpt::opengl::CText>(scene->scene->getByName("frame.text"));
		ASSERT_TRUE(text);
		EXPECT_THAT(text->getString(), HasSubstr("frame " + std::to_string(frame) + ": "));
		for (const char* name : {"frame.cloud", "frame.floor_lines", "robot"})
			EXPECT_TRUE(scene->scene->getByName(name)) << name;
		EXPECT_EQ(static_cast<bool>(scene->scene->getByName("frame.door.0")), !frames[frame]["doors"].empty());
		++frame;
	}
	EXPECT_EQ(frame, 12U);
}

TEST(AnnotatedLog, HeadingsAndDoorsAreThoseOfTheLines)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeCorridorRawlog(log, {20, {}, 0.5, 0.1});
	ASSERT_EQ(annotate(log, out).exit_code, 0);
	const std::vector<json> frames = framesOf(out);
	const auto headings = annotationsIn<CObservationBearingRange>(out);
	const auto doors = annotationsIn<CObservation6DFeatures>(out);
	ASSERT_EQ(headings.size(), frames.size());
	ASSERT_EQ(doors.size(), frames.size());
	const std::vector<std::string> names{"door", "vanishing_point", "avoid", "desired", "chosen"};
	std::size_t doors_met = 0, headings_met = 0;
	for (std::size_t i = 0; i < frames.size(); ++i)
	{
		std::map<int, double> yaws;
		for (const auto& one : headings[i]->sensedData) yaws[one.landmarkID] = one.yaw;
		for (int id = 0; id < 5; ++id)
		{
			const json& heading = frames[i]["headings"][names[static_cast<std::size_t>(id)]];
			EXPECT_EQ(yaws.contains(id), !heading.is_null()) << i << " " << id;
			if (yaws.contains(id))
			{
				EXPECT_NEAR(yaws[id], heading.get<double>(), 1e-6) << i << " " << id;
			}
			headings_met += yaws.count(id);
		}
		const json& expected = frames[i]["doors"];
		ASSERT_EQ(doors[i]->sensedFeatures.size(), expected.size()) << i;
		for (std::size_t k = 0; k < expected.size(); ++k, ++doors_met)
		{
			const auto& feature = doors[i]->sensedFeatures[k];
			const json& track = expected[k]["track"];
			EXPECT_EQ(feature.id, track.is_null() ? -1 : track.get<int>());
			const auto in_robot = doors[i]->sensorPose + feature.pose;
			EXPECT_NEAR(doors[i]->sensorPose.pitch(), 0.1, 1e-6);
			EXPECT_NEAR(in_robot.x(), expected[k]["center"][0], 1e-6);
			EXPECT_NEAR(in_robot.y(), expected[k]["center"][1], 1e-6);
			EXPECT_NEAR(in_robot.z(), expected[k]["center"][2], 1e-6);
			const auto ahead = in_robot.composePoint(mrpt::math::TPoint3D(1, 0, 0));
			EXPECT_NEAR(ahead.y - in_robot.y(), expected[k]["normal"][1], 1e-6);
		}
	}
	EXPECT_GT(doors_met, 5U) << "else this log shows nothing";
	EXPECT_GT(headings_met, 40U);
}

TEST(AnnotatedLog, RawlogEditCountsEveryEntry)
{
	const fs::path program = "/usr/bin/rawlog-edit";
	if (!fs::exists(program)) GTEST_SKIP() << "rawlog-edit (package mrpt-apps) is not installed";
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeManySensors(log, 5);
	ASSERT_EQ(annotate(log, out).exit_code, 0);
	Program edit(program.string(), {"--info", "-i", (out / "annotated.rawlog").string()}, {});
	const ProgramResult result = edit.wait();
	ASSERT_EQ(result.exit_code, 0) << result.err;
	for (const char* label :
	     {"LASER", "IMU", "ODOMETRY", "TEST", "OTHER_CAMERA", "explore.doors", "explore.headings", "explore.pose"})
	{
		std::string found;
		for (const std::string& line : linesOf(result.out))
			if (line.find(std::string(" ") + label + " / ") != std::string::npos) found = line;
		EXPECT_THAT(found, HasSubstr("/      5 /")) << label;
	}
	EXPECT_THAT(result.out, HasSubstr("Actions/SensoryFrame format       : No"));
}

TEST(AnnotatedLog, OfActionsAndSensoryFramesTheObservations)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeCorridorRawlog(folder / "plain.rawlog", {4});
	{
		mrpt::io::CFileGZOutputStream file(log.string());
		auto archive = mrpt::serialization::archiveFrom(file);
		CSensoryFrame frame;
		for (const auto& object : objectsIn(folder / "plain.rawlog"))
		{
			frame.insert(std::dynamic_pointer_cast<CObservation>(object));
			if (frame.size() < 4) continue;  // two images in each
			archive << CActionCollection() << frame;
			frame.clear();
		}
	}
	ASSERT_EQ(annotate(log, out).exit_code, 0);
	expectInputUnchanged(log, out / "annotated.rawlog");
	EXPECT_EQ(annotationsIn<CObservation6DFeatures>(out).size(), 4U);
	const Objects objects = objectsIn(out / "annotated.rawlog");
	EXPECT_EQ(objects.size(), 1U + 8U + 4U * (annotationsIn<CObservationRobotPose>(out).empty() ? 3U : 4U));
}

TEST(AnnotatedLog, WithoutPosesThereIsNone)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog", out = folder / "o";
	writeCorridorRawlog(log, {3});
	ASSERT_EQ(annotate(log, out, {"--set", "source.pose=none"}).exit_code, 0);
	EXPECT_TRUE(annotationsIn<CObservationRobotPose>(out).empty());
	EXPECT_EQ(annotationsIn<CObservation3DScene>(out).size(), 3U);
}

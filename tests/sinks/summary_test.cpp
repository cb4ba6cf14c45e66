#include "sinks/results_maker.h"

#include <explore/sinks/summary.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

using namespace explore;
using nlohmann::json;
using testing::HasSubstr;

namespace
{
DepthFrame frameAt(double x, double y, double t_s)
{
	DepthFrame frame = test::fullFrame();
	frame.map_from_robot = mrpt::poses::CPose3D(x, y, 0, 0, 0, 0);
	frame.timestamp = mrpt::Clock::fromDouble(1000.0 + t_s);
	return frame;
}

RunSummary someSummary()
{
	RunSummary summary;
	summary.version = "1.2.3";
	summary.config = "corridor.ini";
	summary.input = {"rawlog",
	                 "a.rawlog",
	                 2,
	                 5,
	                 40.5,
	                 3,
	                 11,
	                 1,
	                 "cut off at byte 99",
	                 "KINECT",
	                 {"KINECT", "OTHER"},
	                 PoseOrigin::odometry,
	                 false};
	summary.tally.add(frameAt(0, 0, 0), test::fullResult());
	summary.tally.add(frameAt(3, 4, 2.5), StepResult{});
	summary.warnings = {"the floor is not there", "walls look bent"};
	summary.reason = "input damaged";
	summary.timing = {{"perceive", {5.0, 9.0}}, {"total", {6.0, 10.0}}};
	summary.peak_rss_mb = 42.5;
	summary.processor = {1.5, 2.5};
	return summary;
}
}  // namespace

TEST(Summary, CarriesWhatTheContractNames)
{
	const json document = json::parse(summaryJson(someSummary()));
	EXPECT_EQ(document["schema"], 1);
	EXPECT_EQ(document["version"], "1.2.3");
	EXPECT_EQ(document["config"], "corridor.ini");
	EXPECT_EQ(document["source"], json::parse(R"({"kind":"rawlog","path":"a.rawlog","frames":2,"lost_bytes":11,
		"lost_objects":1,"skipped_frames":2,"dropped_frames":5,"oldest_frame_ms":40.5,"away_frames":3,"damage":"cut off at byte 99","sensor":"KINECT",
		"sensors_found":["KINECT","OTHER"],"pose_from":"odometry","identity_mount":false})"));
	EXPECT_EQ(document["doors"], json::array());
	EXPECT_EQ(document["corridors"], json::array());
	EXPECT_EQ(document["frames_with_ground"], 1);
	EXPECT_EQ(document["frames_with_door"], 1);
	EXPECT_EQ(document["frames_stopped"], 0);
	EXPECT_EQ(document["warnings"], json::parse(R"(["the floor is not there","walls look bent"])"));
	EXPECT_EQ(document["timing_ms"], json::parse(R"({"perceive":{"median":5,"p99":9},"total":{"median":6,"p99":10}})"));
	EXPECT_EQ(document["peak_rss_mb"], 42.5);
	EXPECT_EQ(document["processor"], json::parse(R"({"cpu_s":1.5,"wall_s":2.5})"));
}

TEST(Summary, TruthIsThereWhereItIsKnown)
{
	RunSummary summary = someSummary();
	EXPECT_FALSE(json::parse(summaryJson(summary)).contains("truth"));
	summary.truth = TruthSummary{{{2.5, {1, 2, 0}}, {8, {3, 4, 0.5}}}, 0.125, 31.5, 0.25, 3, 40.5, 0.875};
	EXPECT_EQ(json::parse(summaryJson(summary))["truth"],
	          json::parse(R"({"collisions":2,"contacts":[{"t":2.5,"position_in_map":[1,2,0]},
		{"t":8,"position_in_map":[3,4,0.5]}],"min_clearance_m":0.125,"path_m":31.5,"from_start_m":0.25,"goal_flips":3,
		"reachable_m2":40.5,"coverage":0.875})"));
	EXPECT_THAT(summaryText(summary), AllOf(HasSubstr("2 collisions"), HasSubstr("coverage 87.5 % of 40.5 m2")));
	summary.truth = TruthSummary{};
	EXPECT_TRUE(json::parse(summaryJson(summary))["truth"]["coverage"].is_null());
}

TEST(Summary, ExplorationIsNeverCalledCompleteAndUnknownsAreNull)
{
	const json exploration = json::parse(summaryJson(someSummary()))["exploration"];
	EXPECT_EQ(exploration, json::parse(R"({"complete":false,"reason":"input damaged","known_free_m2":null,"path_m":5,
		"time_s":2.5,"home_error_m":null,"left_over":[]})"));
}

TEST(Summary, RunWithoutFramesOrPoses)
{
	RunSummary summary;
	json document = json::parse(summaryJson(summary));
	EXPECT_TRUE(document["exploration"]["path_m"].is_null());
	EXPECT_TRUE(document["exploration"]["time_s"].is_null());
	EXPECT_TRUE(document["config"].is_null());
	EXPECT_EQ(document["timing_ms"], json::object());
	EXPECT_EQ(document["warnings"], json::array());

	DepthFrame without_pose;
	summary.tally.add(without_pose, StepResult{});
	document = json::parse(summaryJson(summary));
	EXPECT_TRUE(document["exploration"]["path_m"].is_null());
	EXPECT_EQ(document["exploration"]["time_s"], 0.0);
}

TEST(Summary, PathFollowsEveryCorner)
{
	RunTally tally;
	for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}})
		tally.add(frameAt(x, y, 0), StepResult{});
	EXPECT_DOUBLE_EQ(tally.path_m().value_or(-1), 4.0);
}

TEST(Summary, GroundThatIsCarriedOnCountsAsNotSeen)
{
	StepResult carried = test::fullResult();
	carried.percepts.ground->seen = false;
	RunTally tally;
	tally.add(test::fullFrame(), carried);
	EXPECT_EQ(tally.frames_with_ground, 0U);
}

TEST(SummaryText, SaysWhatWasLost)
{
	const std::string text = summaryText(someSummary());
	EXPECT_THAT(text, HasSubstr("2 frames of a.rawlog"));
	EXPECT_THAT(text, HasSubstr("5.0 m in 2.5 s"));
	EXPECT_THAT(text, HasSubstr("DAMAGED: cut off at byte 99 (lost: 11 bytes, 1 objects)"));
	RunSummary intact = someSummary();
	intact.input.damage.clear();
	intact.input.skipped_frames = 0;
	EXPECT_EQ(summaryText(intact).find("DAMAGED"), std::string::npos);
}

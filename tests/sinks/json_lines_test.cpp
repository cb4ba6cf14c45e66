#include "sinks/results_maker.h"

#include <explore/sinks/json_lines.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

using namespace explore;
using nlohmann::json;

namespace
{
json parsed(const DepthFrame& frame, const StepResult& result)
{
	return json::parse(frameLine(frame, result));
}
}  // namespace

TEST(JsonLines, OneLineInTheDocumentedOrder)
{
	const std::string line = frameLine(test::fullFrame(), test::fullResult());
	EXPECT_EQ(line.find('\n'), line.size() - 1);
	std::size_t at = 0;
	for (const char* key :
	     {"frame", "t", "sensor", "pose", "ground", "walls", "doors", "headings", "goal", "stop_reason"})
	{
		const std::size_t found = line.find('"' + std::string(key) + "\":", at);
		ASSERT_NE(found, std::string::npos) << key;
		at = found;
	}
	std::vector<std::string> keys;
	const auto ordered = nlohmann::ordered_json::parse(line);
	for (const auto& [key, value] : ordered.items()) keys.push_back(key);
	EXPECT_EQ(keys, (std::vector<std::string>{"frame", "t", "sensor", "pose", "ground", "walls", "doors",
	                                          "vanishing_points", "headings", "chosen_elevation", "open_path", "stop",
	                                          "command", "goal", "stop_reason"}));
}

TEST(JsonLines, EveryFieldCarriesItsOwnValue)
{
	const json line = parsed(test::fullFrame(), test::fullResult());
	EXPECT_EQ(line["frame"], 7);
	EXPECT_EQ(line["t"], 1416537600.125);
	EXPECT_EQ(line["sensor"], "KINECT");
	EXPECT_EQ(line["pose"]["x"], 1.0);
	EXPECT_EQ(line["pose"]["y"], 2.0);
	EXPECT_EQ(line["pose"]["z"], 0.5);
	EXPECT_NEAR(line["pose"]["yaw"].get<double>(), 1.5707963267948966, 1e-15);
	EXPECT_EQ(line["pose"]["from"], "odometry");
	EXPECT_EQ(line["ground"], json::parse(R"({"plane":[0,0,1,0.01],"camera_height":0.62,"seen":true})"));
	EXPECT_EQ(line["walls"], json::parse(R"([{"plane":[0,-1,0,1],"inliers":1234,
		"floor_line":{"point":[0,1,0],"direction":[1,0,0]}}])"));
	EXPECT_EQ(line["doors"], json::parse(R"([{"center":[2,1,1.02],"normal":[0,-1,0],"width":0.92,"height":2.04,
		"verdict":"open","clear_width":0.9,"confidence":0.97,"track":3}])"));
	EXPECT_EQ(line["vanishing_points"],
	          json::parse(R"([{"point":[5,0,0.5],"direction":[1,0,0],"walls":[0,2],"track":1}])"));
	EXPECT_EQ(line["headings"],
	          json::parse(R"({"door":0.31,"vanishing_point":0.02,"avoid":0.25,"desired":0.3,"chosen":0.29})"));
	EXPECT_EQ(line["open_path"], 3.4);
	EXPECT_EQ(line["stop"], false);
	EXPECT_EQ(line["command"], json::parse(R"({"v":[0.4,0,0],"yaw_rate":0.1})"));
	EXPECT_TRUE(line["stop_reason"].is_null());
}

TEST(JsonLines, GoalPointIsGivenInTheMapFrame)
{
	// The robot stands at (1, 2, 0.5) and looks along the map's y axis: 2 m ahead and 1 m left of it is (0, 4, 0.5).
	const json goal = parsed(test::fullFrame(), test::fullResult())["goal"];
	EXPECT_EQ(goal["kind"], "door");
	EXPECT_EQ(goal["track"], 3);
	EXPECT_NEAR(goal["point_in_map"][0].get<double>(), 0.0, 1e-12);
	EXPECT_NEAR(goal["point_in_map"][1].get<double>(), 4.0, 1e-12);
	EXPECT_NEAR(goal["point_in_map"][2].get<double>(), 0.5, 1e-12);
}

TEST(JsonLines, NothingFoundIsNullOrEmpty)
{
	StepResult result;
	result.decision.stop = true;
	result.decision.stop_reason = StopReason::empty_frame;
	const json line = parsed(DepthFrame{}, result);
	EXPECT_TRUE(line["ground"].is_null());
	EXPECT_EQ(line["walls"], json::array());
	EXPECT_EQ(line["doors"], json::array());
	EXPECT_EQ(line["vanishing_points"], json::array());
	for (const char* key : {"door", "vanishing_point", "avoid", "desired", "chosen"})
		EXPECT_TRUE(line["headings"][key].is_null()) << key;
	EXPECT_EQ(line["pose"]["from"], "none");
	EXPECT_EQ(line["goal"], json::parse(R"({"kind":"none","track":null,"point_in_map":null})"));
	EXPECT_EQ(line["stop"], true);
	EXPECT_EQ(line["stop_reason"], "empty_frame");
}

TEST(JsonLines, UnmeasuredDoorFieldsAreNull)
{
	StepResult result = test::fullResult();
	result.percepts.doors[0].height_m.reset();
	result.percepts.doors[0].confidence.reset();
	result.percepts.doors[0].track.reset();
	const json door = parsed(test::fullFrame(), result)["doors"][0];
	EXPECT_TRUE(door["height"].is_null());
	EXPECT_TRUE(door["confidence"].is_null());
	EXPECT_TRUE(door["track"].is_null());
}

TEST(JsonLines, NumbersReadBackBitForBit)
{
	StepResult result = test::fullResult();
	for (const double value : {0.1, 1.0 / 3.0, 1e-17, -2.2250738585072014e-308, 123456789.123456789})
	{
		result.decision.open_path_m = value;
		EXPECT_EQ(parsed(test::fullFrame(), result)["open_path"].get<double>(), value);
	}
}

TEST(JsonLines, NonFiniteResultIsAnErrorAndNeverALine)
{
	for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
	{
		StepResult result = test::fullResult();
		result.decision.headings.chosen_rad = value;
		EXPECT_THROW(frameLine(test::fullFrame(), result), std::logic_error);
		result = test::fullResult();
		result.percepts.walls[0].plane.d_m = value;
		EXPECT_THROW(frameLine(test::fullFrame(), result), std::logic_error);
	}
}

TEST(JsonLines, LabelOfAnyBytesStaysValidJson)
{
	DepthFrame frame = test::fullFrame();
	frame.sensor_label = "a\"b\\c\n\xff\xfe";
	const json line = parsed(frame, test::fullResult());
	EXPECT_EQ(line["sensor"].get<std::string>().substr(0, 6), "a\"b\\c\n");
}

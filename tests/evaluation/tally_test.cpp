#include <explore/core/errors.h>
#include <explore/evaluation/figures.h>
#include <explore/evaluation/log_score.h>
#include <explore/evaluation/requirements.h>
#include <gmock/gmock.h>

#include <random>

using namespace explore;
using namespace explore::evaluation;

namespace
{
Tally randomTally(std::mt19937_64& random)
{
	Tally tally;
	const auto some = [&] { return static_cast<Count>(random() % 3); };
	const auto errors = [&](std::vector<double>& list)
	{
		for (Count i = some(); i > 0; --i) list.push_back(rounded(static_cast<double>(random() % 10000) / 7e3 - 0.5));
	};
	tally.frames = 1 + some();
	for (DoorCounts& doors : tally.doors) doors = {some(), some(), some()};
	tally.report_frames = some();
	tally.false_alarm_frames = some();
	tally.corridor_frames = some();
	tally.plain_null = some();
	tally.heading_frames = 2 + some();
	tally.good_headings = some();
	tally.collisions = some();
	errors(tally.width_errors_m);
	errors(tally.center_errors_m);
	errors(tally.direction_errors_rad);
	for (Count i = some(); i > 0; --i)
		tally.candidates.push_back({static_cast<double>(random() % 1000) / 999.0, random() % 2 == 0});
	if (some() > 0) tally.false_alarm_causes["wall_split"] = 1 + some();
	if (some() > 0) tally.miss_causes["occluded"] = 1 + some();
	tally.confusion[random() % 9][random() % 9] = some();
	return tally;
}

LogScore randomLog(const std::string& name, std::uint64_t seed)
{
	std::mt19937_64 random(seed);
	LogScore log;
	log.log = name;
	log.has_truth = true;
	log.family = "family";
	log.platform = "ground";
	log.noise = "none";
	log.remarks = {"a remark with \"quotes\" and ü"};
	log.worst = {{7, 3, 2.5, "occluded", {"missed: a", "false alarm"}}};
	for (int scene = 0; scene < 20; ++scene) log.scenes.push_back({scene, randomTally(random)});
	return log;
}

std::string throughText(const LogScore& log)
{
	const Json document = Json::parse(jsonText(logJson(log)));
	return jsonText(logJson(logOf({document, "memory"})));
}
}  // namespace

TEST(Tally, LogsReadBackAsTheyWereWritten)
{
	for (std::uint64_t seed = 0; seed < 20; ++seed)
	{
		const LogScore log = randomLog("a.rawlog", seed);
		EXPECT_EQ(throughText(log), jsonText(logJson(log)));
	}
}

TEST(Tally, UnknownOrWrongEntriesAreRefused)
{
	const auto messageFor = [](const std::string& text) -> std::string
	{
		const Json document = Json::parse(text);
		try
		{
			(void)tallyOf({document, "part/eval.json"});
			return "accepted";
		}
		catch (const InputError& error)
		{
			return error.what();
		}
	};
	EXPECT_EQ(messageFor(R"({"frames":3})"), "accepted");
	EXPECT_THAT(messageFor(R"({"framse":3})"), testing::HasSubstr("part/eval.json: at framse"));
	EXPECT_THAT(messageFor(R"({"frames":-3})"), testing::HasSubstr("at frames"));
	EXPECT_THAT(messageFor(R"({"width_errors":[0.1,null]})"), testing::HasSubstr("width_errors[1]: null"));
	EXPECT_THAT(messageFor(R"({"confusion":[[1]]})"), testing::HasSubstr("9 rows"));
	EXPECT_THAT(messageFor(R"({"candidates":[[1.5,1]]})"), testing::HasSubstr("candidates[0][0]"));
}

TEST(Tally, FiguresAreThoseOfTheScenesWhateverTheirLog)
{
	const LogScore both = randomLog("both", 4);
	LogScore first = both, second = both;
	first.scenes.resize(8);
	second.scenes.erase(second.scenes.begin(), second.scenes.begin() + 8);
	second.log = "second";
	const auto pooled = resultsOf({both}), parts = resultsOf({first, second});
	ASSERT_TRUE(pooled.positives && parts.positives);
	EXPECT_EQ(pooled.positives->scenes, 20U);
	EXPECT_EQ(pooled.positives->main().precision->low, parts.positives->main().precision->low);
	EXPECT_EQ(pooled.positives->width_m.p99, parts.positives->width_m.p99);
	EXPECT_EQ(pooled.positives->confidence.calibration_error, parts.positives->confidence.calibration_error);
}

TEST(Figures, OfAHandMadeCase)
{
	LogScore log = randomLog("a", 1);
	log.scenes.clear();
	Tally tally;
	tally.frames = 2;
	tally.doors[kMainTolerance] = {3, 1, 2};
	tally.width_errors_m = {-0.05, 0.01, 0.02};
	tally.corridor_frames = 2;
	tally.corridor_given = 1;
	tally.heading_frames = 2;
	tally.good_headings = 1;
	log.scenes = {{0, tally}, {1, {}}};
	log.scenes[1].tally.frames = 1;
	const auto results = resultsOf({log});
	const Figures& figures = *results.positives;
	EXPECT_EQ(figures.scenes, 2U);
	EXPECT_EQ(figures.sum.frames, 3U);
	EXPECT_DOUBLE_EQ(figures.main().precision->value, 0.75);
	EXPECT_DOUBLE_EQ(figures.main().recall->value, 0.6);
	EXPECT_EQ(figures.width_m.bias, 0.01);
	EXPECT_EQ(figures.width_m.median, 0.02);
	EXPECT_EQ(figures.width_m.p99, 0.05);
	EXPECT_DOUBLE_EQ(figures.direction_given->value, 0.5);
	EXPECT_FALSE(figures.direction_null);
	EXPECT_DOUBLE_EQ(figures.good_headings->value, 0.5);
	ASSERT_EQ(figures.confidence.curve.size(), 1U) << "without confidences the curve is one point";
	EXPECT_DOUBLE_EQ(figures.confidence.curve[0].precision, 0.75);
}

TEST(Figures, ThePapersRowsComeInItsOrder)
{
	std::vector<LogScore> logs{randomLog("a", 1), randomLog("b", 2), randomLog("c", 3), randomLog("d", 4)};
	logs[0].configuration = "another";
	logs[1].configuration = "multiple_walls_multiple_doors";
	logs[2].configuration = "single wall multiple doors";
	logs[3].configuration = "single wall single door";
	std::vector<std::string> names;
	for (const Group& group : resultsOf(logs).configurations) names.push_back(group.name);
	EXPECT_EQ(names, (std::vector<std::string>{"single wall single door", "single wall multiple doors",
	                                           "multiple_walls_multiple_doors", "another", "all of them"}));
}

TEST(Requirements, TheEndOfTheIntervalCountsUnlessTheValueIsAsked)
{
	LogScore log = randomLog("a", 1);
	log.scenes.clear();
	for (int i = 0; i < 100; ++i)
	{
		Tally tally;
		tally.frames = 1;
		tally.doors[kMainTolerance] = {1, i == 0 ? 1U : 0U, 0};
		log.scenes.push_back({i, tally});
	}
	const auto results = resultsOf({log});
	const auto missed = [&](const std::string& text) { return missedRequirements(parseRequirements(text), results); };
	EXPECT_TRUE(missed("precision.value=0.99").empty());
	EXPECT_EQ(missed("precision=0.99").size(), 1U);
	EXPECT_TRUE(missed("precision=0.9,recall=0.96").empty());
	EXPECT_EQ(missed("recall=0.97").size(), 1U) << "100 scenes without a miss: 0.025^(1/100) = 0.9638";
	EXPECT_THAT(missed("false_alarms=0.5"), testing::ElementsAre(testing::HasSubstr("not measured")));
}

TEST(Requirements, WhatIsNoRequirementIsRefused)
{
	for (const char* wrong :
	     {"precison=0.9", "precision", "precision=", "precision=high", "precision=1.5", "precision=-0.1",
	      "precision=nan", "precision=0.9,", ",precision=0.9", "", "=0.9", ".value=0.9", "precision.median=0.9"})
		try
		{
			(void)parseRequirements(wrong);
			FAIL() << wrong;
		}
		catch (const ConfigError& error)
		{
			EXPECT_THAT(error.what(), testing::HasSubstr("--require")) << wrong;
			EXPECT_THAT(error.what(), testing::HasSubstr("precision, recall, false_alarms")) << wrong;
		}
	EXPECT_EQ(parseRequirements("precision=1,recall.value=0").size(), 2U);
}

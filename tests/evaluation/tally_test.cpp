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
	tally.open_frames = tally.open_reports = some();
	tally.narrow_hits = some();
	tally.narrow_misses = some();
	tally.corridor_frames = some();
	tally.corridor_given = tally.corridor_close = some();
	tally.plain_null = some();
	tally.heading_frames = 2 + some();
	tally.good_headings = some();
	tally.collisions = some();
	errors(tally.width_errors_m);
	for (auto* list : {&tally.center_errors_m, &tally.along_errors_m, &tally.across_errors_m, &tally.hit_distances_m})
		for (std::size_t i = 0; i < tally.width_errors_m.size(); ++i)
			list->push_back(rounded(static_cast<double>(random() % 10000) / 2e3));
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
	EXPECT_THAT(messageFor(R"({"width_errors":[0.1],"center_errors":[0.1]})"), testing::HasSubstr("as many errors"));
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
	EXPECT_EQ(pooled.positives->hits.width_m.p99, parts.positives->hits.width_m.p99);
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
	tally.center_errors_m = {0.05, 0.05, 0.13};
	tally.along_errors_m = {0.03, -0.04, 0.05};
	tally.across_errors_m = {0.04, 0.03, 0.12};
	tally.hit_distances_m = {2.0, 3.0, 3.1};
	tally.narrow_hits = 1;
	tally.narrow_misses = 3;
	tally.corridor_close = 1;
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
	EXPECT_EQ(figures.hits.width_m.bias, 0.01);
	EXPECT_EQ(figures.hits.width_m.median, 0.02);
	EXPECT_EQ(figures.hits.width_m.p99, 0.05);
	EXPECT_EQ(figures.hits.center_m.p99, 0.13);
	EXPECT_EQ(figures.near_hits.width_m.count, 2U) << "doors up to 3 m";
	EXPECT_EQ(figures.near_hits.width_m.bias, -0.05);
	EXPECT_EQ(figures.near_hits.along_m.bias, -0.04);
	EXPECT_EQ(figures.near_hits.along_m.p99, 0.04);
	EXPECT_EQ(figures.near_hits.across_m.p99, 0.04);
	EXPECT_EQ(figures.narrow_recall->value, 0.25);
	EXPECT_EQ(figures.direction_close->value, 1.0);
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

/** Scenes of a family, each with this tally. */
LogScore logOf(const std::string& family, bool negative, int scenes, const Tally& tally)
{
	LogScore log;
	log.log = family;
	log.has_truth = true;
	log.family = family;
	log.platform = "ground";
	log.noise = "none";
	log.negative = negative;
	for (int i = 0; i < scenes; ++i) log.scenes.push_back({i, tally});
	return log;
}

Tally tallyWith(Count frames, Count hits, Count false_alarms, Count misses)
{
	Tally tally;
	tally.frames = frames;
	tally.doors[kMainTolerance] = {hits, false_alarms, misses};
	tally.false_alarm_frames = false_alarms;
	return tally;
}

TEST(Figures, MirrorsAreInNoPool)
{
	const auto results =
	    resultsOf({logOf("frontal_door", false, 10, tallyWith(1, 1, 0, 0)),
	               logOf("mirror", true, 10, tallyWith(1, 0, 1, 0)), logOf("window", true, 10, tallyWith(1, 0, 0, 0))});
	EXPECT_EQ(results.negatives->false_alarm_frames->all, 10U);
	EXPECT_EQ(results.negatives->false_alarm_frames->good, 0U);
	EXPECT_EQ(results.everything->main().precision->value, 1.0);
	ASSERT_EQ(results.families.size(), 3U);
	EXPECT_EQ(results.families.back().name, "mirror");
	EXPECT_TRUE(results.families.back().by_tracks);
	EXPECT_EQ(results.families.back().figures.false_alarm_frames->good, 10U);
}

TEST(Figures, PoolsAreOfEachRobotAndNoiseAndOfAll)
{
	auto first = logOf("corner_door", false, 4, tallyWith(1, 1, 0, 1)), second = first;
	second.platform = "mav";
	second.log = "second";
	const auto results = resultsOf({first, second, logOf("stairwell", true, 5, tallyWith(1, 0, 1, 0))});
	std::vector<std::string> names;
	for (const Group& group : results.pooled) names.push_back(group.name + "/" + group.platform);
	EXPECT_EQ(names, (std::vector<std::string>{"all with doors/ground", "all with doors/mav", "all with doors/",
	                                           "all without doors/ground"}));
	ASSERT_EQ(results.overall.size(), 3U);
	EXPECT_EQ(results.overall.back().figures.main().precision->all, 13U) << "8 hits, 5 false alarms without doors";
	ASSERT_EQ(results.corners.size(), 3U);
	EXPECT_EQ(results.corners.back().figures.main().recall->value, 0.5);
	ASSERT_EQ(results.hazards.size(), 1U);
}

TEST(Figures, UnscoredFramesAreInNoShareOfFrames)
{
	Tally far = tallyWith(2, 0, 0, 0);
	far.unscored_frames = 1;
	const auto results = resultsOf({logOf("stairwell", true, 10, far)});
	EXPECT_EQ(results.negatives->false_alarm_frames->all, 10U);
}

TEST(Requirements, OfEachFamilyAreNamedWhereTheyAreMissed)
{
	const auto results =
	    resultsOf({logOf("frontal_door", false, 200, tallyWith(1, 1, 0, 0)),
	               logOf("corner_door", false, 200, tallyWith(10, 8, 0, 2)),
	               logOf("window", true, 200, tallyWith(1, 0, 0, 0)), logOf("mirror", true, 5, tallyWith(1, 0, 1, 0))});
	const auto missed = [&](const std::string& text) { return missedRequirements(parseRequirements(text), results); };
	EXPECT_THAT(missed("recall@each=0.9"),
	            testing::ElementsAre(testing::StartsWith("recall@each of corner_door, ground, none: measured 0.8000")));
	EXPECT_TRUE(missed("recall@frontal_door=0.95,recall@corner_door.value=0.8").empty());
	EXPECT_EQ(missed("corner_recall.value=0.81").size(), 1U);
	EXPECT_TRUE(missed("false_alarms@each=0.02,hazard_open=0.02").empty()) << "mirrors are no part of it";
	EXPECT_EQ(missed("false_alarms@mirror=0.02").size(), 1U) << "unless they are named";
	EXPECT_THAT(missed("recall@basement=0.1"), testing::ElementsAre(testing::HasSubstr("not measured")));
}

TEST(Requirements, MediansAndConfidencesHaveIntervalsToo)
{
	LogScore log = logOf("frontal_door", false, 0, {});
	std::mt19937_64 random(5);
	for (int i = 0; i < 400; ++i)
	{
		Tally tally = tallyWith(1, 1, 0, 0);
		const double error = rounded(0.02 * static_cast<double>(random() % 1000) / 1000.0);
		tally.width_errors_m = tally.center_errors_m = tally.along_errors_m = tally.across_errors_m = {error};
		tally.hit_distances_m = {2.0};
		tally.candidates = {{0.9, random() % 10 != 0}, {0.1, random() % 10 == 0}};
		log.scenes.push_back({i, tally});
	}
	const auto results = resultsOf({log});
	const ErrorFigures& width = results.positives->near_hits.width_m;
	// The median of 400 uniform numbers on 0…0.02 m: 0.01 ± 1.96 · 0.02/(2 √400) = ± 0.001.
	EXPECT_NEAR(*width.median, 0.01, 0.0015);
	EXPECT_NEAR(width.interval->high - width.interval->low, 0.002, 0.0007);
	EXPECT_LE(width.interval->low, *width.median);
	EXPECT_GE(width.interval->high, *width.median);
	const ConfidenceFigures& confidence = results.everything->confidence;
	EXPECT_LT(*confidence.calibration_error, 0.03);
	EXPECT_NEAR(*confidence.auroc, 0.9, 0.03);
	// Hanley and McNeil's standard error for 0.9 of 400 + 400 is about 0.011; two candidates a scene.
	EXPECT_NEAR(confidence.auroc_interval->high - confidence.auroc_interval->low, 0.044, 0.02);
	const auto missed = [&](const std::string& text) { return missedRequirements(parseRequirements(text), results); };
	EXPECT_TRUE(missed("near_width_error=0.02,near_center_error.value=0.0115,auroc=0.8").empty());
	EXPECT_THAT(missed("near_width_error=0.0101"),
	            testing::ElementsAre(
	                testing::AllOf(testing::HasSubstr("at the upper end"), testing::Not(testing::HasSubstr("(")))));
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
	for (const char* wrong : {"precison=0.9", "precision", "precision=", "precision=high", "precision=1.5",
	                          "precision=-0.1", "precision=nan", "precision=0.9,", ",precision=0.9", "", "=0.9",
	                          ".value=0.9", "precision.median=0.9", "precision@=0.9", "@each=0.9"})
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

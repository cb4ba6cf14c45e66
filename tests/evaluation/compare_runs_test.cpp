#include <explore/core/errors.h>
#include <explore/evaluation/compare_text.h>
#include <gmock/gmock.h>

#include <random>

using namespace explore;
using namespace explore::evaluation;
using testing::HasSubstr;

namespace
{
constexpr int kScenes = 300;

/** A door a scene; `found(scene)` says whether it is a hit. */
template <class Found>
LogScore doorLog(const std::string& path, const Found& found)
{
	LogScore log;
	log.log = path;
	log.has_truth = true;
	log.family = "frontal_door";
	log.platform = "ground";
	log.noise = "kinect";
	for (int scene = 0; scene < kScenes; ++scene)
	{
		Tally tally;
		tally.frames = 1;
		auto& doors = tally.doors[kMainTolerance];
		++(found(scene) ? doors.hits : doors.misses);
		log.scenes.push_back({scene, tally});
	}
	return log;
}

/** Hard scenes are missed by everybody: what makes paired intervals narrow. */
bool hard(int scene)
{
	return scene % 3 == 0;
}

Difference figure(const RunComparison& run, std::string_view name)
{
	const auto figures = comparedFigures();
	for (std::size_t i = 0; i < figures.size(); ++i)
		if (figures[i].name == name) return run.figures[i];
	throw std::logic_error("no such figure");
}

NamedRun runOf(const std::string& name, std::vector<LogScore> logs)
{
	NamedRun run;
	run.name = name;
	run.evaluation.logs = std::move(logs);
	return run;
}
}  // namespace

TEST(CompareRuns, SceneByScene)
{
	const auto base = runOf("base", {doorLog("a.rawlog", [](int scene) { return !hard(scene); })});
	const auto other = runOf("other", {doorLog("a.rawlog", [](int scene) { return !hard(scene) && scene % 50 != 1; })});
	const RunComparison comparison = compareRuns(base, other);
	EXPECT_EQ(comparison.scenes, 300U);
	EXPECT_EQ(comparison.unpaired, 0U);
	const Difference recall = figure(comparison, "recall");
	EXPECT_DOUBLE_EQ(*recall.base, 200.0 / 300.0);
	// Of scenes 1, 51, 101 ... those not hard: 1, 101, 151, 251.
	EXPECT_NEAR(*recall.difference, -4.0 / 300.0, 1e-12);
	// Four lost scenes of 300: ± 1.96 √4 / 300; two independent runs would have ± 7.5 points.
	EXPECT_NEAR(recall.interval->high - recall.interval->low, 2 * 1.96 * 2.0 / 300.0, 0.006);
	EXPECT_LT(recall.interval->high, 0.0);
	EXPECT_FALSE(figure(comparison, "false_alarms").difference);
	ASSERT_EQ(comparison.families.size(), 1U);
	EXPECT_EQ(comparison.families[0].figures[1].difference, recall.difference);
}

TEST(CompareRuns, TheSameRunDiffersByNothing)
{
	const auto base = runOf("base", {doorLog("a.rawlog", [](int scene) { return !hard(scene); })});
	const Difference recall = figure(compareRuns(base, base), "recall");
	EXPECT_EQ(*recall.difference, 0.0);
	EXPECT_EQ(recall.interval->low, 0.0);
	EXPECT_EQ(recall.interval->high, 0.0);
}

TEST(CompareRuns, LogsOfOtherFoldersArePairedByTheirNames)
{
	const auto all = [](int) { return true; };
	auto base = runOf("base", {doorLog("kinect/a.rawlog", all), doorLog("kinect/b.rawlog", all)});
	auto other = runOf("other", {doorLog("worse/a.rawlog", hard)});
	const auto comparison = compareRuns(base, other);
	EXPECT_EQ(comparison.scenes, 300U);
	EXPECT_EQ(comparison.unpaired, 300U);
	// Where names are not enough, paths count.
	base.evaluation.logs[1].log = "speckle/a.rawlog";
	EXPECT_THROW((void)compareRuns(base, other), InputError);
	other.evaluation.logs[0].log = "speckle/a.rawlog";
	EXPECT_EQ(compareRuns(base, other).scenes, 300U);
}

TEST(CompareRuns, CalibrationIsCompared)
{
	std::mt19937_64 random(2);
	auto base = runOf("base", {doorLog("a.rawlog", hard)}), other = base;
	for (std::size_t i = 0; i < base.evaluation.logs[0].scenes.size(); ++i)
	{
		const bool right = random() % 10 < 9;
		base.evaluation.logs[0].scenes[i].tally.candidates = {{0.9, right}};
		other.evaluation.logs[0].scenes[i].tally.candidates = {{0.7, right}};
	}
	const Difference error = figure(compareRuns(base, other), "calibration_error");
	EXPECT_LT(*error.base, 0.04);
	EXPECT_NEAR(*error.other, 0.2, 0.04);
	EXPECT_GT(error.interval->low, 0.1);
}

TEST(CompareText, TellsPointsAndFamilies)
{
	const auto base = runOf("base", {doorLog("a.rawlog", [](int scene) { return !hard(scene); })});
	const auto other = runOf("no leaf", {doorLog("a.rawlog", [](int) { return false; })});
	const std::vector<RunComparison> comparisons{compareRuns(base, other)};
	const std::string text = comparisonText("base", comparisons);
	EXPECT_THAT(text, HasSubstr("base (%)"));
	EXPECT_THAT(text, HasSubstr("-66.67"));
	EXPECT_THAT(text, HasSubstr("no leaf: families that changed most"));
	EXPECT_THAT(text, HasSubstr("frontal_door"));
	const Json json = Json::parse(comparisonJson("base", comparisons));
	EXPECT_NEAR(json["runs"][0]["figures"]["recall"]["difference"].get<double>(), -2.0 / 3.0, 1e-12);
	EXPECT_EQ(json["runs"][0]["families"][0]["family"], "frontal_door");
}

TEST(CostLimits, CountTheWorseEndUnlessTheValueIsAsked)
{
	const auto base = runOf("base", {doorLog("a.rawlog", [](int) { return true; })});
	const auto other = runOf("other", {doorLog("a.rawlog", [](int scene) { return scene % 100 != 0; })});
	const std::vector<RunComparison> comparisons{compareRuns(base, other)};
	const auto exceeded = [&](const std::string& text) { return exceededLimits(parseCostLimits(text), comparisons); };
	EXPECT_TRUE(exceeded("recall.value=1").empty());
	EXPECT_THAT(exceeded("recall=1"), testing::ElementsAre(testing::HasSubstr("other: recall: -1.00 points")));
	EXPECT_TRUE(exceeded("recall=3,precision=0,false_alarms=0").empty()) << "what was not measured costs nothing";
	for (const char* wrong : {"", "recall", "recall=", "recall=-1", "recal=1", "recall=1,", "recall=nan", "=1"})
		EXPECT_THROW((void)parseCostLimits(wrong), ConfigError) << wrong;
}

#include <explore/core/errors.h>
#include <explore/evaluation/compare_runs.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace explore::evaluation
{
namespace
{
/** One scene in both runs. */
struct Pair
{
	const Tally *base, *other;
	bool negative;
};
using Pairs = std::vector<Pair>;

/** Which scenes a figure is over. */
enum class Scenes
{
	positives,
	negatives,
	all,
};

struct RatioFigure
{
	ComparedFigure figure;
	Scenes over = Scenes::all;
	SceneRatio (*of)(const Tally&) = nullptr;
};

constexpr std::array<RatioFigure, 10> kRatios{{
    {{"precision", "precision", true},
     Scenes::positives,
     [](const Tally& t) -> SceneRatio {
	     return {t.main().hits, t.main().hits + t.main().false_alarms};
     }},
    {{"recall", "recall", true},
     Scenes::positives,
     [](const Tally& t) -> SceneRatio {
	     return {t.main().hits, t.main().hits + t.main().misses};
     }},
    {{"false_alarms", "false alarms", false},
     Scenes::negatives,
     [](const Tally& t) -> SceneRatio {
	     return {t.false_alarm_frames, t.frames - t.unscored_frames};
     }},
    {{"open_alarms", "open alarms", false},
     Scenes::negatives,
     [](const Tally& t) -> SceneRatio {
	     return {t.open_frames, t.frames - t.unscored_frames};
     }},
    {{"narrow_recall", "narrow recall", true},
     Scenes::positives,
     [](const Tally& t) -> SceneRatio {
	     return {t.narrow_hits, t.narrow_hits + t.narrow_misses};
     }},
    {{"headings", "good headings", true},
     Scenes::all,
     [](const Tally& t) -> SceneRatio {
	     return {t.good_headings, t.heading_frames};
     }},
    {{"collisions", "collisions", false},
     Scenes::all,
     [](const Tally& t) -> SceneRatio {
	     return {t.collisions, t.heading_frames};
     }},
    {{"direction_given", "direction given", true},
     Scenes::all,
     [](const Tally& t) -> SceneRatio {
	     return {t.corridor_given, t.corridor_frames};
     }},
    {{"direction_close", "within 2 deg", true},
     Scenes::all,
     [](const Tally& t) -> SceneRatio {
	     return {t.corridor_close, t.corridor_given};
     }},
    {{"direction_null", "none given", true},
     Scenes::all,
     [](const Tally& t) -> SceneRatio {
	     return {t.plain_null, t.plain_frames};
     }},
}};
constexpr ComparedFigure kCalibration{"calibration_error", "calibration error", false};

/** A figure of one run in all resamples. */
using Measure = std::function<std::optional<double>(const SceneWeights&)>;

Measure ratioMeasure(const RatioFigure& figure, const Pairs& pairs, const Tally* Pair::*run)
{
	struct Part
	{
		std::size_t scene;
		double good, all;
	};
	const auto parts = std::make_shared<std::vector<Part>>();
	for (std::size_t i = 0; i < pairs.size(); ++i)
	{
		if (figure.over != Scenes::all && pairs[i].negative != (figure.over == Scenes::negatives)) continue;
		const SceneRatio ratio = figure.of(*(pairs[i].*run));
		if (ratio.all > 0) parts->push_back({i, static_cast<double>(ratio.good), static_cast<double>(ratio.all)});
	}
	return [parts](const SceneWeights& weights) -> std::optional<double>
	{
		double good = 0.0, all = 0.0;
		for (const Part& part : *parts)
		{
			good += weights[part.scene] * part.good;
			all += weights[part.scene] * part.all;
		}
		return all > 0.0 ? std::optional(good / all) : std::nullopt;
	};
}

Measure calibrationMeasure(const Pairs& pairs, const Tally* Pair::*run)
{
	const auto candidates = std::make_shared<SceneCandidates>();
	for (std::size_t i = 0; i < pairs.size(); ++i)
		for (const Candidate& candidate : (pairs[i].*run)->candidates) candidates->add(candidate, i);
	candidates->sort();
	return [candidates](const SceneWeights& weights) { return candidates->calibrationErrorOf(weights); };
}

std::optional<double> minus(const std::optional<double>& a, const std::optional<double>& b)
{
	return a && b ? std::optional(*a - *b) : std::nullopt;
}

std::vector<Difference> differencesOf(const Pairs& pairs)
{
	std::vector<std::pair<Measure, Measure>> measures;
	measures.reserve(kRatios.size() + 1);
	for (const RatioFigure& figure : kRatios)
		measures.emplace_back(ratioMeasure(figure, pairs, &Pair::base), ratioMeasure(figure, pairs, &Pair::other));
	measures.emplace_back(calibrationMeasure(pairs, &Pair::base), calibrationMeasure(pairs, &Pair::other));

	const SceneWeights once(pairs.size(), 1);
	std::vector<Difference> differences;
	std::vector<SceneStatistic> statistics;
	for (const auto& [base, other] : measures)
	{
		const auto base_value = base(once), other_value = other(once);
		differences.push_back({base_value, other_value, minus(other_value, base_value), std::nullopt});
		if (base_value && other_value)
			statistics.emplace_back([&base = base, &other = other](const SceneWeights& weights)
			                        { return minus(other(weights), base(weights)); });
	}
	const auto intervals = bootstrapIntervals(statistics.empty() ? 0 : pairs.size(), statistics);
	std::size_t next = 0;
	for (Difference& difference : differences)
		if (difference.difference) difference.interval = intervals[next++];
	return differences;
}

std::string fileName(const LogScore& log)
{
	return std::filesystem::path(log.log).filename().string();
}

bool toldByFileName(const Evaluation& run)
{
	std::set<std::string> names;
	return std::ranges::all_of(run.logs, [&](const LogScore& log) { return names.insert(fileName(log)).second; });
}

using SceneKey = std::pair<std::string, int>;
struct PlacedScene
{
	const LogScore* log;
	const Tally* tally;
};
std::map<SceneKey, PlacedScene> scenesOf(const Evaluation& run, bool by_file_name)
{
	std::map<SceneKey, PlacedScene> scenes;
	for (const LogScore& log : run.logs)
		if (log.has_truth && !scoredByTracks(log))
			for (const SceneScore& scene : log.scenes)
				scenes[{by_file_name ? fileName(log) : log.log, scene.scene}] = {&log, &scene.tally};
	return scenes;
}
}  // namespace

std::vector<ComparedFigure> comparedFigures()
{
	std::vector<ComparedFigure> figures;
	figures.reserve(kRatios.size() + 1);
	for (const RatioFigure& ratio : kRatios) figures.push_back(ratio.figure);
	figures.push_back(kCalibration);
	return figures;
}

RunComparison compareRuns(const NamedRun& base, const NamedRun& other)
{
	const bool by_file_name = toldByFileName(base.evaluation) && toldByFileName(other.evaluation);
	const auto ours = scenesOf(base.evaluation, by_file_name), theirs = scenesOf(other.evaluation, by_file_name);
	Pairs pairs;
	std::map<std::array<std::string, 3>, Pairs> families;
	for (const auto& [key, scene] : ours)
	{
		const auto found = theirs.find(key);
		if (found == theirs.end()) continue;
		const LogScore& log = *scene.log;
		const Pair pair{scene.tally, found->second.tally, log.negative};
		pairs.push_back(pair);
		families[{log.family.empty() ? log.world : log.family, log.platform, log.noise}].push_back(pair);
	}
	if (pairs.empty()) throw InputError(other.name + ": no scene of its logs is also in " + base.name);
	RunComparison comparison{
	    other.name, pairs.size(), ours.size() + theirs.size() - 2 * pairs.size(), differencesOf(pairs), {}};
	for (const auto& [key, scenes] : families)
		comparison.families.push_back({key[0], key[1], key[2], differencesOf(scenes)});
	return comparison;
}
}  // namespace explore::evaluation

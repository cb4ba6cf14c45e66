#include <explore/evaluation/figures.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace explore::evaluation
{
namespace
{
constexpr std::size_t kCurvePoints = 101;

using Scenes = std::span<const SceneScore* const>;

/** The rate of what `ratio(tally)` counts. */
template <class Ratio>
std::optional<Rate> rate(Scenes scenes, const Ratio& ratio)
{
	std::vector<SceneRatio> ratios;
	ratios.reserve(scenes.size());
	for (const SceneScore* scene : scenes) ratios.push_back(ratio(scene->tally));
	return rateOf(ratios);
}

/** The rate of one count among another one. */
std::optional<Rate> share(Scenes scenes, Count Tally::*good, Count Tally::*all)
{
	return rate(scenes, [&](const Tally& tally) -> SceneRatio { return {tally.*good, tally.*all}; });
}

/** The rate of such frames among those that are scored. */
std::optional<Rate> frameShare(Scenes scenes, Count Tally::*good)
{
	return rate(scenes,
	            [&](const Tally& tally) -> SceneRatio {
		            return {tally.*good, tally.frames - tally.unscored_frames};
	            });
}

DoorFigures doorFigures(Scenes scenes, const Tally& sum, std::size_t tolerance)
{
	DoorFigures figures;
	figures.counts = sum.doors[tolerance];
	figures.precision = rate(scenes,
	                         [&](const Tally& tally) -> SceneRatio
	                         {
		                         const DoorCounts& doors = tally.doors[tolerance];
		                         return {doors.hits, doors.hits + doors.false_alarms};
	                         });
	figures.recall = rate(scenes,
	                      [&](const Tally& tally) -> SceneRatio
	                      {
		                      const DoorCounts& doors = tally.doors[tolerance];
		                      return {doors.hits, doors.hits + doors.misses};
	                      });
	return figures;
}

/** Figures whose intervals need resampling: all of a group at once, from the same resamples. */
class Resampled
{
public:
	explicit Resampled(Scenes scenes) : m_scenes(scenes) {}

	/** `figures` outlive the object; with `near`, the hits up to kNearDoor_m alone. */
	void addErrors(std::vector<double> Tally::*list, bool near, ErrorFigures& figures);
	void addConfidences(ConfidenceFigures& figures);
	void findIntervals();

private:
	Scenes m_scenes;
	std::vector<SceneStatistic> m_statistics;
	std::vector<std::optional<Interval>*> m_intervals;
};

void Resampled::addErrors(std::vector<double> Tally::*list, bool near, ErrorFigures& figures)
{
	const auto sizes = std::make_shared<SceneValues>();
	std::vector<double> errors, absolute;
	for (std::size_t scene = 0; scene < m_scenes.size(); ++scene)
	{
		const Tally& tally = m_scenes[scene]->tally;
		for (std::size_t i = 0; i < (tally.*list).size(); ++i)
		{
			if (near && tally.hit_distances_m[i] > kNearDoor_m) continue;
			const double error = (tally.*list)[i];
			errors.push_back(error);
			absolute.push_back(std::abs(error));
			sizes->add(std::abs(error), scene);
		}
	}
	figures = {errors.size(), quantile(errors, 0.5), quantile(absolute, 0.5), quantile(absolute, 0.99), {}};
	if (errors.empty()) return;
	sizes->sort();
	m_statistics.emplace_back([sizes](const SceneWeights& weights) { return sizes->quantile(weights, 0.5); });
	m_intervals.push_back(&figures.interval);
}

void Resampled::addConfidences(ConfidenceFigures& figures)
{
	const auto candidates = std::make_shared<SceneCandidates>();
	for (std::size_t scene = 0; scene < m_scenes.size(); ++scene)
		for (const Candidate& candidate : m_scenes[scene]->tally.candidates) candidates->add(candidate, scene);
	if (candidates->empty()) return;
	candidates->sort();
	m_statistics.emplace_back([candidates](const SceneWeights& weights)
	                          { return candidates->calibrationErrorOf(weights); });
	m_intervals.push_back(&figures.calibration_interval);
	m_statistics.emplace_back([candidates](const SceneWeights& weights) { return candidates->aurocOf(weights); });
	m_intervals.push_back(&figures.auroc_interval);
}

void Resampled::findIntervals()
{
	if (m_statistics.empty()) return;
	const auto intervals = bootstrapIntervals(m_scenes.size(), m_statistics);
	for (std::size_t i = 0; i < intervals.size(); ++i) *m_intervals[i] = intervals[i];
}

void findErrors(Resampled& resampled, Figures& figures)
{
	for (const bool near : {false, true})
	{
		HitFigures& hits = near ? figures.near_hits : figures.hits;
		resampled.addErrors(&Tally::width_errors_m, near, hits.width_m);
		resampled.addErrors(&Tally::center_errors_m, near, hits.center_m);
		resampled.addErrors(&Tally::along_errors_m, near, hits.along_m);
		resampled.addErrors(&Tally::across_errors_m, near, hits.across_m);
	}
	resampled.addErrors(&Tally::direction_errors_rad, false, figures.direction_rad);
}

void findConfidences(const Tally& sum, const DoorFigures& doors, ConfidenceFigures& figures)
{
	figures.candidates = sum.candidates.size();
	const Count positives = doors.counts.hits + doors.counts.misses;
	if (!sum.candidates.empty())
	{
		const auto candidates = byConfidence(sum.candidates);
		figures.calibration_error = calibrationError(candidates);
		figures.auroc = auroc(candidates);
		figures.bins = reliability(candidates);
		figures.curve = precisionRecall(sum.candidates, positives, kCurvePoints);
	}
	else if (doors.precision && doors.recall)
		figures.curve = {{0.0, doors.precision->value, doors.recall->value}};
}

void findRates(Scenes scenes, Figures& figures)
{
	for (std::size_t i = 0; i < figures.doors.size(); ++i) figures.doors[i] = doorFigures(scenes, figures.sum, i);
	figures.narrow_recall = rate(scenes,
	                             [](const Tally& tally) -> SceneRatio {
		                             return {tally.narrow_hits, tally.narrow_hits + tally.narrow_misses};
	                             });
	figures.false_alarm_frames = frameShare(scenes, &Tally::false_alarm_frames);
	figures.report_frames = frameShare(scenes, &Tally::report_frames);
	figures.open_frames = frameShare(scenes, &Tally::open_frames);
	figures.direction_given = share(scenes, &Tally::corridor_given, &Tally::corridor_frames);
	figures.direction_close = share(scenes, &Tally::corridor_close, &Tally::corridor_given);
	figures.direction_null = share(scenes, &Tally::plain_null, &Tally::plain_frames);
	figures.good_headings = share(scenes, &Tally::good_headings, &Tally::heading_frames);
	figures.collisions = share(scenes, &Tally::collisions, &Tally::heading_frames);
}
}  // namespace

Figures figuresOf(Scenes scenes)
{
	Figures figures;
	figures.scenes = scenes.size();
	Tally& sum = figures.sum;
	for (const SceneScore* scene : scenes) sum.add(scene->tally);
	findRates(scenes, figures);
	Resampled resampled(scenes);
	findErrors(resampled, figures);
	resampled.addConfidences(figures.confidence);
	resampled.findIntervals();
	findConfidences(sum, figures.main(), figures.confidence);
	sum.width_errors_m = sum.center_errors_m = sum.along_errors_m = sum.across_errors_m = sum.hit_distances_m =
	    sum.direction_errors_rad = {};
	sum.candidates = {};
	return figures;
}
}  // namespace explore::evaluation

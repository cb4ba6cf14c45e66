#include <explore/evaluation/figures.h>

#include <algorithm>
#include <cmath>

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

ErrorFigures errorFigures(const std::vector<double>& errors)
{
	std::vector<double> sizes;
	sizes.reserve(errors.size());
	for (const double error : errors) sizes.push_back(std::abs(error));
	return {errors.size(), quantile(errors, 0.5), quantile(sizes, 0.5), quantile(sizes, 0.99)};
}

ConfidenceFigures confidenceFigures(const Tally& sum, const DoorFigures& doors)
{
	ConfidenceFigures figures;
	figures.candidates = sum.candidates.size();
	const Count positives = doors.counts.hits + doors.counts.misses;
	if (!sum.candidates.empty())
	{
		figures.calibration_error = calibrationError(sum.candidates);
		figures.auroc = auroc(sum.candidates);
		figures.curve = precisionRecall(sum.candidates, positives, kCurvePoints);
	}
	else if (doors.precision && doors.recall)
		figures.curve = {{0.0, doors.precision->value, doors.recall->value}};
	return figures;
}
}  // namespace

Figures figuresOf(Scenes scenes)
{
	Figures figures;
	figures.scenes = scenes.size();
	Tally& sum = figures.sum;
	for (const SceneScore* scene : scenes) sum.add(scene->tally);
	for (std::size_t i = 0; i < figures.doors.size(); ++i) figures.doors[i] = doorFigures(scenes, sum, i);
	figures.false_alarm_frames = rate(scenes,
	                                  [](const Tally& t) -> SceneRatio {
		                                  return {t.false_alarm_frames, t.frames};
	                                  });
	figures.report_frames = rate(scenes, [](const Tally& t) -> SceneRatio { return {t.report_frames, t.frames}; });
	figures.width_m = errorFigures(sum.width_errors_m);
	figures.center_m = errorFigures(sum.center_errors_m);
	figures.direction_rad = errorFigures(sum.direction_errors_rad);
	figures.direction_given = rate(scenes,
	                               [](const Tally& t) -> SceneRatio {
		                               return {t.corridor_given, t.corridor_frames};
	                               });
	figures.direction_null = rate(scenes, [](const Tally& t) -> SceneRatio { return {t.plain_null, t.plain_frames}; });
	figures.good_headings = rate(scenes,
	                             [](const Tally& t) -> SceneRatio {
		                             return {t.good_headings, t.heading_frames};
	                             });
	figures.collisions = rate(scenes, [](const Tally& t) -> SceneRatio { return {t.collisions, t.heading_frames}; });
	figures.confidence = confidenceFigures(sum, figures.main());
	sum.width_errors_m = sum.center_errors_m = sum.direction_errors_rad = {};
	sum.candidates = {};
	return figures;
}
}  // namespace explore::evaluation

#include <explore/evaluation/results_text.h>

namespace explore::evaluation
{
namespace
{
Json rateJson(const std::optional<Rate>& rate)
{
	if (!rate) return {};
	return {{"value", jsonNumber(rate->value)},
	        {"low", jsonNumber(rate->low)},
	        {"high", jsonNumber(rate->high)},
	        {"good", rate->good},
	        {"all", rate->all}};
}

Json doorsJson(const Figures& figures)
{
	Json result = Json::array();
	for (std::size_t i = 0; i < figures.doors.size(); ++i)
	{
		const DoorFigures& doors = figures.doors[i];
		result.push_back({{"center_tolerance", kCenterTolerances_m[i]},
		                  {"hits", doors.counts.hits},
		                  {"false_alarms", doors.counts.false_alarms},
		                  {"misses", doors.counts.misses},
		                  {"precision", rateJson(doors.precision)},
		                  {"recall", rateJson(doors.recall)}});
	}
	return result;
}

Json intervalJson(const std::optional<Interval>& interval)
{
	if (!interval) return {};
	return {jsonNumber(interval->low), jsonNumber(interval->high)};
}

Json errorsJson(const ErrorFigures& errors)
{
	return {{"count", errors.count},
	        {"bias", jsonOrNull(errors.bias)},
	        {"median", jsonOrNull(errors.median)},
	        {"median_interval", intervalJson(errors.interval)},
	        {"p99", jsonOrNull(errors.p99)}};
}

Json hitsJson(const HitFigures& hits)
{
	return {{"width_error", errorsJson(hits.width_m)},
	        {"center_error", errorsJson(hits.center_m)},
	        {"along_error", errorsJson(hits.along_m)},
	        {"across_error", errorsJson(hits.across_m)}};
}

Json binsJson(const std::vector<ReliabilityBin>& bins)
{
	Json result = Json::array();
	for (const ReliabilityBin& bin : bins)
		result.push_back({{"lowest", jsonNumber(bin.lowest)},
		                  {"highest", jsonNumber(bin.highest)},
		                  {"count", bin.count},
		                  {"confidence", jsonNumber(bin.confidence)},
		                  {"right", jsonNumber(bin.right)}});
	return result;
}

Json confidenceJson(const ConfidenceFigures& confidence)
{
	Json curve = Json::array();
	for (const CurvePoint& point : confidence.curve)
		curve.push_back({jsonNumber(point.threshold), jsonNumber(point.precision), jsonNumber(point.recall)});
	return {{"candidates", confidence.candidates},
	        {"calibration_error", jsonOrNull(confidence.calibration_error)},
	        {"calibration_interval", intervalJson(confidence.calibration_interval)},
	        {"auroc", jsonOrNull(confidence.auroc)},
	        {"auroc_interval", intervalJson(confidence.auroc_interval)},
	        {"bins", binsJson(confidence.bins)},
	        {"curve", curve}};
}

Json causesJson(const std::map<std::string, Count>& causes)
{
	Json result = Json::object();
	for (const auto& [cause, count] : causes) result[cause] = count;
	return result;
}

Json confusionJson(const Confusion& confusion)
{
	Json result = Json::object();
	for (std::size_t i = 0; i < confusion.size(); ++i)
		for (std::size_t j = 0; j < confusion.size(); ++j)
			if (confusion[i][j] > 0) result[std::string(verdictName(i))][std::string(verdictName(j))] = confusion[i][j];
	return result;
}

Json figuresJson(const Figures& figures)
{
	return {{"scenes", figures.scenes},
	        {"frames", figures.sum.frames},
	        {"unscored_frames", figures.sum.unscored_frames},
	        {"doors", doorsJson(figures)},
	        {"narrow_recall", rateJson(figures.narrow_recall)},
	        {"false_alarm_frames", rateJson(figures.false_alarm_frames)},
	        {"report_frames", rateJson(figures.report_frames)},
	        {"open_frames", rateJson(figures.open_frames)},
	        {"open_reports", figures.sum.open_reports},
	        {"width_error", errorsJson(figures.hits.width_m)},
	        {"center_error", errorsJson(figures.hits.center_m)},
	        {"along_error", errorsJson(figures.hits.along_m)},
	        {"across_error", errorsJson(figures.hits.across_m)},
	        {"near", hitsJson(figures.near_hits)},
	        {"direction_error", errorsJson(figures.direction_rad)},
	        {"direction_given", rateJson(figures.direction_given)},
	        {"direction_close", rateJson(figures.direction_close)},
	        {"direction_null", rateJson(figures.direction_null)},
	        {"good_headings", rateJson(figures.good_headings)},
	        {"stops", figures.sum.stops},
	        {"good_stops", figures.sum.good_stops},
	        {"collisions", rateJson(figures.collisions)},
	        {"confidence", confidenceJson(figures.confidence)},
	        {"false_alarm_causes", causesJson(figures.sum.false_alarm_causes)},
	        {"miss_causes", causesJson(figures.sum.miss_causes)},
	        {"confusion", confusionJson(figures.sum.confusion)}};
}

Json groupsJson(const std::vector<Group>& groups)
{
	Json result = Json::array();
	for (const Group& group : groups)
		result.push_back({{"name", group.name},
		                  {"platform", group.platform},
		                  {"noise", group.noise},
		                  {"negative", group.negative},
		                  {"by_tracks", group.by_tracks},
		                  {"figures", figuresJson(group.figures)}});
	return result;
}

Json figuresOrNull(const std::optional<Figures>& figures)
{
	return figures ? figuresJson(*figures) : Json();
}
}  // namespace

Json resultsJson(const Results& results)
{
	return {{"configurations", groupsJson(results.configurations)},
	        {"families", groupsJson(results.families)},
	        {"pooled", groupsJson(results.pooled)},
	        {"overall", groupsJson(results.overall)},
	        {"corner_doors", groupsJson(results.corners)},
	        {"hazards", groupsJson(results.hazards)},
	        {"positives", figuresOrNull(results.positives)},
	        {"negatives", figuresOrNull(results.negatives)},
	        {"everything", figuresOrNull(results.everything)}};
}
}  // namespace explore::evaluation

#include <explore/evaluation/results_text.h>
#include <explore/evaluation/text_table.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <functional>
#include <numbers>

namespace explore::evaluation
{
namespace
{
constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string percent(const std::optional<Rate>& rate)
{
	return rate ? mrpt::format("%.1f", 100.0 * rate->value) : "-";
}

std::string interval(const std::optional<Rate>& rate)
{
	return rate ? mrpt::format("%.1f-%.1f", 100.0 * rate->low, 100.0 * rate->high) : "-";
}

std::string scaled(const std::optional<double>& value, double factor, const char* format)
{
	return value ? mrpt::format(format, *value * factor) : "-";
}

std::string number(Count value)
{
	return std::to_string(value);
}

using Cells = std::function<std::vector<std::string>(const Figures&)>;

/** A table with one line a group for which `cells` gives any. */
std::string section(const std::string& title, const std::vector<std::string>& columns, const std::vector<Group>& groups,
                    const Cells& cells)
{
	std::vector<std::string> titles{"<", "<robot", "<noise"};
	titles.insert(titles.end(), columns.begin(), columns.end());
	TextTable table(titles);
	for (const Group& group : groups)
	{
		const auto figures = cells(group.figures);
		if (figures.empty()) continue;
		std::vector<std::string> row{group.name, group.platform, group.noise};
		row.insert(row.end(), figures.begin(), figures.end());
		table.row(row);
	}
	return table.empty() ? "" : title + "\n" + table.text() + "\n";
}

const std::vector<std::string> kDoorColumns{"scenes", "doors", "precision %", "95 %",  "recall %",
                                            "95 %",   "hits",  "false",       "twice", "missed"};

std::vector<std::string> doorCells(const Figures& figures)
{
	const DoorFigures& doors = figures.main();
	const DoorCounts& counts = doors.counts;
	const auto& causes = figures.sum.false_alarm_causes;
	const auto twice = causes.find(std::string(nameOf(Cause::association)));
	return {number(figures.scenes),
	        number(counts.hits + counts.misses),
	        percent(doors.precision),
	        interval(doors.precision),
	        percent(doors.recall),
	        interval(doors.recall),
	        number(counts.hits),
	        number(counts.false_alarms),
	        number(twice == causes.end() ? 0 : twice->second),
	        number(counts.misses)};
}

const std::vector<std::string> kAlarmColumns{"scenes", "frames", "false alarms %", "95 %", "reports %", "95 %"};

std::vector<std::string> alarmCells(const Figures& figures)
{
	return {number(figures.scenes),
	        number(figures.sum.frames),
	        percent(figures.false_alarm_frames),
	        interval(figures.false_alarm_frames),
	        percent(figures.report_frames),
	        interval(figures.report_frames)};
}

std::vector<std::string> toleranceCells(const Figures& figures)
{
	std::vector<std::string> cells;
	for (const DoorFigures& doors : figures.doors)
	{
		cells.push_back(percent(doors.precision));
		cells.push_back(percent(doors.recall));
	}
	return cells;
}

std::vector<std::string> errorCells(const Figures& figures)
{
	if (figures.width_m.count == 0) return {};
	return {number(figures.width_m.count),
	        scaled(figures.width_m.bias, 100, "%+.1f"),
	        scaled(figures.width_m.median, 100, "%.1f"),
	        scaled(figures.width_m.p99, 100, "%.1f"),
	        scaled(figures.center_m.median, 100, "%.1f"),
	        scaled(figures.center_m.p99, 100, "%.1f")};
}

std::vector<std::string> directionCells(const Figures& figures)
{
	if (!figures.direction_given && !figures.direction_null) return {};
	return {number(figures.sum.corridor_frames),
	        percent(figures.direction_given),
	        scaled(figures.direction_rad.median, kDegrees, "%.1f"),
	        scaled(figures.direction_rad.p99, kDegrees, "%.1f"),
	        number(figures.sum.plain_frames),
	        percent(figures.direction_null),
	        interval(figures.direction_null)};
}

std::vector<std::string> headingCells(const Figures& figures)
{
	if (!figures.good_headings) return {};
	return {number(figures.sum.heading_frames), percent(figures.good_headings), interval(figures.good_headings),
	        number(figures.sum.stops),          number(figures.sum.good_stops), number(figures.sum.collisions),
	        interval(figures.collisions)};
}

std::vector<std::string> confidenceCells(const Figures& figures)
{
	const ConfidenceFigures& confidence = figures.confidence;
	if (confidence.candidates == 0) return {};
	return {number(confidence.candidates), scaled(confidence.calibration_error, 1, "%.4f"),
	        scaled(confidence.auroc, 1, "%.4f")};
}

std::string causeText(const Tally& sum)
{
	TextTable table({"<cause", "false alarms", "misses"});
	std::map<std::string, std::pair<Count, Count>> causes;
	for (const auto& [cause, count] : sum.false_alarm_causes) causes[cause].first = count;
	for (const auto& [cause, count] : sum.miss_causes) causes[cause].second = count;
	for (const auto& [cause, counts] : causes) table.row({cause, number(counts.first), number(counts.second)});
	return table.empty() ? "" : "Causes (all logs)\n" + table.text() + "\n";
}

std::string confusionText(const Confusion& confusion)
{
	std::vector<std::string> titles{"<true \\ reported"};
	for (std::size_t j = 0; j <= kVerdicts; ++j) titles.emplace_back(verdictName(j));
	TextTable table(titles);
	for (std::size_t i = 0; i <= kVerdicts; ++i)
	{
		if (std::ranges::all_of(confusion[i], [](Count count) { return count == 0; })) continue;
		std::vector<std::string> row{std::string(verdictName(i))};
		for (const Count count : confusion[i]) row.push_back(count == 0 ? "." : number(count));
		table.row(row);
	}
	return table.empty() ? "" : "Verdicts of visible doors (all logs)\n" + table.text() + "\n";
}

std::string withoutTruthText(const Results& results)
{
	TextTable table({"<log", "frames", "with a report", "reports", "positive"});
	for (const LogScore* log : results.without_truth)
		table.row({log->log, number(log->reports.frames), number(log->reports.report_frames),
		           number(log->reports.reports), number(log->reports.positives)});
	return table.empty() ? "" : "Logs without truth: reports alone\n" + table.text() + "\n";
}

std::string problemsText(const std::vector<LogScore>& logs)
{
	std::string text;
	for (const LogScore& log : logs)
	{
		const auto line = [&](const std::string& what)
		{ text.append("  ").append(log.log).append(": ").append(what).append("\n"); };
		if (!log.error.empty()) line("not scored: " + log.error);
		if (!log.damage.empty()) line("scored up to the damage: " + log.damage);
		for (const std::string& remark : log.remarks) line(remark);
	}
	return text.empty() ? "" : "Remarks\n" + text + "\n";
}
}  // namespace

std::string resultsText(const std::vector<LogScore>& logs, const Results& results)
{
	std::vector<Group> positives, negatives;
	for (const auto* list : {&results.families, &results.pooled})
		for (const Group& group : *list) (group.negative ? negatives : positives).push_back(group);
	std::vector<Group> all = positives;
	all.insert(all.end(), negatives.begin(), negatives.end());

	std::string text;
	text += section("Open doors, as in the paper's Fig. 3(b): centre within 0.30 m, width within 0.25 m", kDoorColumns,
	                results.configurations, doorCells);
	text += section("Families with doors", kDoorColumns, positives, doorCells);
	text += section("Families without doors that the robot could pass", kAlarmColumns, negatives, alarmCells);
	text +=
	    section("Precision and recall (%) by the tolerance of the centre",
	            {"P 0.15 m", "R 0.15 m", "P 0.30 m", "R 0.30 m", "P 0.45 m", "R 0.45 m"}, positives, toleranceCells);
	text += section("Errors of the hits (cm): bias is the median, others of the size",
	                {"hits", "width bias", "median", "99 %", "centre median", "99 %"}, positives, errorCells);
	text += section("Corridor direction",
	                {"corridors", "given %", "median deg", "99 % deg", "no corridor", "none given %", "95 %"}, all,
	                directionCells);
	text += section("Headings", {"frames", "good %", "95 %", "stops", "good stops", "collisions", "95 %"}, all,
	                headingCells);
	text += section("Confidences", {"candidates", "calibration error", "AUROC"}, all, confidenceCells);
	if (results.everything && results.everything->confidence.candidates == 0)
		text += "Confidences: the method gives none; its precision over recall is the one point above\n\n";
	if (results.everything)
		text += causeText(results.everything->sum) + confusionText(results.everything->sum.confusion);
	text += withoutTruthText(results) + problemsText(logs);
	if (!text.empty()) text.pop_back();  // the empty line after the last table
	return text;
}
}  // namespace explore::evaluation

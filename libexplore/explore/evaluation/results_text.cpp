#include <explore/evaluation/group_tables.h>
#include <explore/evaluation/results_text.h>
#include <explore/evaluation/text_table.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <utility>

namespace explore::evaluation
{
namespace
{
std::string causeText(const Tally& sum)
{
	TextTable table({"<cause", "false alarms", "misses"});
	std::map<std::string, std::pair<Count, Count>> causes;
	for (const auto& [cause, count] : sum.false_alarm_causes) causes[cause].first = count;
	for (const auto& [cause, count] : sum.miss_causes) causes[cause].second = count;
	for (const auto& [cause, counts] : causes)
		table.row({cause, std::to_string(counts.first), std::to_string(counts.second)});
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
		for (const Count count : confusion[i]) row.push_back(count == 0 ? "." : std::to_string(count));
		table.row(row);
	}
	return table.empty() ? "" : "Verdicts of visible doors (all logs)\n" + table.text() + "\n";
}

std::string reliabilityText(const std::vector<ReliabilityBin>& bins)
{
	TextTable table({"confidence", "mean", "right", "difference", "candidates"});
	for (const ReliabilityBin& bin : bins)
		table.row({mrpt::format("%.3f-%.3f", bin.lowest, bin.highest), mrpt::format("%.3f", bin.confidence),
		           mrpt::format("%.3f", bin.right), mrpt::format("%+.3f", bin.right - bin.confidence),
		           std::to_string(bin.count)});
	return table.empty()
	           ? ""
	           : "Reliability: share of right candidates by confidence (all families)\n" + table.text() + "\n";
}

std::string withoutTruthText(const Results& results)
{
	TextTable table({"<log", "frames", "with a report", "reports", "positive"});
	for (const LogScore* log : results.without_truth)
		table.row({log->log, std::to_string(log->reports.frames), std::to_string(log->reports.report_frames),
		           std::to_string(log->reports.reports), std::to_string(log->reports.positives)});
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
	std::vector<Group> positives, negatives, mirrors, all;
	for (const auto* list : {&results.families, &results.pooled})
		for (const Group& group : *list)
			(group.by_tracks ? mirrors : group.negative ? negatives : positives).push_back(group);
	for (const auto* list : {&std::as_const(positives), &std::as_const(negatives), &results.overall})
		all.insert(all.end(), list->begin(), list->end());
	negatives.insert(negatives.end(), results.hazards.begin(), results.hazards.end());
	std::vector<Group> with_overall = positives;
	with_overall.insert(with_overall.end(), results.overall.begin(), results.overall.end());

	std::string text;
	text +=
	    groupTable(TableOf::doors, "Open doors, as in the paper's Fig. 3(b): centre within 0.30 m, width within 0.25 m",
	               results.configurations);
	text += groupTable(TableOf::doors,
	                   "Families with doors; all families: with the false alarms of those without doors", with_overall);
	text += groupTable(TableOf::narrow_doors, "Doors narrower than 0.85 m", positives);
	text += groupTable(TableOf::recalls, "Corner doors", results.corners);
	text += groupTable(TableOf::false_alarms,
	                   "Families without doors that the robot could pass; open: reports with that verdict, hazards: "
	                   "glass, black, closed doors, stairs, windows",
	                   negatives);
	text += groupTable(TableOf::false_alarms,
	                   "Mirrors, which are scored by their tracks: their frames are in no other table", mirrors);
	text += groupTable(TableOf::tolerances, "Precision and recall (%) by the tolerance of the centre", positives);
	text += groupTable(TableOf::hit_errors,
	                   "Errors of the hits (cm): bias is the median, others of the size; the "
	                   "centre's along the wall and across it",
	                   positives);
	text += groupTable(TableOf::near_hit_errors, "The same for doors within 3 m", positives);
	text += groupTable(TableOf::directions, "Corridor direction", all);
	text += groupTable(TableOf::headings, "Headings", all);
	text += groupTable(TableOf::confidences, "Confidences", all);
	if (results.everything)
	{
		const ConfidenceFigures& confidence = results.everything->confidence;
		text += reliabilityText(confidence.bins);
		if (confidence.candidates == 0)
			text += "Confidences: the method gives none; its precision over recall is the one point above\n\n";
		text += causeText(results.everything->sum) + confusionText(results.everything->sum.confusion);
	}
	text += withoutTruthText(results) + problemsText(logs);
	if (!text.empty()) text.pop_back();  // the empty line after the last table
	return text;
}
}  // namespace explore::evaluation

// report.html: a run as one page that needs no other file.
#pragma once

#include <explore/sinks/report/plan_record.h>
#include <explore/sinks/report/report_log.h>
#include <explore/sinks/stage_clock.h>
#include <explore/sinks/summary.h>

#include <string>

namespace explore
{
struct ReportSizes
{
	std::size_t page_bytes = 15'000'000;  ///< at most
	std::size_t most_poses = 6000, most_goals = 2000;
	std::size_t camera_stride = 1, plan_stride = 1;  ///< frames whose numbers these divide are shown
};

/** What the page is made of besides the log. */
struct ReportEnd
{
	const RunSummary& summary;
	const TimingRecord& timing;
	const PlanSnapshot* last_plan = nullptr;  ///< after the last frame; null: there is no map
	PlanTime last;                            ///< the last frame
};

/** The page. Where it would be too large, cameras, then plans, are shown half as often, and again. What the clock told
 *  is in its `noscript`, `#summary` and `#timing` elements alone; all else is the same for the same run. Throws
 * OutputError where the log is not what was written. */
std::string reportPage(const ReportLog& log, const ReportSizes& sizes, const ReportEnd& end);

/** Of at most 300 stretches of equally many frames, by stage: median and largest time [ms]. {"frames": of a stretch,
 *  "stages": {name: {"median": [..], "max": [..]}}} */
Json timingCurve(const TimingRecord& timing);
}  // namespace explore

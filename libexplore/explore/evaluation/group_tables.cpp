#include <explore/evaluation/causes.h>
#include <explore/evaluation/group_tables.h>
#include <explore/evaluation/text_table.h>
#include <mrpt/core/format.h>

#include <numbers>

namespace explore::evaluation
{
namespace
{
constexpr double kDegrees = 180.0 / std::numbers::pi;

using Cells = std::vector<std::string>;

std::string percent(const std::optional<Rate>& rate)
{
	return rate ? mrpt::format("%.1f", 100.0 * rate->value) : "-";
}

std::string interval(const std::optional<Rate>& rate)
{
	return rate ? mrpt::format("%.1f-%.1f", 100.0 * rate->low, 100.0 * rate->high) : "-";
}

std::string interval(const std::optional<Interval>& interval, const char* format)
{
	return interval ? mrpt::format(format, interval->low) + "-" + mrpt::format(format, interval->high) : "-";
}

std::string scaled(const std::optional<double>& value, double factor, const char* format)
{
	return value ? mrpt::format(format, *value * factor) : "-";
}

Cells doorCells(const Figures& figures)
{
	const DoorFigures& doors = figures.main();
	const DoorCounts& counts = doors.counts;
	const auto& causes = figures.sum.false_alarm_causes;
	const auto twice = causes.find(std::string(nameOf(Cause::association)));
	return {std::to_string(figures.scenes),
	        std::to_string(counts.hits + counts.misses),
	        percent(doors.precision),
	        interval(doors.precision),
	        percent(doors.recall),
	        interval(doors.recall),
	        std::to_string(counts.hits),
	        std::to_string(counts.false_alarms),
	        std::to_string(twice == causes.end() ? 0 : twice->second),
	        std::to_string(counts.misses)};
}

Cells recallCells(const std::optional<Rate>& recall)
{
	if (!recall) return {};
	return {std::to_string(recall->all), percent(recall), interval(recall), std::to_string(recall->good),
	        std::to_string(recall->all - recall->good)};
}

Cells mainRecallCells(const Figures& figures)
{
	return recallCells(figures.main().recall);
}

Cells narrowCells(const Figures& figures)
{
	return recallCells(figures.narrow_recall);
}

Cells alarmCells(const Figures& figures)
{
	return {std::to_string(figures.scenes),
	        std::to_string(figures.sum.frames - figures.sum.unscored_frames),
	        percent(figures.false_alarm_frames),
	        interval(figures.false_alarm_frames),
	        std::to_string(figures.sum.open_reports),
	        percent(figures.open_frames),
	        interval(figures.open_frames),
	        percent(figures.report_frames),
	        interval(figures.report_frames)};
}

Cells toleranceCells(const Figures& figures)
{
	Cells cells;
	for (const DoorFigures& doors : figures.doors)
	{
		cells.push_back(percent(doors.precision));
		cells.push_back(percent(doors.recall));
	}
	return cells;
}

/** Bias, median and 99 % in centimetres. */
void addErrors(const ErrorFigures& errors, bool biased, Cells& cells)
{
	if (biased) cells.push_back(scaled(errors.bias, 100, "%+.1f"));
	cells.push_back(scaled(errors.median, 100, "%.1f"));
	cells.push_back(scaled(errors.p99, 100, "%.1f"));
}

Cells hitCells(const HitFigures& hits)
{
	if (hits.width_m.count == 0) return {};
	Cells cells{std::to_string(hits.width_m.count)};
	addErrors(hits.width_m, true, cells);
	addErrors(hits.center_m, false, cells);
	addErrors(hits.along_m, true, cells);
	addErrors(hits.across_m, true, cells);
	return cells;
}

Cells allHitCells(const Figures& figures)
{
	return hitCells(figures.hits);
}

Cells nearHitCells(const Figures& figures)
{
	return hitCells(figures.near_hits);
}

Cells directionCells(const Figures& figures)
{
	if (!figures.direction_given && !figures.direction_null) return {};
	return {std::to_string(figures.sum.corridor_frames),
	        percent(figures.direction_given),
	        interval(figures.direction_given),
	        scaled(figures.direction_rad.median, kDegrees, "%.1f"),
	        scaled(figures.direction_rad.p99, kDegrees, "%.1f"),
	        percent(figures.direction_close),
	        interval(figures.direction_close),
	        std::to_string(figures.sum.plain_frames),
	        percent(figures.direction_null),
	        interval(figures.direction_null)};
}

Cells headingCells(const Figures& figures)
{
	if (!figures.good_headings) return {};
	return {std::to_string(figures.sum.heading_frames),
	        percent(figures.good_headings),
	        interval(figures.good_headings),
	        std::to_string(figures.sum.stops),
	        std::to_string(figures.sum.good_stops),
	        std::to_string(figures.sum.collisions),
	        interval(figures.collisions)};
}

Cells confidenceCells(const Figures& figures)
{
	const ConfidenceFigures& confidence = figures.confidence;
	if (confidence.candidates == 0) return {};
	return {std::to_string(confidence.candidates), scaled(confidence.calibration_error, 1, "%.4f"),
	        interval(confidence.calibration_interval, "%.3f"), scaled(confidence.auroc, 1, "%.4f"),
	        interval(confidence.auroc_interval, "%.3f")};
}

struct TableShape
{
	Cells columns;
	Cells (*cells)(const Figures&);
};

TableShape shapeOf(TableOf what)
{
	static const Cells kErrors{"hits",       "width bias", "median", "99 %",        "centre median", "99 %",
	                           "along bias", "median",     "99 %",   "across bias", "median",        "99 %"};
	switch (what)
	{
		case TableOf::doors:
			return {{"scenes", "doors", "precision %", "95 %", "recall %", "95 %", "hits", "false", "twice", "missed"},
			        doorCells};
		case TableOf::recalls:
			return {{"doors", "recall %", "95 %", "hits", "missed"}, mainRecallCells};
		case TableOf::narrow_doors:
			return {{"doors", "recall %", "95 %", "hits", "missed"}, narrowCells};
		case TableOf::false_alarms:
			return {{"scenes", "frames", "false alarms %", "95 %", "open", "frames %", "95 %", "reports %", "95 %"},
			        alarmCells};
		case TableOf::tolerances:
			return {{"P 0.15 m", "R 0.15 m", "P 0.30 m", "R 0.30 m", "P 0.45 m", "R 0.45 m"}, toleranceCells};
		case TableOf::hit_errors:
			return {kErrors, allHitCells};
		case TableOf::near_hit_errors:
			return {kErrors, nearHitCells};
		case TableOf::directions:
			return {{"corridors", "given %", "95 %", "median deg", "99 % deg", "within 2 deg %", "95 %", "no corridor",
			         "none given %", "95 %"},
			        directionCells};
		case TableOf::headings:
			return {{"frames", "good %", "95 %", "stops", "good stops", "collisions", "95 %"}, headingCells};
		case TableOf::confidences:
			return {{"candidates", "calibration error", "95 %", "AUROC", "95 %"}, confidenceCells};
	}
	return {};
}
}  // namespace

std::string groupTable(TableOf what, const std::string& title, const std::vector<Group>& groups)
{
	const TableShape shape = shapeOf(what);
	Cells titles{"<", "<robot", "<noise"};
	titles.insert(titles.end(), shape.columns.begin(), shape.columns.end());
	TextTable table(titles);
	for (const Group& group : groups)
	{
		const Cells figures = shape.cells(group.figures);
		if (figures.empty()) continue;
		Cells row{group.name, group.platform.empty() ? "all" : group.platform,
		          group.noise.empty() ? "all" : group.noise};
		row.insert(row.end(), figures.begin(), figures.end());
		table.row(row);
	}
	return table.empty() ? "" : title + "\n" + table.text() + "\n";
}
}  // namespace explore::evaluation

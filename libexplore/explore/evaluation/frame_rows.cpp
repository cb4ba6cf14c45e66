#include <explore/evaluation/cause_geometry.h>
#include <explore/evaluation/csv.h>
#include <explore/evaluation/frame_score.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>

namespace explore::evaluation
{
namespace
{
double timeOf(const DepthFrame& frame)
{
	return mrpt::Clock::toDouble(frame.timestamp);
}

std::size_t positivesIn(const std::vector<Report>& reports)
{
	return static_cast<std::size_t>(std::ranges::count_if(reports, &Report::positive));
}

/** Columns that need no truth. */
CsvRow& addPercepts(CsvRow& row, const StepResult& result, const std::vector<Report>& reports)
{
	const Percepts& percepts = result.percepts;
	return row.flag(percepts.ground && percepts.ground->seen)
	    .count(percepts.walls.size())
	    .count(reports.size())
	    .count(positivesIn(reports));
}

CsvRow& addDecision(CsvRow& row, const Decision& decision)
{
	return row.number(decision.headings.desired_rad)
	    .number(decision.headings.chosen_rad)
	    .text(decision.stop ? nameOf(decision.stop_reason) : "");
}

std::string causesOf(const FrameScore& score)
{
	std::string text;
	for (const Mistake& mistake : score.mistakes)
		text.append(text.empty() ? "" : " ")
		    .append(nameOf(mistake.pair.outcome))
		    .append(":")
		    .append(nameOf(mistake.cause));
	return text;
}

std::string causeFor(const FrameScore& score, const DoorPair& pair)
{
	for (const Mistake& mistake : score.mistakes)
		if (mistake.pair.report == pair.report && mistake.pair.truth == pair.truth)
			return std::string(nameOf(mistake.cause));
	return "";
}

void addTruth(CsvRow& row, const TruthDoor& door, const Eigen::Vector2d& camera)
{
	const Eigen::Vector2d center = door.center_in_map.head<2>(), toward = camera - center;
	const double offset_rad = angleBetweenAxes({toward.x(), toward.y(), 0.0}, door.normal_in_map);
	row.text(door.id)
	    .number(center.x())
	    .number(center.y())
	    .number(door.width_m)
	    .number(door.clear_width_m)
	    .text(nameOf(door.verdict))
	    .flag(door.passable)
	    .text(nameOf(door.visibility))
	    .number(door.visible_share)
	    .number(toward.norm())
	    .number(mrpt::RAD2DEG(offset_rad));
}

void addReport(CsvRow& row, const Report& report)
{
	row.number(report.center_in_map.x())
	    .number(report.center_in_map.y())
	    .number(report.door.width_m)
	    .number(report.door.clear_width_m)
	    .text(nameOf(report.door.verdict))
	    .flag(report.positive)
	    .number(report.door.confidence);
}

void addErrors(CsvRow& row, const Report& report, const TruthDoor& door)
{
	const CenterError error = centerError(report, door);
	row.number(centerDistance(report, door))
	    .number(widthError(report, door))
	    .number(error.along_m)
	    .number(error.across_m);
}
}  // namespace

std::string frameHeader()
{
	return "log,frame,t,scene,ground_seen,walls,reports,positives,hits,false_alarms,misses,causes,corridor,"
	       "direction_error,desired,chosen,stop_reason,heading_score,best_score,heading_good,collision\n";
}

std::string doorHeader()
{
	return "log,frame,scene,outcome,cause,truth_id,truth_x,truth_y,truth_width,truth_clear_width,truth_verdict,"
	       "passable,"
	       "visibility,visible_share,distance,offset_deg,report_x,report_y,report_width,report_clear_width,"
	       "report_verdict,positive,confidence,center_error,width_error,along_error,across_error\n";
}

std::string frameRow(const ScoreInput& input, const FrameScore& score)
{
	CsvRow row;
	row.text(input.log).count(input.frame.index).number(timeOf(input.frame));
	row.count(static_cast<std::size_t>(input.truth_frame.scene));
	addPercepts(row, input.result, score.reports);
	const DoorCounts& doors = score.tally.main();
	row.count(doors.hits).count(doors.false_alarms).count(doors.misses).text(causesOf(score));
	row.text(nameOf(input.truth_frame.corridor.state)).number(score.direction_error_rad);
	addDecision(row, input.result.decision);
	if (score.heading)
		row.number(score.heading->chosen)
		    .number(score.heading->best)
		    .flag(score.heading->good)
		    .flag(score.heading->collision);
	else
		row.blanks(4);
	return row.line();
}

std::string frameRowWithoutTruth(const std::string& log, const DepthFrame& frame, const StepResult& result,
                                 const RobotConfig& robot)
{
	CsvRow row;
	row.text(log).count(frame.index).number(timeOf(frame)).blanks(1);
	addPercepts(row, result, reportsOf(result.percepts.doors, frame.map_from_robot, robot)).blanks(6);
	addDecision(row, result.decision).blanks(4);
	return row.line();
}

std::vector<std::string> doorRows(const ScoreInput& input, const FrameScore& score)
{
	const Eigen::Vector2d camera = cameraPlace(input);
	std::vector<std::string> rows;
	for (const DoorPair& pair : score.pairs)
	{
		CsvRow row;
		row.text(input.log).count(input.frame.index).count(static_cast<std::size_t>(input.truth_frame.scene));
		row.text(nameOf(pair.outcome)).text(causeFor(score, pair));
		const TruthDoor* door = pair.truth ? &input.truth_frame.doors[*pair.truth] : nullptr;
		const Report* report = pair.report ? &score.reports[*pair.report] : nullptr;
		if (door != nullptr)
			addTruth(row, *door, camera);
		else
			row.blanks(11);
		if (report != nullptr)
			addReport(row, *report);
		else
			row.blanks(7);
		if (door != nullptr && report != nullptr)
			addErrors(row, *report, *door);
		else
			row.blanks(4);
		rows.push_back(row.line());
	}
	return rows;
}
}  // namespace explore::evaluation

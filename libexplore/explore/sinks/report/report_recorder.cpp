#include <explore/core/errors.h>
#include <explore/sinks/report/report_page.h>
#include <explore/sinks/report/report_recorder.h>
#include <explore/sinks/report/short_numbers.h>

namespace explore
{
namespace
{
constexpr double kOneGoal_m = 0.25;

std::string beginningText(double t_s, const ReportConfig& config)
{
	return jsonText({{"t", jsonNumber(t_s)},
	                 {"range", shortNumber(config.camera.max_range_m, 2)},
	                 {"radius", shortNumber(config.robot_radius_m, 3)}});
}

/** [frame, t, x, y, yaw, stop]; the place is null where nobody knows it. */
std::string poseText(const DepthFrame& frame, const Decision& decision, double t_s)
{
	Json line{frame.index, shortNumber(t_s, 3)};
	const auto& pose = frame.map_from_robot;
	const bool known = frame.pose_origin != PoseOrigin::none;
	for (const auto& [value, decimals] : {std::pair{pose.x(), 3}, {pose.y(), 3}, {pose.yaw(), 3}})
		line.push_back(known ? shortNumber(value, decimals) : Json());
	line.push_back(decision.stop ? 1 : 0);
	return jsonText(line);
}
}  // namespace

ReportRecorder::ReportRecorder(const std::filesystem::path& log, const ReportConfig& config)
    : m_config(config), m_log(log), m_cameras(config.cameras), m_plans(config.plans)
{
}

ReportRecorder::ReportRecorder(const std::filesystem::path& log, const ReportConfig& config, std::uintmax_t bytes)
    : m_config(config), m_log(log, bytes), m_cameras(config.cameras), m_plans(config.plans)
{
	try
	{
		m_log.read([this](const ReportEntry& entry) { follow(entry); });
	}
	catch (const std::exception& error)
	{
		throw InputError(log.string() + ": cannot be continued: " + error.what());
	}
}

void ReportRecorder::follow(const ReportEntry& entry)
{
	switch (entry.kind)
	{
		case ReportLine::beginning:
			m_first_t_s = Json::parse(entry.text).at("t").get<double>();
			return;
		case ReportLine::pose:
			m_last = {entry.frame, Json::parse(entry.text).at(1).get<double>()};
			return;
		case ReportLine::camera:
			return m_cameras.add(entry.frame, entry.text.size());
		case ReportLine::plan:
			m_plans.add(entry.frame, entry.text.size());
			applyPlanRecord(std::string(entry.text), m_plan);
			return;
		case ReportLine::goal:
			break;
	}
	const Json goal = Json::parse(entry.text);
	m_goal = {};
	for (int kind = 0; kind <= static_cast<int>(GoalKind::none); ++kind)
		if (nameOf(static_cast<GoalKind>(kind)) == goal.at(1)) m_goal.kind = static_cast<GoalKind>(kind);
	if (!goal.at(2).is_null()) m_goal.track = goal.at(2).get<int>();
	if (!goal.at(3).is_null()) m_goal.point_in_map = Eigen::Vector2d(goal.at(3), goal.at(4));
}

std::string ReportRecorder::goalText(const DepthFrame& frame, const Goal& goal)
{
	LastGoal now{goal.kind, goal.track, std::nullopt};
	if (goal.point_in_robot && frame.pose_origin != PoseOrigin::none)
	{
		const Eigen::Vector3d point = isometryOf(frame.map_from_robot) * *goal.point_in_robot;
		// As the log has it, so that a run that goes on from the log goes on with the same.
		now.point_in_map = Eigen::Vector2d(shortNumber(point.x(), 2), shortNumber(point.y(), 2));
	}
	const bool near = now.point_in_map.has_value() == m_goal.point_in_map.has_value() &&
	                  (!now.point_in_map || (*now.point_in_map - *m_goal.point_in_map).norm() < kOneGoal_m);
	if (now.kind == m_goal.kind && now.track == m_goal.track && near) return "";
	m_goal = now;
	Json line{frame.index, nameOf(now.kind), jsonOrNull(now.track)};
	for (const int axis : {0, 1}) line.push_back(now.point_in_map ? Json((*now.point_in_map)[axis]) : Json());
	return jsonText(line);
}

std::string ReportRecorder::planText(const PlanTime& time, const FrontierMemory& memory,
                                     const std::optional<double>& coverage)
{
	PlanSnapshot now = planSnapshotOf(memory);
	now.coverage = coverage;
	std::string text = planRecord(m_plan, now, time);
	m_plan = std::move(now);
	return text;
}

void ReportRecorder::add(const DepthFrame& frame, const StepResult& result, const ExplorerState& state,
                         const std::optional<double>& coverage)
{
	const double t_s = mrpt::Clock::toDouble(frame.timestamp);
	std::string beginning, camera, plan;
	if (!m_first_t_s) beginning = beginningText(t_s, m_config);
	if (!m_first_t_s) m_first_t_s = t_s;
	m_last = {frame.index, t_s - *m_first_t_s};
	if (m_cameras.wants(frame.index)) camera = cameraRecord(frame, result, m_last.t_s, m_config.camera);
	if (state.memory && m_plans.wants(frame.index)) plan = planText(m_last, *state.memory, coverage);
	const std::string pose = poseText(frame, result.decision, m_last.t_s);
	const std::string goal = goalText(frame, result.decision.goal);
	m_log.write({{ReportLine::beginning, frame.index, beginning},
	             {ReportLine::pose, frame.index, pose},
	             {ReportLine::goal, frame.index, goal},
	             {ReportLine::camera, frame.index, camera},
	             {ReportLine::plan, frame.index, plan}});
	m_cameras.add(frame.index, camera.size());
	if (!plan.empty()) m_plans.add(frame.index, plan.size());
}

std::string ReportRecorder::page(const RunSummary& summary, const TimingRecord& timing,
                                 const ExplorerState& state) const
{
	std::optional<PlanSnapshot> last;
	if (state.memory) last = planSnapshotOf(*state.memory);
	if (last && summary.truth) last->coverage = summary.truth->coverage;
	return reportPage(
	    m_log, {m_config.page_bytes, m_config.most_poses, m_config.most_goals, m_cameras.stride(), m_plans.stride()},
	    {summary, timing, last ? &*last : nullptr, m_last});
}
}  // namespace explore

// Follows a run for its report: what of each frame is kept, and the page in the end.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/pipeline/explorer.h>
#include <explore/sinks/report/camera_record.h>
#include <explore/sinks/report/plan_record.h>
#include <explore/sinks/report/report_log.h>
#include <explore/sinks/report/thinning.h>
#include <explore/sinks/stage_clock.h>
#include <explore/sinks/summary.h>

#include <optional>
#include <string>

namespace explore
{
struct ReportConfig
{
	CameraRecordConfig camera;
	double robot_radius_m = 0.22;
	std::size_t page_bytes = 15'000'000;  ///< the page is no larger
	Thinning::Limits cameras{11'000'000, 3000, 1};
	/** Of the plan; every fourth frame is as often as one sees. */
	Thinning::Limits plans{2'500'000, 600, 4};
	std::size_t most_poses = 6000, most_goals = 2000;
};

class ReportRecorder
{
public:
	/** A new log. Throws OutputError. */
	ReportRecorder(const std::filesystem::path& log, const ReportConfig& config);
	/** Goes on after the first `bytes` of a log as if it had never stopped. Throws InputError where there is none, and
	 *  OutputError where it is not what was written. */
	ReportRecorder(const std::filesystem::path& log, const ReportConfig& config, std::uintmax_t bytes);

	/** `state` is that after the frame, `coverage` the share of what the robot can get to that the map shows as free,
	 *  0–1, where that is known. Throws OutputError. */
	void add(const DepthFrame& frame, const StepResult& result, const ExplorerState& state,
	         const std::optional<double>& coverage);
	[[nodiscard]] std::uintmax_t bytes() const { return m_log.bytes(); }
	[[nodiscard]] const std::filesystem::path& path() const { return m_log.path(); }

	/** The page of the frames so far; `state` is that after the last one. Throws OutputError where the log is not what
	 *  was written. */
	[[nodiscard]] std::string page(const RunSummary& summary, const TimingRecord& timing,
	                               const ExplorerState& state) const;

private:
	struct LastGoal
	{
		GoalKind kind = GoalKind::none;
		std::optional<int> track;
		std::optional<Eigen::Vector2d> point_in_map;
	};

	/** Takes an entry of the log into what the next frames depend on. */
	void follow(const ReportEntry& entry);
	std::string goalText(const DepthFrame& frame, const Goal& goal);
	std::string planText(const PlanTime& time, const FrontierMemory& memory, const std::optional<double>& coverage);

	ReportConfig m_config;
	ReportLog m_log;
	Thinning m_cameras, m_plans;
	std::optional<double> m_first_t_s;  ///< mrpt::Clock::toDouble of the first frame
	LastGoal m_goal;
	PlanSnapshot m_plan;  ///< the last one in the log
	PlanTime m_last;      ///< the last frame
};
}  // namespace explore

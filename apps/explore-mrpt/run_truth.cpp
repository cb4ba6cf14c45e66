#include <explore-mrpt/run_truth.h>
#include <explore/core/geometry.h>
#include <explore/evaluation/coverage.h>

namespace explore::app
{
void RunTruth::add(const DepthFrame& frame, const StepResult& result, bool goal_lost)
{
	if (m_robot == nullptr) return;
	const TrueState state = m_robot->trueState();
	const Goal& goal = result.decision.goal;
	evaluation::WatchedFrame watched;
	watched.t_s = state.t_s;
	watched.map_from_robot = state.map_from_robot;
	watched.goal = goal.kind;
	watched.goal_lost = goal_lost;
	// Goals stand in the explorer's map: its own pose takes them there.
	if (goal.point_in_robot) watched.goal_in_map = isometryOf(frame.map_from_robot) * *goal.point_in_robot;
	m_watch.add(watched);
}

std::optional<TruthSummary> RunTruth::summary(const octomap::OcTree* map) const
{
	if (m_robot == nullptr) return std::nullopt;
	const TrueState state = m_robot->trueState();
	TruthSummary truth;
	truth.contacts = state.contacts;
	truth.min_clearance_m = state.min_clearance_m;
	truth.path_m = m_watch.path_m();
	truth.from_start_m = m_watch.fromStart_m();
	truth.goal_flips = m_watch.flips();
	const TruthReach reach = m_coverage ? m_coverage->reach() : m_robot->reachable();
	truth.reachable_m2 = reach.floorArea();
	if (map != nullptr) truth.coverage = evaluation::coverageOf(reach, *map).share();
	return truth;
}

void RunTruth::follow(FrontierMemory* memory)
{
	if (m_robot == nullptr || memory == nullptr) return;
	if (!m_coverage) m_coverage.emplace(m_robot->reachable());
	m_coverage->follow(*memory);
}

std::optional<double> RunTruth::coverage() const
{
	if (!m_coverage) return std::nullopt;
	return m_coverage->coverage().share();
}
}  // namespace explore::app

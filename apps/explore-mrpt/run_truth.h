// What a simulated run really was like, beside what its explorer made of it.
#pragma once

#include <common/closed_loop_source.h>
#include <explore/evaluation/coverage_count.h>
#include <explore/evaluation/run_watch.h>
#include <explore/pipeline/explorer.h>
#include <explore/sinks/summary.h>

namespace octomap
{
class OcTree;
}

namespace explore::app
{
/** Of a recording, whose truth nobody knows, it says nothing. */
class RunTruth
{
public:
	/** `robot` outlives it; null for a recording. */
	explicit RunTruth(const ClosedLoopSource* robot) : m_robot(robot) {}

	/** `frame` is the last one that the robot took; `goal_lost` says that the map has put an end to the goal before. */
	void add(const DepthFrame& frame, const StepResult& result, bool goal_lost);
	/** Counts on with what the last frame changed in the map; `memory` may be null. */
	void follow(FrontierMemory* memory);
	/** Share of what the robot can get to that the map showed as free when it was followed last, 0–1; no value for a
	 *  recording or without a map. */
	[[nodiscard]] std::optional<double> coverage() const;
	/** Of the frames so far. Coverage is that of `map`, where there is one. */
	[[nodiscard]] std::optional<TruthSummary> summary(const octomap::OcTree* map) const;
	/** Writes or reads what add() changes. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_watch);
	}

private:
	const ClosedLoopSource* m_robot;
	std::optional<evaluation::CoverageCount> m_coverage;  ///< from the first frame with a map on
	evaluation::RunWatch m_watch;
};
}  // namespace explore::app

// summary.json: what one run did, in one document; and the same in a few lines for people.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/pipeline/explorer.h>
#include <explore/sinks/stage_clock.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace explore
{
/** Counts that grow frame by frame. */
class RunTally
{
public:
	void add(const DepthFrame& frame, const StepResult& result);

	std::size_t frames = 0;
	std::size_t frames_with_ground = 0;  ///< the floor was seen, not carried on
	std::size_t frames_with_door = 0;
	std::size_t frames_stopped = 0;
	std::size_t doors_in_view = 0;  ///< in the last frame

	/** Length of the driven path; no value without a pose source. */
	[[nodiscard]] std::optional<double> path_m() const { return m_path_m; }
	/** From the first to the last frame, by their time stamps; no value without frames. */
	[[nodiscard]] std::optional<double> time_s() const;

private:
	std::optional<mrpt::Clock::time_point> m_first, m_last;
	std::optional<Eigen::Vector3d> m_position_in_map;
	std::optional<double> m_path_m;
};

/** What the input was and what became of it. */
struct InputSummary
{
	std::string kind, path;
	std::size_t skipped_frames = 0;
	std::uint64_t lost_bytes = 0;
	std::size_t lost_objects = 0;
	std::string damage;  ///< empty = intact
	std::string sensor;
	std::vector<std::string> sensors_found;
	PoseOrigin pose_origin = PoseOrigin::none;
	bool identity_mount = false;
};

struct RunSummary
{
	std::string version;
	std::string config;  ///< as given by the user; empty = built-in defaults
	InputSummary input;
	RunTally tally;
	std::vector<std::string> warnings;  ///< that the user got, each once
	std::string reason;                 ///< why the run ended
	std::map<std::string, StageStatistics> timing;
	double peak_rss_mb = 0;
};

/** The document, indented, ended by a newline; fields in doc/output-format.md. */
std::string summaryJson(const RunSummary& summary);

/** Four or five lines for a person: what was read, what was found, how fast, what was lost. */
std::string summaryText(const RunSummary& summary);
}  // namespace explore

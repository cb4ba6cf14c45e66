// summary.json: what one run did, in one document; and the same in a few lines for people.
#pragma once

#include <explore/core/contact.h>
#include <explore/core/depth_frame.h>
#include <explore/pipeline/explorer.h>
#include <explore/sinks/exploration_summary.h>
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
	std::size_t doors_in_view = 0;   ///< in the last frame
	GoalKind goal = GoalKind::none;  ///< of the last frame

	/** Length of the driven path; no value without a pose source. */
	[[nodiscard]] std::optional<double> path_m() const { return m_path_m; }
	/** From the first to the last frame, by their time stamps; no value without frames. */
	[[nodiscard]] std::optional<double> time_s() const;

	/** Writes or reads all of it. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(frames), archive(frames_with_ground), archive(frames_with_door), archive(frames_stopped);
		archive(doors_in_view), archive(goal);
		archive(m_first), archive(m_last), archive(m_position_in_map), archive(m_path_m);
	}

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
	std::size_t dropped_frames = 0;         ///< of a live camera, which was quicker than the explorer
	std::optional<double> oldest_frame_ms;  ///< of a live camera: its age when it was delivered
	std::size_t away_frames = 0;            ///< that stand for a live camera that was away
	std::uint64_t lost_bytes = 0;
	std::size_t lost_objects = 0;
	std::string damage;  ///< empty = intact
	std::string sensor;
	std::vector<std::string> sensors_found;
	PoseOrigin pose_origin = PoseOrigin::none;
	bool identity_mount = false;
};

/** What a simulated run was really like (doc/definitions.md, "Exploration"). */
struct TruthSummary
{
	std::vector<Contact> contacts;
	std::optional<double> min_clearance_m;  ///< of the moving body; no value where it never moved
	double path_m = 0;                      ///< that the robot really went
	double from_start_m = 0;                ///< straight, from its first place to its last
	std::size_t goal_flips = 0;
	double reachable_m2 = 0;
	std::optional<double> coverage;  ///< of the reachable; no value without a map
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
	ProcessorUse processor;
	ExplorationSummary exploration;
	std::optional<TruthSummary> truth;  ///< no value: a recording, whose truth nobody knows
};

/** The document, indented, ended by a newline; fields in doc/output-format.md. */
std::string summaryJson(const RunSummary& summary);

/** Four or five lines for a person: what was read, what was found, how fast, what was lost. */
std::string summaryText(const RunSummary& summary);
}  // namespace explore

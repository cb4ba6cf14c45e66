// What is counted and measured over frames, so that it can be added up over scenes, logs and machines.
#pragma once

#include <explore/core/results.h>
#include <explore/evaluation/json_place.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace explore::evaluation
{
using Count = std::uint64_t;

/** Largest distance of a report's centre from the true one, on the floor plane [m]; figures stand for the middle one
 *  where nothing else is said. */
inline constexpr std::array<double, 3> kCenterTolerances_m{0.15, 0.30, 0.45};
inline constexpr std::size_t kMainTolerance = 1;
inline constexpr double kWidthTolerance_m = 0.25;
inline constexpr double kNarrowDoor_m = 0.85;  ///< true widths below count as narrow
inline constexpr double kNearDoor_m = 3.0;     ///< doors up to here are near

struct DoorCounts
{
	Count hits = 0, false_alarms = 0, misses = 0;
};

/** A report with a confidence, and whether a passable door was there. */
struct Candidate
{
	double confidence = 0;
	bool right = false;
};

/** Rows: what truly is there; columns: what was reported. The last of each is "none". */
inline constexpr std::size_t kVerdicts = 8;
using Confusion = std::array<std::array<Count, kVerdicts + 1>, kVerdicts + 1>;
/** "open" … "unknown", then "none". */
std::string_view verdictName(std::size_t index);

struct Tally
{
	Count frames = 0;
	std::array<DoorCounts, kCenterTolerances_m.size()> doors;  ///< one a tolerance
	Count false_alarm_frames = 0;                              ///< with at least one false alarm
	Count report_frames = 0;                                   ///< with any report, whatever its verdict
	Count open_frames = 0, open_reports = 0;                   ///< `open` where nothing can be passed: frames, reports
	Count unscored_frames = 0;                                 ///< of frames: in none of the four counts above
	Count narrow_hits = 0, narrow_misses = 0;                  ///< of doors narrower than kNarrowDoor_m
	Count corridor_frames = 0, corridor_given = 0;             ///< corridor in view; a direction was given there
	Count corridor_close = 0;                                  ///< of corridor_given: the error is at most 2°
	Count plain_frames = 0, plain_null = 0;                    ///< no corridor; no direction was given there
	Count heading_frames = 0, good_headings = 0;               ///< with true free paths; good (doc/definitions.md)
	Count stops = 0, good_stops = 0, collisions = 0;           ///< of heading_frames

	std::vector<double> width_errors_m;        ///< of the hits, reported − true
	std::vector<double> center_errors_m;       ///< of the hits, at least 0
	std::vector<double> along_errors_m;        ///< of the hits: their part along the true wall, positive to the left
	std::vector<double> across_errors_m;       ///< of the hits: their part across it, positive toward the camera
	std::vector<double> hit_distances_m;       ///< of the hits: from the camera to the true door on the floor plane
	std::vector<double> direction_errors_rad;  ///< of corridor_given, at least 0
	std::vector<Candidate> candidates;         ///< reports that have a confidence
	std::map<std::string, Count> false_alarm_causes, miss_causes;
	Confusion confusion{};

	void add(const Tally& other);
	[[nodiscard]] const DoorCounts& main() const { return doors[kMainTolerance]; }
};

/** Errors are rounded to this before they are kept: 0.1 mm, 0.1 mrad. */
double rounded(double error);

/** Everything, without what is 0 or empty. */
Json tallyJson(const Tally& tally);
/** What tallyJson() wrote. Throws InputError. */
Tally tallyOf(const JsonPlace& place);
}  // namespace explore::evaluation

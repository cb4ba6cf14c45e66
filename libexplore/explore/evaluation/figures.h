// The figures of a group of scenes, as doc/definitions.md defines them.
#pragma once

#include <explore/evaluation/log_score.h>
#include <explore/evaluation/scene_bootstrap.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace explore::evaluation
{
struct DoorFigures
{
	DoorCounts counts;
	std::optional<Rate> precision, recall;
};

struct ErrorFigures
{
	std::size_t count = 0;
	std::optional<double> bias;         ///< median of the signed errors
	std::optional<double> median, p99;  ///< of their sizes
	std::optional<Interval> interval;   ///< of the median, 95 %
};

/** Errors of hits. */
struct HitFigures
{
	ErrorFigures width_m, center_m, along_m, across_m;  ///< the last two are the parts of the centre's error
};

struct ConfidenceFigures
{
	std::size_t candidates = 0;
	std::optional<double> calibration_error, auroc;
	std::optional<Interval> calibration_interval, auroc_interval;  ///< 95 %
	std::vector<ReliabilityBin> bins;
	std::vector<CurvePoint>
	    curve;  ///< precision over recall; the single point of all reports where none has a confidence
};

struct Figures
{
	std::size_t scenes = 0;
	Tally sum;  ///< counts alone, without the lists of errors
	std::array<DoorFigures, kCenterTolerances_m.size()> doors;
	std::optional<Rate> narrow_recall;                                   ///< of doors narrower than kNarrowDoor_m
	std::optional<Rate> false_alarm_frames, report_frames, open_frames;  ///< of all scored frames
	HitFigures hits, near_hits;                                          ///< of all hits; of those up to kNearDoor_m
	ErrorFigures direction_rad;
	std::optional<Rate> direction_given, direction_close, direction_null;
	std::optional<Rate> good_headings, collisions;
	ConfidenceFigures confidence;

	[[nodiscard]] const DoorFigures& main() const { return doors[kMainTolerance]; }
};

Figures figuresOf(std::span<const SceneScore* const> scenes);

/** Scenes that are reported together. */
struct Group
{
	std::string name, platform, noise;  ///< platform and noise: empty = all
	bool negative = false;
	bool by_tracks = false;  ///< scored by its tracks: part of no other group
	Figures figures;
};

struct Results
{
	std::vector<Group> configurations;  ///< rows of the paper's Fig. 3(b), then "all" of them, for each robot and noise
	std::vector<Group> families;        ///< families (or worlds) with doors, then those without, then those of mirrors
	std::vector<Group> pooled;          ///< all with doors, all without: each robot and noise, then all of them
	std::vector<Group> overall;         ///< both together, likewise
	std::vector<Group> corners;         ///< families of corner doors, for each robot and noise, then all of them
	std::vector<Group> hazards;         ///< families where `open` would harm the robot, likewise
	/** Over all logs with truth but those of mirrors; what requirements refer to. */
	std::optional<Figures> positives, negatives, everything;
	std::vector<const LogScore*> without_truth;
};

/** Mirrors: a frame cannot tell their picture of the room from a room. */
bool scoredByTracks(const LogScore& log);

/** `logs` outlive the results. */
Results resultsOf(const std::vector<LogScore>& logs);
}  // namespace explore::evaluation

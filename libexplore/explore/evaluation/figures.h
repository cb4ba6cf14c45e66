// The figures of a group of scenes, as doc/definitions.md defines them.
#pragma once

#include <explore/evaluation/log_score.h>
#include <explore/evaluation/statistics.h>

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
};

struct ConfidenceFigures
{
	std::size_t candidates = 0;
	std::optional<double> calibration_error, auroc;
	std::vector<CurvePoint>
	    curve;  ///< precision over recall; the single point of all reports where none has a confidence
};

struct Figures
{
	std::size_t scenes = 0;
	Tally sum;  ///< counts alone, without the lists of errors
	std::array<DoorFigures, kCenterTolerances_m.size()> doors;
	std::optional<Rate> false_alarm_frames, report_frames;  ///< of all frames
	ErrorFigures width_m, center_m, direction_rad;
	std::optional<Rate> direction_given, direction_null;
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
	Figures figures;
};

struct Results
{
	std::vector<Group> configurations;  ///< rows of the paper's Fig. 3(b), then "all" of them, for each robot and noise
	std::vector<Group> families;        ///< families (or worlds) with doors, then those without
	std::vector<Group> pooled;          ///< for each robot and noise: all with doors, all without
	std::optional<Figures> positives, negatives, everything;  ///< over all logs with truth; what requirements refer to
	std::vector<const LogScore*> without_truth;
};

/** `logs` outlive the results. */
Results resultsOf(const std::vector<LogScore>& logs);
}  // namespace explore::evaluation

// Many simulated explorations, world by world: what each came to, and tables of all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace explore::evaluation
{
/** What became of one exploration. */
struct SoakRun
{
	std::string world;  ///< as tables name it
	int seed = 0;
	std::string error;  ///< empty = it ran to an end of its own; else nothing below is known
	bool complete = false;
	std::string reason;  ///< why it ended
	double time_s = 0;   ///< simulated
	double path_m = 0, from_start_m = 0;
	std::size_t frames = 0, collisions = 0, goal_flips = 0;
	double reachable_m2 = 0;
	std::optional<double> coverage, min_clearance_m;
	double median_ms = 0;  ///< of a frame
};

/** The figures of the run that left the summary.json at `path`. Throws InputError, also where it holds no truth. */
SoakRun readSoakRun(const std::string& world, int seed, const std::filesystem::path& path);

/** A line a world, in the order of their first runs, and one for all: medians and rates with 95 % intervals from
 *  resampled runs. Then what failed, run by run. Empty without runs. */
std::string soakText(std::span<const SoakRun> runs);

/** A header and a line a run. */
std::string soakCsv(std::span<const SoakRun> runs);
}  // namespace explore::evaluation

// Two sets of simulated explorations, compared run by run: the same worlds and seeds, configured in two ways.
#pragma once

#include <explore/evaluation/soak.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace explore::evaluation
{
/** The runs that `soak` left in a folder (WORLD/SEED/summary.json), by world and seed; empty where there are none.
 *  Throws InputError for a summary that cannot be read. */
std::vector<SoakRun> readSoakRuns(const std::filesystem::path& folder);

/** What the other way of exploring costs and shows beside the base, over the runs of both with the same world and
 *  seed. */
struct SoakPairs
{
	std::string world;
	std::vector<SoakRun> base, other;  ///< pair by pair
};
/** By world, in the order of the base's. */
std::vector<SoakPairs> pairsOf(std::span<const SoakRun> base, std::span<const SoakRun> other);

/** By how much the others' ways are longer, as a share of the base's: of the pairs of which both runs are complete, of
 *  all their metres together. No value without one. */
std::optional<double> longerShare(const SoakPairs& pairs);

/** A line a world, and one for all worlds: pairs, how many of each are complete, medians of path and coverage, and how
 *  much longer the other's ways are, with 95 % intervals from resampled pairs. */
std::string soakPairsText(const std::string& base_name, const std::string& other_name,
                          std::span<const SoakPairs> worlds);
}  // namespace explore::evaluation

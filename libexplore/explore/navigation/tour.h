// The shortest ways through a set of places that end at home.
#pragma once

#include <cstddef>
#include <vector>

namespace explore
{
/** Costs [m] between places; any may be infinite. */
struct TourCosts
{
	std::vector<double> from_robot;            ///< to each place
	std::vector<std::vector<double>> between;  ///< from each place to each other
	std::vector<double> to_home;               ///< from each place
};

/** At most so many places. */
inline constexpr std::size_t kMaxTourPlaces = 12;

/** For each place the cost [m] of the cheapest tour that begins there, visits every place once and ends at home;
 *  infinite where no order leads through all. By dynamic programming over subsets (Held & Karp 1962): exact. Throws
 *  std::invalid_argument for more than kMaxTourPlaces. */
std::vector<double> toursByFirst(const TourCosts& costs);
}  // namespace explore

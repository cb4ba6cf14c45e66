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
	double home_from_robot = 0;
};

/** Up to so many places the tours are the cheapest there are. */
inline constexpr std::size_t kExactTourPlaces = 10;

/** For each place the cost [m] of a tour that begins there, visits every place once and ends at home; infinite where no
 *  order leads through all. Exact for few places, by dynamic programming over subsets (Held & Karp 1962); for more the
 *  best that nearest neighbours, improved by reversing and moving stretches (Croes 1958, Or 1976), come to. */
std::vector<double> toursByFirst(const TourCosts& costs);
}  // namespace explore

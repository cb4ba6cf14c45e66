// The shortest way through a set of places that ends at home.
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

struct Tour
{
	std::vector<std::size_t> order;  ///< each place once; empty where every order has an infinite cost
	double cost_m = 0;
};

/** At most so many places. */
inline constexpr std::size_t kMaxTourPlaces = 12;

/** The cheapest order, by dynamic programming over subsets (Held & Karp 1962): exact. With `first`, among those that
 *  begin there. Throws std::invalid_argument for more than kMaxTourPlaces. */
Tour shortestTour(const TourCosts& costs);
Tour shortestTour(const TourCosts& costs, std::size_t first);
}  // namespace explore

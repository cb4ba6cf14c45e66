// Which places a tour had better leave out: those that are not worth the way there.
#pragma once

#include <explore/navigation/tour.h>

#include <cstddef>
#include <vector>

namespace explore
{
/** The places that a short tour goes to when a place may be left out for its worth [m], which may be
 *  infinite: a stretch of the tour is left out where the way grows shorter by more than the stretch is worth. The
 *  problem is that of the prize-collecting tour (Balas 1989); this finds a good answer, not always the best. */
std::vector<std::size_t> placesWorthTheWay(const TourCosts& costs, const std::vector<double>& worth_m);

/** The costs between some of the places. */
TourCosts costsOfSome(const TourCosts& costs, const std::vector<std::size_t>& places);
}  // namespace explore

// Short tours through many places: a first order, made better step by step.
#pragma once

#include <explore/navigation/tour.h>

#include <cstddef>
#include <vector>

namespace explore
{
/** Places in the order of a tour, and last the number of home: TourSearch::home(). */
using TourOrder = std::vector<std::size_t>;

class TourSearch
{
public:
	/** Infinite costs count as kNever_m. */
	explicit TourSearch(const TourCosts& costs);
	static constexpr double kNever_m = 1e9;

	[[nodiscard]] std::size_t home() const { return m_from_robot.size(); }
	[[nodiscard]] double costOf(const TourOrder& order) const;

	/** From `first` always on to the place that is nearest then. */
	[[nodiscard]] TourOrder nearestNeighbours(std::size_t first) const;
	/** Reverses stretches, and moves stretches of up to three places, turned round or not, while that makes the tour
	 *  shorter. The first place stays, and home. */
	void improve(TourOrder& order) const;

private:
	[[nodiscard]] double step(const TourOrder& order, std::size_t from, std::size_t to) const
	{
		return m_between[order[from]][order[to]];
	}
	[[nodiscard]] double turned(const TourOrder& order, std::size_t first, std::size_t last) const;
	bool reverseAny(TourOrder& order) const;
	bool moveAny(TourOrder& order, std::size_t length) const;
	bool moveStretch(TourOrder& order, std::size_t first, std::size_t last) const;

	std::vector<double> m_from_robot;
	std::vector<std::vector<double>> m_between;  ///< home is the last column
};
}  // namespace explore

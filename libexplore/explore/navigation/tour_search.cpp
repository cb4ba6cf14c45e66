#include <explore/navigation/tour_search.h>

#include <algorithm>
#include <numeric>

namespace explore
{
namespace
{
/** Less is no gain: it may be rounding, and would be found for ever. */
constexpr double kGain_m = 1e-6;
constexpr std::size_t kLongestMove = 3;

std::vector<double> finite(std::vector<double> costs)
{
	for (double& cost : costs) cost = std::min(cost, TourSearch::kNever_m);
	return costs;
}

auto at(TourOrder& order, std::size_t i)
{
	return order.begin() + static_cast<std::ptrdiff_t>(i);
}
}  // namespace

TourSearch::TourSearch(const TourCosts& costs) : m_from_robot(finite(costs.from_robot))
{
	for (std::size_t i = 0; i < home(); ++i)
	{
		std::vector<double> row = finite(costs.between[i]);
		row.push_back(std::min(costs.to_home[i], kNever_m));
		m_between.push_back(std::move(row));
	}
}

double TourSearch::costOf(const TourOrder& order) const
{
	double sum = m_from_robot[order.front()];
	for (std::size_t i = 0; i + 1 < order.size(); ++i) sum += step(order, i, i + 1);
	return sum;
}

TourOrder TourSearch::nearestNeighbours(std::size_t first) const
{
	TourOrder order(home() + 1);
	std::iota(order.begin(), order.end(), 0U);
	std::swap(order[0], order[first]);
	for (std::size_t i = 0; i + 2 < order.size(); ++i)
	{
		const std::vector<double>& from_here = m_between[order[i]];
		std::iter_swap(at(order, i + 1),
		               std::min_element(at(order, i + 1), order.end() - 1,
		                                [&](std::size_t a, std::size_t b) { return from_here[a] < from_here[b]; }));
	}
	return order;
}

/** What a stretch costs more when it is gone through from its last place to its first. */
double TourSearch::turned(const TourOrder& order, std::size_t first, std::size_t last) const
{
	double more = 0.0;
	for (std::size_t i = first; i < last; ++i) more += step(order, i + 1, i) - step(order, i, i + 1);
	return more;
}

bool TourSearch::reverseAny(TourOrder& order) const
{
	bool better = false;
	for (std::size_t first = 1; first + 2 < order.size(); ++first)
	{
		double more = 0.0;  // of the stretch itself, as it grows
		for (std::size_t last = first + 1; last + 1 < order.size(); ++last)
		{
			more += step(order, last, last - 1) - step(order, last - 1, last);
			const double now = step(order, first - 1, first) + step(order, last, last + 1);
			const double then = step(order, first - 1, last) + step(order, first, last + 1) + more;
			if (then >= now - kGain_m) continue;
			std::reverse(at(order, first), at(order, last + 1));
			better = true;
			more = turned(order, first, last);
		}
	}
	return better;
}

/** Puts a stretch elsewhere, the first time that it is for the better. */
bool TourSearch::moveStretch(TourOrder& order, std::size_t first, std::size_t last) const
{
	const double taken_out =
	    step(order, first - 1, first) + step(order, last, last + 1) - step(order, first - 1, last + 1);
	const double turning = turned(order, first, last);
	for (std::size_t before = 0; before + 1 < order.size(); ++before)
	{
		if (before + 1 >= first && before <= last) continue;
		const double there = taken_out + step(order, before, before + 1) - kGain_m;
		const double straight = step(order, before, first) + step(order, last, before + 1);
		const double round = step(order, before, last) + step(order, first, before + 1) + turning;
		if (std::min(straight, round) >= there) continue;
		if (round < straight) std::reverse(at(order, first), at(order, last + 1));
		if (before < first)
			std::rotate(at(order, before + 1), at(order, first), at(order, last + 1));
		else
			std::rotate(at(order, first), at(order, last + 1), at(order, before + 1));
		return true;
	}
	return false;
}

bool TourSearch::moveAny(TourOrder& order, std::size_t length) const
{
	bool better = false;
	for (std::size_t first = 1; first + length < order.size(); ++first)
		better |= moveStretch(order, first, first + length - 1);
	return better;
}

void TourSearch::improve(TourOrder& order) const
{
	for (bool better = true; better;)
	{
		better = reverseAny(order);
		for (std::size_t length = 1; length <= kLongestMove; ++length) better |= moveAny(order, length);
	}
}
}  // namespace explore

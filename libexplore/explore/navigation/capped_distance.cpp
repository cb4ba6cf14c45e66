#include <explore/navigation/capped_distance.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
/** Along each column: rows to the nearest marked cell, at most `limit`. */
std::vector<int> distanceInColumn(std::span<const std::uint8_t> marked, GridSize size, int limit)
{
	const auto columns = static_cast<std::size_t>(size.columns), rows = static_cast<std::size_t>(size.rows);
	std::vector<int> steps(marked.size(), limit);
	const auto relax = [&](std::size_t row, std::size_t before)
	{
		for (std::size_t c = 0; c < columns; ++c)
		{
			int& here = steps[row * columns + c];
			here = std::min(here, steps[before * columns + c] + 1);
		}
	};
	for (std::size_t i = 0; i < marked.size(); ++i)
		if (marked[i] != 0) steps[i] = 0;
	for (std::size_t row = 1; row < rows; ++row) relax(row, row - 1);
	for (std::size_t row = rows; row-- > 1;) relax(row - 1, row);
	return steps;
}
}  // namespace

std::vector<float> cappedDistance(std::span<const std::uint8_t> marked, GridSize size, int limit)
{
	const std::vector<int> steps = distanceInColumn(marked, size, limit);
	std::vector<float> distance(marked.size(), static_cast<float>(limit));
	std::vector<int> squares(static_cast<std::size_t>(size.columns));
	for (int row = 0; row < size.rows; ++row)
	{
		const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(size.columns);
		std::fill(squares.begin(), squares.end(), limit * limit);
		for (int c = 0; c < size.columns; ++c)
		{
			const int there = steps[first + static_cast<std::size_t>(c)];
			if (there >= limit) continue;
			const int from = std::max(0, c - limit), to = std::min(size.columns - 1, c + limit);
			for (int at = from; at <= to; ++at)
			{
				int& square = squares[static_cast<std::size_t>(at)];
				square = std::min(square, there * there + (at - c) * (at - c));
			}
		}
		for (int c = 0; c < size.columns; ++c)
			distance[first + static_cast<std::size_t>(c)] =
			    std::sqrt(static_cast<float>(squares[static_cast<std::size_t>(c)]));
	}
	return distance;
}
}  // namespace explore

#include <explore/navigation/capped_distance.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace explore
{
namespace
{
/** To the nearest of all marked cells, each of them looked at. */
float slowDistance(const std::vector<std::uint8_t>& marked, GridSize size, int limit, int column, int row)
{
	double nearest = limit;
	for (int y = 0; y < size.rows; ++y)
		for (int x = 0; x < size.columns; ++x)
			if (marked[static_cast<std::size_t>(y * size.columns + x)] != 0)
				nearest = std::min(nearest, std::hypot(x - column, y - row));
	return static_cast<float>(nearest);
}

int between(std::mt19937& random, int low, int high)
{
	return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

TEST(CappedDistance, IsThatToTheNearestMarkedCell)
{
	std::mt19937 random(3);
	for (int trial = 0; trial < 300; ++trial)
	{
		const GridSize size{between(random, 1, 30), between(random, 1, 30)};
		const int limit = trial % 10 == 0 ? 127 : between(random, 1, 12);
		const int every = between(random, 2, 80);
		std::vector<std::uint8_t> marked(static_cast<std::size_t>(size.columns * size.rows));
		for (std::uint8_t& cell : marked) cell = random() % static_cast<unsigned>(every) == 0 ? 1 : 0;
		const std::vector<float> distance = cappedDistance(marked, size, limit);
		ASSERT_EQ(distance.size(), marked.size());
		for (int row = 0; row < size.rows; ++row)
			for (int column = 0; column < size.columns; ++column)
				ASSERT_NEAR(distance[static_cast<std::size_t>(row * size.columns + column)],
				            slowDistance(marked, size, limit, column, row), 1e-5F)
				    << "trial " << trial << " at " << column << ", " << row;
	}
}

TEST(CappedDistance, OfNothingMarkedIsTheLimit)
{
	const std::vector<std::uint8_t> nothing(12, 0);
	EXPECT_EQ(cappedDistance(nothing, {4, 3}, 5), std::vector<float>(12, 5.0F));
	EXPECT_TRUE(cappedDistance({}, {0, 0}, 5).empty());
}
}  // namespace
}  // namespace explore

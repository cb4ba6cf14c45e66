#include <explore/core/matching.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>

using namespace explore;

namespace
{
struct Value
{
	std::size_t pairs = 0;
	double distance = 0;
};

bool better(const Value& a, const Value& b)
{
	return a.pairs != b.pairs ? a.pairs > b.pairs : a.distance < b.distance;
}

/** Tries everything. */
Value bestByTrying(const DistanceTable& table)
{
	Value best;
	std::vector<bool> taken(table.columns(), false);
	const std::function<void(std::size_t, Value)> tryRow = [&](std::size_t row, Value so_far)
	{
		if (row == table.rows())
		{
			if (better(so_far, best)) best = so_far;
			return;
		}
		tryRow(row + 1, so_far);
		for (std::size_t column = 0; column < table.columns(); ++column)
		{
			if (taken[column] || !table.at(row, column)) continue;
			taken[column] = true;
			tryRow(row + 1, {so_far.pairs + 1, so_far.distance + *table.at(row, column)});
			taken[column] = false;
		}
	};
	tryRow(0, {});
	return best;
}
}  // namespace

TEST(Matching, IsTheBestOfAllOverRandomTables)
{
	std::mt19937_64 random(11);
	for (int round = 0; round < 3000; ++round)
	{
		DistanceTable table(random() % 6, random() % 6);
		const std::uint64_t share = 1 + random() % 4;
		for (std::size_t i = 0; i < table.rows(); ++i)
			for (std::size_t j = 0; j < table.columns(); ++j)
				if (random() % 4 < share) table.allow(i, j, static_cast<double>(random() % 1000) / 1000.0);
		Value found;
		std::set<std::size_t> used;
		const auto columns = bestMatching(table);
		ASSERT_EQ(columns.size(), table.rows());
		for (std::size_t i = 0; i < columns.size(); ++i)
		{
			if (!columns[i]) continue;
			ASSERT_TRUE(used.insert(*columns[i]).second) << "a column is used twice";
			ASSERT_TRUE(table.at(i, *columns[i])) << "a pair that is not allowed";
			++found.pairs;
			found.distance += *table.at(i, *columns[i]);
		}
		const Value best = bestByTrying(table);
		ASSERT_EQ(found.pairs, best.pairs) << "round " << round;
		ASSERT_NEAR(found.distance, best.distance, 1e-6) << "round " << round;
	}
}

TEST(Matching, PrefersMorePairsToNearerOnes)
{
	DistanceTable table(2, 2);
	table.allow(0, 0, 0.01);
	table.allow(0, 1, 0.29);
	table.allow(1, 0, 0.29);
	const auto columns = bestMatching(table);
	EXPECT_EQ(columns[0], 1U);
	EXPECT_EQ(columns[1], 0U);
}

TEST(Matching, PaysForWhatIsLeftUnpaired)
{
	constexpr double kUnpaired = 0.5;
	std::mt19937_64 random(12);
	for (int round = 0; round < 2000; ++round)
	{
		const std::size_t rows = random() % 5, columns = random() % 5;
		DistanceTable table(rows, columns);
		for (std::size_t i = 0; i < rows; ++i)
			for (std::size_t j = 0; j < columns; ++j)
				if (random() % 3 > 0) table.allow(i, j, static_cast<double>(random() % 1000) / 1000.0);
		const auto cost_of = [&](std::size_t pairs, double distance)
		{ return distance + kUnpaired * static_cast<double>(std::max(rows, columns) - pairs); };

		double least = cost_of(0, 0);
		std::vector<bool> taken(columns, false);
		const std::function<void(std::size_t, std::size_t, double)> try_row =
		    [&](std::size_t row, std::size_t pairs, double distance)
		{
			if (row == rows)
			{
				least = std::min(least, cost_of(pairs, distance));
				return;
			}
			try_row(row + 1, pairs, distance);
			for (std::size_t column = 0; column < columns; ++column)
			{
				if (taken[column] || !table.at(row, column)) continue;
				taken[column] = true;
				try_row(row + 1, pairs + 1, distance + *table.at(row, column));
				taken[column] = false;
			}
		};
		try_row(0, 0, 0);

		std::size_t pairs = 0;
		double distance = 0;
		const auto found = bestMatching(table, kUnpaired);
		for (std::size_t i = 0; i < rows; ++i)
		{
			if (!found[i]) continue;
			++pairs;
			distance += *table.at(i, *found[i]);
			EXPECT_LT(*table.at(i, *found[i]), kUnpaired);
		}
		ASSERT_NEAR(cost_of(pairs, distance), least, 1e-9) << "round " << round;
	}
}

TEST(Matching, DoesNotBreakANearPairToMakeTwo)
{
	DistanceTable table(2, 2);
	table.allow(0, 0, 0.01);
	table.allow(0, 1, 0.29);
	table.allow(1, 0, 0.29);
	const auto columns = bestMatching(table, 0.3);
	EXPECT_EQ(columns[0], 0U);
	EXPECT_FALSE(columns[1]);
}

TEST(Matching, HasNoPairsWithoutRowsOrColumns)
{
	EXPECT_TRUE(bestMatching(DistanceTable(0, 3)).empty());
	EXPECT_EQ(bestMatching(DistanceTable(2, 0)), (std::vector<std::optional<std::size_t>>(2)));
}

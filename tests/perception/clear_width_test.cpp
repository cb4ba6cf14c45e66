#include <explore/perception/clear_width.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

namespace explore
{
namespace
{
/** Moves a disc over a fine grid from before the wall to behind it: slow, and nothing like a chain of hops. */
class DiscWalk
{
public:
	DiscWalk(double width_m, std::vector<Eigen::Vector2d> obstacles)
	    : m_width_m(width_m), m_obstacles(std::move(obstacles))
	{
	}

	[[nodiscard]] bool passes(double diameter_m) const
	{
		std::vector<bool> visited(kCells * kCells, false);
		std::deque<std::pair<int, int>> next;
		for (int i = 0; i < kCells; ++i) enter(i, 0, diameter_m, visited, next);
		while (!next.empty())
		{
			const auto [i, j] = next.front();
			next.pop_front();
			if (j == kCells - 1) return true;
			enter(i + 1, j, diameter_m, visited, next);
			enter(i - 1, j, diameter_m, visited, next);
			enter(i, j + 1, diameter_m, visited, next);
			enter(i, j - 1, diameter_m, visited, next);
		}
		return false;
	}

	[[nodiscard]] double widest() const
	{
		double fits = 0.0, too_wide = m_width_m + 0.1;
		while (too_wide - fits > 0.005)
		{
			const double middle = 0.5 * (fits + too_wide);
			(passes(middle) ? fits : too_wide) = middle;
		}
		return fits;
	}

	static constexpr double kStep_m = 0.02;

private:
	static constexpr int kCells = 200;

	void enter(int i, int j, double diameter_m, std::vector<bool>& visited, std::deque<std::pair<int, int>>& next) const
	{
		if (i < 0 || j < 0 || i >= kCells || j >= kCells) return;
		const auto cell = static_cast<std::size_t>(j * kCells + i);
		if (visited[cell]) return;
		visited[cell] = true;
		const Eigen::Vector2d center(0.5 * m_width_m + (i - kCells / 2) * kStep_m, (j - kCells / 2) * kStep_m);
		const double from_wall = std::min(std::hypot(std::max(0.0, center.x()), center.y()),
		                                  std::hypot(std::max(0.0, m_width_m - center.x()), center.y()));
		double nearest = from_wall;
		for (const auto& obstacle : m_obstacles) nearest = std::min(nearest, (obstacle - center).norm());
		if (2.0 * nearest >= diameter_m) next.emplace_back(i, j);
	}

	double m_width_m;
	std::vector<Eigen::Vector2d> m_obstacles;
};

TEST(ClearWidth, NothingInTheWay)
{
	EXPECT_DOUBLE_EQ(clearWidth(0.9, {}), 0.9);
}

TEST(ClearWidth, LeafLeavesTheSineOfItsAngle)
{
	for (const double angle : {0.3, 0.6, 1.0, 1.4})
	{
		std::vector<Eigen::Vector2d> leaf;
		for (double r = 0.0; r <= 0.9; r += 0.01) leaf.emplace_back(r * std::cos(angle), r * std::sin(angle));
		EXPECT_NEAR(clearWidth(0.9, leaf), 0.9 * std::sin(angle), 0.012) << angle;
	}
}

TEST(ClearWidth, WiderOfTheTwoGapsBesideAPerson)
{
	EXPECT_NEAR(clearWidth(1.2, {{0.4, 0.0}, {0.5, 0.0}, {0.6, 0.0}}), 0.6, 1e-12);
}

TEST(ClearWidth, BackWallOfANicheClosesIt)
{
	std::vector<Eigen::Vector2d> niche;
	for (double x = -0.0; x <= 0.9; x += 0.05) niche.emplace_back(x, 0.4);
	niche.insert(niche.end(), {{0.0, 0.1}, {0.0, 0.2}, {0.0, 0.3}, {0.9, 0.1}, {0.9, 0.2}, {0.9, 0.3}});
	EXPECT_LT(clearWidth(0.9, niche), 0.12);
}

TEST(ClearWidth, EqualsADiscMovedOverAGrid)
{
	std::mt19937 random(7);
	std::uniform_real_distribution<double> unit(0.0, 1.0);
	for (int round = 0; round < 25; ++round)
	{
		const double width_m = 0.6 + 0.8 * unit(random);
		std::vector<Eigen::Vector2d> obstacles(static_cast<std::size_t>(1 + 4 * unit(random)));
		for (auto& obstacle : obstacles) obstacle = {width_m * unit(random), unit(random) - 0.4};
		// The grid's disc moves in steps: it may miss a gap by about a step.
		EXPECT_NEAR(clearWidth(width_m, obstacles), DiscWalk(width_m, obstacles).widest(), 1.5 * DiscWalk::kStep_m)
		    << "round " << round;
	}
}
}  // namespace
}  // namespace explore

#include <explore/simulation/polygon.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace explore::simulation
{
namespace
{
using Outline = std::span<const Eigen::Vector2d>;

/** Twice the area of the triangle; positive when counter-clockwise. */
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
	const Eigen::Vector2d u = b - a, v = c - a;
	return u.x() * v.y() - u.y() * v.x();
}

/** Whether b is (nearly) on the line from a to c, or at one of its ends. */
bool superfluous(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
	constexpr double kTolerance_m = 1e-9;
	return std::abs(turn(a, b, c)) <= kTolerance_m * std::max({(b - a).norm(), (c - b).norm(), kTolerance_m});
}

/** Whether no other corner lies in or on the triangle of three neighbours, and the middle one is convex. */
bool isEar(Outline outline, const std::vector<std::uint32_t>& left, std::size_t middle)
{
	const std::size_t count = left.size(), before = (middle + count - 1) % count, after = (middle + 1) % count;
	const Eigen::Vector2d &a = outline[left[before]], &b = outline[left[middle]], &c = outline[left[after]];
	if (turn(a, b, c) <= 0) return false;
	for (std::size_t i = 0; i < count; ++i)
	{
		const Eigen::Vector2d& p = outline[left[i]];
		if (p == a || p == b || p == c) continue;  // a cut to a hole passes its corners twice
		if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
	}
	return true;
}
/** Whether the open segments a–b and c–d cross, or one ends on the other. */
bool cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d)
{
	if (a == c || a == d || b == c || b == d) return false;
	return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0 &&
	       !(turn(a, b, c) == 0 && turn(a, b, d) == 0);
}

bool crossesAny(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Outline outline)
{
	for (std::size_t i = 0; i < outline.size(); ++i)
		if (cross(a, b, outline[i], outline[(i + 1) % outline.size()])) return true;
	return false;
}

double mostX(Outline outline)
{
	return std::max_element(outline.begin(), outline.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); })
	    ->x();
}

/** Whether the way from corner `i` toward `p` begins inside the outline. Of the two passes of a cut through one corner,
 *  this tells the right one. */
bool beginsInside(Outline outline, std::size_t i, const Eigen::Vector2d& p)
{
	const std::size_t count = outline.size();
	const Eigen::Vector2d &before = outline[(i + count - 1) % count], &corner = outline[i],
	                      &after = outline[(i + 1) % count];
	const bool left_of_both = turn(before, corner, p) >= 0 && turn(corner, after, p) >= 0;
	const bool left_of_one = turn(before, corner, p) >= 0 || turn(corner, after, p) >= 0;
	return turn(before, corner, after) >= 0 ? left_of_both : left_of_one;
}

/** The shortest cut from a corner of `outer` to one of `hole` that crosses nothing. */
std::pair<std::size_t, std::size_t> cutBetween(Outline outer, Outline hole,
                                               const std::vector<std::vector<Eigen::Vector2d>>& others)
{
	std::pair<std::size_t, std::size_t> best{0, 0};
	double shortest = std::numeric_limits<double>::infinity();
	for (std::size_t i = 0; i < outer.size(); ++i)
		for (std::size_t k = 0; k < hole.size(); ++k)
		{
			const double length = (outer[i] - hole[k]).norm();
			const auto blocks = [&](const auto& other) { return crossesAny(outer[i], hole[k], other); };
			if (length >= shortest || !beginsInside(outer, i, hole[k]) || blocks(outer) || blocks(hole)) continue;
			if (std::any_of(others.begin(), others.end(), blocks)) continue;
			shortest = length, best = {i, k};
		}
	return best;
}
}  // namespace

std::vector<Eigen::Vector2d> tidyOutline(Outline outline)
{
	std::vector<Eigen::Vector2d> corners(outline.begin(), outline.end());
	for (std::size_t i = 0, kept = 0; corners.size() >= 3 && kept < corners.size();)
	{
		const std::size_t count = corners.size();
		i %= count;
		if (superfluous(corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count]))
		{
			corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
			i = i > 0 ? i - 1 : corners.size() - 1;  // the one before has a new neighbour
			kept = 0;
		}
		else
			++i, ++kept;
	}
	if (corners.size() < 3) return {};
	double area = 0;
	for (std::size_t i = 1; i + 1 < corners.size(); ++i) area += turn(corners[0], corners[i], corners[i + 1]);
	if (area < 0) std::reverse(corners.begin(), corners.end());
	return corners;
}

bool contains(Outline outline, const Eigen::Vector2d& point)
{
	bool inside = false;
	for (std::size_t i = 0; i < outline.size(); ++i)
	{
		const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
		if ((a.y() > point.y()) == (b.y() > point.y())) continue;
		const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
		if (point.x() < x) inside = !inside;
	}
	return inside;
}

std::vector<Eigen::Vector2d> withHoles(std::vector<Eigen::Vector2d> outer,
                                       std::vector<std::vector<Eigen::Vector2d>> holes)
{
	std::sort(holes.begin(), holes.end(), [](const auto& a, const auto& b) { return mostX(a) < mostX(b); });
	while (!holes.empty())
	{
		std::vector<Eigen::Vector2d> hole = std::move(holes.back());
		holes.pop_back();
		const auto [at, from] = cutBetween(outer, hole, holes);
		// Around the hole clockwise, back to where it began, and back over the cut.
		std::reverse(hole.begin(), hole.end());
		std::rotate(hole.begin(), hole.end() - static_cast<std::ptrdiff_t>(from) - 1, hole.end());
		hole.push_back(hole.front());
		hole.push_back(outer[at]);
		outer.insert(outer.begin() + static_cast<std::ptrdiff_t>(at) + 1, hole.begin(), hole.end());
	}
	return outer;
}

std::vector<std::array<std::uint32_t, 3>> triangulate(Outline outline)
{
	std::vector<std::uint32_t> left(outline.size());
	std::iota(left.begin(), left.end(), 0U);
	std::vector<std::array<std::uint32_t, 3>> triangles;
	while (left.size() >= 3)
	{
		std::size_t ear = 0;
		while (ear < left.size() && !isEar(outline, left, ear)) ++ear;
		if (ear == left.size()) ear = 0;  // crosses itself: go on all the same
		const std::size_t count = left.size();
		triangles.push_back({left[(ear + count - 1) % count], left[ear], left[(ear + 1) % count]});
		left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
	}
	return triangles;
}
}  // namespace explore::simulation

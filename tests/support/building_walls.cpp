#include "support/building_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;

struct Line
{
	bool along_x;
	double at;
	bool operator<(const Line& other) const
	{
		return along_x != other.along_x ? along_x < other.along_x : at < other.at;
	}
};

Line lineAt(bool along_x, double at)
{
	return {along_x, std::round(at * 1e6) / 1e6};
}

/** A wall on an axis line from `from` to `to` with the rooms on its two sides. */
struct Stretch
{
	Line line;
	double from, to;
	int low_side, high_side;  ///< rooms at the smaller and larger coordinate across
};

double low(const Area& area, bool along_x)
{
	return along_x ? area.min().x() : area.min().y();
}
double high(const Area& area, bool along_x)
{
	return along_x ? area.max().x() : area.max().y();
}

/** Every stretch of every room's side, shared ones once. */
std::vector<Stretch> stretchesOf(const Plan& plan)
{
	constexpr double kNothing_m = 1e-4;
	std::vector<Stretch> stretches;
	const int count = static_cast<int>(plan.rooms.size());
	for (int i = 0; i < count; ++i)
		for (const bool along_x : {true, false})
			for (const bool upper : {false, true})
			{
				const Area& mine = plan.rooms[static_cast<std::size_t>(i)].axes;
				const double at = upper ? high(mine, !along_x) : low(mine, !along_x);
				std::vector<std::pair<double, double>> shared;
				for (int k = 0; k < count; ++k)
				{
					const Area& other = plan.rooms[static_cast<std::size_t>(k)].axes;
					const double other_at = upper ? low(other, !along_x) : high(other, !along_x);
					const double from = std::max(low(mine, along_x), low(other, along_x));
					const double to = std::min(high(mine, along_x), high(other, along_x));
					if (k == i || std::abs(other_at - at) > kNothing_m || to - from < kNothing_m) continue;
					shared.emplace_back(from, to);
					if (upper) stretches.push_back({lineAt(along_x, at), from, to, i, k});
				}
				std::sort(shared.begin(), shared.end());
				shared.emplace_back(high(mine, along_x), high(mine, along_x));
				double from = low(mine, along_x);
				for (const auto& [next_from, next_to] : shared)
				{
					if (next_from - from > kNothing_m)
						stretches.push_back({lineAt(along_x, at), from, next_from, upper ? i : -1, upper ? -1 : i});
					from = std::max(from, next_to);
				}
			}
	return stretches;
}

bool isCorridor(const Plan& plan, int room)
{
	return room >= 0 && plan.rooms[static_cast<std::size_t>(room)].use == Use::corridor;
}
}  // namespace

void raiseWalls(Plan& plan, Dice& dice)
{
	const std::vector<Stretch> stretches = stretchesOf(plan);
	std::map<Line, double> thickness;
	for (const Stretch& stretch : stretches)
	{
		double& wall_m = thickness[stretch.line];
		double wanted = plan.inner_m * dice.between(0.9, 1.3);
		if (isCorridor(plan, stretch.low_side) || isCorridor(plan, stretch.high_side)) wanted = plan.corridor_m;
		if (stretch.low_side < 0 || stretch.high_side < 0) wanted = plan.outer_m;
		wall_m = std::max(wall_m, wanted);
	}
	const auto half_at = [&](const Line& line)
	{
		const auto found = thickness.find(line);
		return found == thickness.end() ? 0.0 : 0.5 * found->second;
	};
	for (const Stretch& stretch : stretches)
	{
		BuildingWall wall;
		const bool along_x = stretch.line.along_x;
		const Vector2d from =
		    along_x ? Vector2d(stretch.from, stretch.line.at) : Vector2d(stretch.line.at, stretch.from);
		wall.frame = {{from, along_x ? 0.0 : std::numbers::pi / 2}, thickness[stretch.line], plan.height_m};
		wall.length_m = stretch.to - stretch.from;
		wall.from_m = half_at(lineAt(!along_x, stretch.from));
		wall.to_m = wall.length_m - half_at(lineAt(!along_x, stretch.to));
		wall.left = along_x ? stretch.high_side : stretch.low_side;
		wall.right = along_x ? stretch.low_side : stretch.high_side;
		plan.walls.push_back(std::move(wall));
	}
	for (Room& room : plan.rooms)
	{
		room.inside = room.axes;
		room.inside.min() +=
		    Vector2d(half_at(lineAt(false, room.axes.min().x())), half_at(lineAt(true, room.axes.min().y())));
		room.inside.max() -=
		    Vector2d(half_at(lineAt(false, room.axes.max().x())), half_at(lineAt(true, room.axes.max().y())));
	}
}
}  // namespace explore::test

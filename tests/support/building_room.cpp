#include "support/building_room.h"

#include <cmath>
#include <numbers>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;

constexpr double kApart_m = 0.02;  ///< of things at a wall
constexpr double kGap_m = 0.01;    ///< between them and the wall
}  // namespace

bool RoomSpace::take(const Area& area, double apart_m)
{
	Area wider = area;
	wider.min() -= Vector2d(apart_m, apart_m);
	wider.max() += Vector2d(apart_m, apart_m);
	if (!room.inside.contains(area)) return false;
	for (const Area& taken : room.taken)
		if (taken.intersects(wider)) return false;
	room.taken.push_back(area);
	return true;
}

bool RoomSpace::atWall(const PlanSize& size, const Build& build)
{
	for (int trial = 0; trial < 12; ++trial)
	{
		const int side = dice.whole(0, 3);
		const int axis = side < 2 ? 0 : 1;  // across the wall
		const double wall = room.inside.sizes()[1 - axis];
		if (wall < size.y() + 0.1) continue;
		const double off = dice.between(0.5 * size.y() + 0.02, wall - 0.5 * size.y() - 0.02);
		const double deep = 0.5 * size.x() + kGap_m;
		Vector2d at;
		at[1 - axis] = room.inside.min()[1 - axis] + off;
		at[axis] = side % 2 == 0 ? room.inside.min()[axis] + deep : room.inside.max()[axis] - deep;
		const double yaw = (axis == 0 ? 0 : std::numbers::pi / 2) + (side % 2 == 0 ? 0 : std::numbers::pi);
		Vector2d half;
		half[axis] = 0.5 * size.x();
		half[1 - axis] = 0.5 * size.y();
		if (!take(Area(Vector2d(at - half), Vector2d(at + half)), kApart_m)) continue;
		build({at, yaw});
		return true;
	}
	return false;
}

bool RoomSpace::free(const PlanSize& size, const Build& build, double from_wall_m, bool turned)
{
	for (int trial = 0; trial < 12; ++trial)
	{
		const double yaw = turned ? dice.between(0, 2 * std::numbers::pi) : dice.whole(0, 3) * std::numbers::pi / 2;
		const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
		const Vector2d half(0.5 * (c * size.x() + s * size.y()), 0.5 * (s * size.x() + c * size.y()));
		const Vector2d low = room.inside.min() + half + Vector2d(from_wall_m, from_wall_m);
		const Vector2d high = room.inside.max() - half - Vector2d(from_wall_m, from_wall_m);
		if ((high - low).minCoeff() < 0) continue;
		const Vector2d at(dice.between(low.x(), high.x()), dice.between(low.y(), high.y()));
		if (!take(Area(Vector2d(at - half), Vector2d(at + half)), 0.05)) continue;
		build({at, yaw});
		return true;
	}
	return false;
}
}  // namespace explore::test

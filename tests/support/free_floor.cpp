#include "support/free_floor.h"

#include <cmath>
#include <deque>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kCell_m = 0.10;
constexpr double kThin_m = 0.15;  ///< of the body that finds its way from the spawns
}  // namespace

FreeFloor::FreeFloor(const simulation::RayScene& scene) : m_scene(scene)
{
	for (const simulation::Spawn& spawn : scene.world().spawns) spread(spawn.position_in_map.head<2>());
	for (const auto& [cell, reached] : m_cells)
		if (reached) m_reached.push_back(cell);
}

bool FreeFloor::reached(const Vector2d& at) const
{
	const auto found = m_cells.find(cellOf(at));
	return found != m_cells.end() && found->second;
}

Vector2d FreeFloor::draw(Dice& dice) const
{
	const auto [column, row] =
	    m_reached[static_cast<std::size_t>(dice.whole(0, static_cast<int>(m_reached.size()) - 1))];
	return Vector2d(column + dice.between(-0.5, 0.5), row + dice.between(-0.5, 0.5)) * kCell_m;
}

FreeFloor::Cell FreeFloor::cellOf(const Vector2d& at)
{
	return {static_cast<int>(std::lround(at.x() / kCell_m)), static_cast<int>(std::lround(at.y() / kCell_m))};
}

bool FreeFloor::isFree(const Cell& cell) const
{
	const Vector3d at(cell.first * kCell_m, cell.second * kCell_m, 0);
	const auto floor = m_scene.cast(at + Vector3d(0, 0, 0.3), -Vector3d::UnitZ(), 0.35);
	return floor && floor->distance > 0.26 && !m_scene.touchesCylinder(at + Vector3d(0, 0, 0.05), kThin_m, 1.2);
}

bool FreeFloor::visit(const Cell& cell)
{
	const auto [entry, fresh] = m_cells.try_emplace(cell, false);
	if (fresh) entry->second = isFree(cell);
	return fresh && entry->second;
}

std::optional<FreeFloor::Cell> FreeFloor::startNear(const Vector2d& from)
{
	const Cell middle = cellOf(from);
	// Furniture may stand in the middle of the room.
	for (int reach = 0; reach < 12; ++reach)
		for (int i = -reach; i <= reach; ++i)
			for (int k = -reach; k <= reach; ++k)
			{
				const Cell cell(middle.first + i, middle.second + k);
				const auto known = m_cells.find(cell);
				if (known != m_cells.end() && known->second) return std::nullopt;
				if (visit(cell)) return cell;
			}
	return std::nullopt;
}

void FreeFloor::spread(const Vector2d& from)
{
	std::deque<Cell> open;
	if (const auto start = startNear(from)) open.push_back(*start);
	while (!open.empty())
	{
		const Cell cell = open.front();
		open.pop_front();
		for (const auto& [dx, dy] : {Cell(1, 0), Cell(-1, 0), Cell(0, 1), Cell(0, -1)})
			if (const Cell next(cell.first + dx, cell.second + dy); visit(next)) open.push_back(next);
	}
}
}  // namespace explore::test

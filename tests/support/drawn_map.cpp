#include "support/drawn_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace explore::test
{
namespace
{
constexpr double kCell_m = 0.05;
/** Heights of voxels, in voxels above the floor: one that the ground robot's body meets, one well below the floor. */
constexpr int kBody = 6, kDeep = -6;
/** A MAV's flight band and what its body covers above and below. */
constexpr int kLowest = 0, kHighest = 48;

bool isUnknown(char character)
{
	return character == '?' || character == ' ';
}

VoxelState stateOf(char character)
{
	if (isUnknown(character) || character == 'v') return VoxelState::unknown;
	return character == '#' ? VoxelState::occupied : VoxelState::free;
}

/** What a character says of the voxels in one of its cells. */
void addCell(std::vector<VoxelChange>& changes, const Eigen::Vector2i& cell, char before, char after, RobotKind kind)
{
	const auto key = [&](int z)
	{
		const auto number = [](int i) { return static_cast<octomap::key_type>(kOriginKey + i); };
		return octomap::OcTreeKey(number(cell.x()), number(cell.y()), number(z));
	};
	const bool flies = kind == RobotKind::mav;
	for (int z = flies ? kLowest : kBody; z <= (flies ? kHighest : kBody); ++z)
		changes.push_back({key(z), stateOf(before), stateOf(after)});
	const auto deep = [](char character) { return character == 'v' ? VoxelState::free : VoxelState::unknown; };
	changes.push_back({key(kDeep), deep(before), deep(after)});
}
}  // namespace

DrawnMap::DrawnMap(std::vector<std::string> rows, double character_m)
    : m_rows(rows.rbegin(), rows.rend()), m_character_m(character_m)
{
	std::size_t longest = 0;
	for (const std::string& row : m_rows) longest = std::max(longest, row.size());
	for (std::string& row : m_rows) row.resize(longest, '?');
}

int DrawnMap::columns() const
{
	return m_rows.empty() ? 0 : static_cast<int>(m_rows.front().size());
}

char DrawnMap::character(int column, int row) const
{
	return m_rows.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column));
}

void DrawnMap::set(int column, int row, char character)
{
	m_rows.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column)) = character;
}

void DrawnMap::show(const Eigen::Vector2d& point_in_map, char character)
{
	const Eigen::Vector2i place = (point_in_map / m_character_m).array().floor().cast<int>();
	set(place.x(), place.y(), character);
}

DrawnMap DrawnMap::with(int column, int row, char character) const
{
	DrawnMap changed = *this;
	changed.set(column, row, character);
	return changed;
}

double DrawnMap::distanceTo(int column, int row, const Eigen::Vector3d& point_in_map) const
{
	const Eigen::Array2d off = (point_in_map - middleOf(column, row)).head<2>().array().abs() - 0.5 * m_character_m;
	return off.max(0.0).matrix().norm();
}

Eigen::Vector3d DrawnMap::middleOf(int column, int row) const
{
	return {m_character_m * (column + 0.5), m_character_m * (row + 0.5), 0.0};
}

Eigen::Vector3d DrawnMap::at(char mark) const
{
	for (int row = 0; row < rows(); ++row)
		for (int column = 0; column < columns(); ++column)
			if (character(column, row) == mark) return middleOf(column, row);
	throw std::out_of_range(std::string("nothing is marked ") + mark);
}

char DrawnMap::on(const Eigen::Vector2d& point_in_map) const
{
	const auto number = [&](double along_m) { return static_cast<int>(std::floor(along_m / m_character_m)); };
	const int column = number(point_in_map.x()), row = number(point_in_map.y());
	if (column < 0 || column >= columns() || row < 0 || row >= rows()) return '?';
	return character(column, row);
}

std::vector<VoxelChange> DrawnMap::changesSince(const DrawnMap& before, RobotKind kind) const
{
	const int wide = static_cast<int>(std::lround(m_character_m / kCell_m));
	std::vector<VoxelChange> changes;
	for (int row = 0; row < rows(); ++row)
		for (int column = 0; column < columns(); ++column)
		{
			const char was = before.character(column, row), is = character(column, row);
			if (was == is) continue;
			for (int y = row * wide; y < (row + 1) * wide; ++y)
				for (int x = column * wide; x < (column + 1) * wide; ++x) addCell(changes, {x, y}, was, is, kind);
		}
	return changes;
}

std::vector<VoxelChange> DrawnMap::changes(RobotKind kind) const
{
	DrawnMap empty = *this;
	for (std::string& row : empty.m_rows) std::ranges::fill(row, '?');
	return changesSince(empty, kind);
}

BodyLayers layersOf(const DrawnMap& map, const RobotConfig& robot)
{
	BodyLayers layers({}, robot, kCell_m);
	layers.update(map.changes(robot.kind));
	return layers;
}

FrontierMemory memoryOf(const DrawnMap& map, const RobotConfig& robot)
{
	FrontierMemory memory({}, robot);
	memory.layers.update(map.changes(robot.kind));
	memory.frontiers.update(memory.layers);
	return memory;
}

void change(FrontierMemory& memory, const DrawnMap& before, const DrawnMap& after, const RobotConfig& robot)
{
	memory.layers.update(after.changesSince(before, robot.kind));
	memory.frontiers.update(memory.layers);
}
}  // namespace explore::test

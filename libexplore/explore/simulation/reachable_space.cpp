#include <explore/simulation/cell_spread.h>
#include <explore/simulation/plan_triangle.h>
#include <explore/simulation/reachable_space.h>
#include <explore/simulation/robot_body.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace explore::simulation
{
namespace
{
constexpr double kMargin_m = 0.05, kBumps_m = 0.10, kFloorStep_m = 0.05;

using Allows = std::function<bool(const Eigen::Vector2d& point_in_map)>;

/** The space while it is being found: which cells have no room or floor, then which of the others are connected. */
class Search
{
public:
	Search(const World& world, const RobotConfig& robot, Eigen::Vector3d start);
	TruthReach run(const Allows& allows);

private:
	/** What stands between these heights is in the way of a body in the level. */
	struct Body
	{
		double low_m, high_m;
	};
	void addGroundLevel();
	void addFlightLevels();
	void blockBy(const Triangle& triangle);
	void blockWithoutFloor();
	void blockWhereNot(const Allows& allows);
	[[nodiscard]] CellBytes floorCells() const;
	/** Every cell of the plan whose middle is less than `margin_m` from the triangle's box: visit(index, middle). */
	template <class Visit>
	void forEachCellNear(const Triangle& triangle, double margin_m, const Visit& visit) const;

	const World& m_world;
	RobotConfig m_robot;
	Eigen::Vector3d m_start;
	TruthReach m_reach;
	std::vector<Body> m_bodies;        ///< one a level
	std::vector<CellBytes> m_blocked;  ///< one a level
};

Search::Search(const World& world, const RobotConfig& robot, Eigen::Vector3d start)
    : m_world(world), m_robot(robot), m_start(std::move(start))
{
	const Eigen::AlignedBox3d solid = solidBounds(world).cast<double>();
	if (solid.isEmpty()) return;
	// The cells whose middle is inside.
	const Eigen::Vector2d low = solid.min().head<2>() / m_reach.cell_m, high = solid.max().head<2>() / m_reach.cell_m;
	m_reach.first_column = static_cast<int>(std::ceil(low.x() - 0.5));
	m_reach.first_row = static_cast<int>(std::ceil(low.y() - 0.5));
	m_reach.columns = std::max(0, static_cast<int>(std::floor(high.x() - 0.5)) - m_reach.first_column + 1);
	m_reach.rows = std::max(0, static_cast<int>(std::floor(high.y() - 0.5)) - m_reach.first_row + 1);
}

TruthReach Search::run(const Allows& allows)
{
	if (m_robot.kind == RobotKind::ground)
		addGroundLevel();
	else
		addFlightLevels();
	const CellBytes none(static_cast<std::size_t>(m_reach.columns) * static_cast<std::size_t>(m_reach.rows));
	m_blocked.assign(m_bodies.size(), none);
	for (TruthReach::Level& level : m_reach.levels) level.reachable = none;
	forEachTriangle(m_world, [this](const Triangle& triangle) { blockBy(triangle); });
	if (m_robot.kind == RobotKind::ground) blockWithoutFloor();
	if (allows) blockWhereNot(allows);
	spread(m_reach, std::move(m_blocked), m_start);
	return std::move(m_reach);
}

void Search::addGroundLevel()
{
	const VerticalCylinder body = bodyAt(m_robot, m_start);
	m_bodies.push_back({body.base.z(), body.base.z() + body.height_m});
	m_reach.levels.push_back({m_start.z() + kBumps_m, m_start.z() + m_robot.height_m, {}});
}

void Search::addFlightLevels()
{
	const double floor_m = surfaceBelow(m_world, m_start).value_or(0.0), cell_m = m_reach.cell_m;
	const int first = static_cast<int>(std::ceil((floor_m + m_robot.min_altitude_m) / cell_m - 0.5));
	const int last = static_cast<int>(std::floor((floor_m + m_robot.max_altitude_m) / cell_m - 0.5));
	for (int level = first; level <= last; ++level)
	{
		const VerticalCylinder body = bodyWithMargin(m_robot, {0.0, 0.0, (level + 0.5) * cell_m}, kMargin_m);
		m_bodies.push_back({body.base.z(), body.base.z() + body.height_m});
		m_reach.levels.push_back({level * cell_m, (level + 1) * cell_m, {}});
	}
}

template <class Visit>
void Search::forEachCellNear(const Triangle& triangle, double margin_m, const Visit& visit) const
{
	Eigen::AlignedBox2d box;
	for (const Eigen::Vector3d& corner : triangle) box.extend(corner.head<2>());
	const auto first = [&](double low_m, int offset)
	{ return std::max(0.0, std::ceil((low_m - margin_m) / m_reach.cell_m - 0.5) - offset); };
	const auto last = [&](double high_m, int offset, int count)
	{ return std::min(count - 1.0, std::floor((high_m + margin_m) / m_reach.cell_m - 0.5) - offset); };
	const auto last_row = last(box.max().y(), m_reach.first_row, m_reach.rows);
	const auto last_column = last(box.max().x(), m_reach.first_column, m_reach.columns);
	for (double row = first(box.min().y(), m_reach.first_row); row <= last_row; ++row)
		for (double column = first(box.min().x(), m_reach.first_column); column <= last_column; ++column)
		{
			const int i = static_cast<int>(column), j = static_cast<int>(row);
			visit(planIndex(m_reach, i, j), m_reach.centerOf(i, j));
		}
}

void Search::blockBy(const Triangle& triangle)
{
	if (m_bodies.empty()) return;
	const auto [low, high] = std::minmax({triangle[0].z(), triangle[1].z(), triangle[2].z()});
	if (high < m_bodies.front().low_m || low > m_bodies.back().high_m) return;
	const PlanTriangle plan(triangle);
	const double radius_m = m_robot.radius_m + kMargin_m;
	forEachCellNear(triangle, radius_m,
	                [&](std::size_t cell, const Eigen::Vector2d& middle)
	                {
		                const auto heights = plan.within(middle, radius_m);
		                if (!heights) return;
		                for (std::size_t i = 0; i < m_bodies.size(); ++i)
			                if (heights->low_m <= m_bodies[i].high_m && heights->high_m >= m_bodies[i].low_m)
				                m_blocked[i][cell] = 1;
	                });
}

CellBytes Search::floorCells() const
{
	CellBytes floor(m_blocked.front().size());
	forEachTriangle(m_world,
	                [&](const Triangle& triangle)
	                {
		                const double low_m = m_start.z() - kFloorStep_m, high_m = m_bodies.front().low_m;
		                const auto [low, high] = std::minmax({triangle[0].z(), triangle[1].z(), triangle[2].z()});
		                if (high < low_m || low > high_m) return;
		                const PlanTriangle plan(triangle);
		                forEachCellNear(triangle, 0.0,
		                                [&](std::size_t cell, const Eigen::Vector2d& middle)
		                                {
			                                const auto at = plan.within(middle, 0.0);
			                                if (at && at->high_m >= low_m && at->high_m <= high_m) floor[cell] = 1;
		                                });
	                });
	return floor;
}

void Search::blockWithoutFloor()
{
	if (m_blocked.front().empty()) return;
	const CellBytes floor = floorCells();
	const auto has_floor = [&](const Eigen::Vector2d& place)
	{
		const ReachCell cell = cellAt(m_reach, {place.x(), place.y(), m_start.z()});
		return !isInside(m_reach, cell) || floor[planIndex(m_reach, cell.column, cell.row)] != 0;
	};
	if (!has_floor(m_start.head<2>())) return;
	constexpr int kRim = 8;
	for (int row = 0; row < m_reach.rows; ++row)
		for (int column = 0; column < m_reach.columns; ++column)
		{
			const Eigen::Vector2d middle = m_reach.centerOf(column, row);
			bool stands = has_floor(middle);
			for (int i = 0; i < kRim && stands; ++i)
			{
				const double angle_rad = 2.0 * std::numbers::pi * i / kRim;
				stands =
				    has_floor(middle + m_robot.radius_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
			}
			if (!stands) m_blocked.front()[planIndex(m_reach, column, row)] = 1;
		}
}

void Search::blockWhereNot(const Allows& allows)
{
	for (int row = 0; row < m_reach.rows; ++row)
		for (int column = 0; column < m_reach.columns; ++column)
			if (!allows(m_reach.centerOf(column, row)))
				for (CellBytes& blocked : m_blocked) blocked[planIndex(m_reach, column, row)] = 1;
}
}  // namespace

TruthReach reachableSpace(const World& world, const RobotConfig& robot, const Eigen::Vector3d& start_in_map,
                          const Allows& allows)
{
	return Search(world, robot, start_in_map).run(allows);
}
}  // namespace explore::simulation

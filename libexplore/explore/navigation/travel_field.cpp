#include <explore/navigation/travel_field.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace explore
{
namespace
{
/** Cost of a step to the next column in the open. A diagonal one costs 14 of these tenths: 1 % less than √2. */
constexpr std::uint32_t kStep = 10, kDiagonal = 14;
/** Of a cell that is left only because the robot stands there: so many times as dear. */
constexpr double kEscape = 5.0;
/** Of a cell where the robot was stopped lately. */
constexpr double kBlocked = 20.0;
/** A metre up or down is worth so many on the level: what is below and above is seen from afar. */
constexpr double kClimb = 1.5;
/** A straight cut replaces at most so many cells. */
constexpr std::size_t kLongestCut = 200;

struct Step
{
	Eigen::Array3i by;
	std::uint32_t cost;
};

std::vector<Step> stepsOf(const LayerFrame& frame)
{
	std::vector<Step> steps;
	for (int dy = -1; dy <= 1; ++dy)
		for (int dx = -1; dx <= 1; ++dx)
			if (dx != 0 || dy != 0) steps.push_back({{dx, dy, 0}, dx != 0 && dy != 0 ? kDiagonal : kStep});
	if (frame.altitudes_m.size() < 2) return steps;
	const double rise_m = frame.altitudes_m[1] - frame.altitudes_m[0];
	const auto climb = static_cast<std::uint32_t>(std::lround(kStep * kClimb * rise_m / frame.resolution_m));
	steps.push_back({{0, 0, 1}, climb});
	steps.push_back({{0, 0, -1}, climb});
	return steps;
}

/** How many times as dear as in the open each cell is; 0 = no way. */
class CellWeights
{
public:
	CellWeights(const PlanMap& map, CellIndex start, const RobotConfig& robot, const PlanConfig& config)
	    : m_map(&map),
	      m_start(map.placeOf(start)),
	      m_escape_cells(robot.radius_m / map.frame.resolution_m),
	      m_least_m(robot.radius_m + config.squeeze_m),
	      m_comfort_m(std::max(config.comfort_m, m_least_m + map.frame.resolution_m)),
	      m_extra(config.clearance_cost)
	{
	}

	[[nodiscard]] double of(CellIndex cell, const Eigen::Array3i& place) const
	{
		if (m_map->passable[cell] == 0) return mayEscape(cell, place) ? kEscape : 0.0;
		if (m_map->blocked[cell] != 0) return kBlocked;
		const double near = (m_comfort_m - m_map->obstacle_m[cell]) / (m_comfort_m - m_least_m);
		return 1.0 + m_extra * std::clamp(near, 0.0, 1.0);
	}

private:
	[[nodiscard]] bool mayEscape(CellIndex cell, const Eigen::Array3i& place) const
	{
		const Eigen::Array3i off = place - m_start;
		if (off.z() != 0 || m_map->cells[cell] != CellState::free) return false;
		return off.head<2>().cast<double>().matrix().norm() <= m_escape_cells;
	}

	const PlanMap* m_map;
	Eigen::Array3i m_start;
	double m_escape_cells, m_least_m, m_comfort_m, m_extra;
};

/** A ring of buckets: the costs that are open lie within one step of each other. */
class BucketQueue
{
public:
	explicit BucketQueue(std::uint32_t dearest_step) : m_buckets(dearest_step + 1) {}

	void push(CellIndex cell, std::uint32_t cost)
	{
		m_buckets[cost % m_buckets.size()].push_back({cell, cost});
		++m_count;
	}
	/** The cheapest; the queue must not be empty. */
	std::pair<CellIndex, std::uint32_t> pop()
	{
		while (m_buckets[m_at % m_buckets.size()].empty()) ++m_at;
		auto& bucket = m_buckets[m_at % m_buckets.size()];
		const auto first = bucket.back();
		bucket.pop_back();
		--m_count;
		return first;
	}
	[[nodiscard]] bool empty() const { return m_count == 0; }

private:
	std::vector<std::vector<std::pair<CellIndex, std::uint32_t>>> m_buckets;
	std::uint32_t m_at = 0;
	std::size_t m_count = 0;
};

/** The cells whose costs are still asked for. */
class Ends
{
public:
	explicit Ends(std::vector<CellIndex> cells) : m_cells(std::move(cells))
	{
		std::sort(m_cells.begin(), m_cells.end());
		m_cells.erase(std::unique(m_cells.begin(), m_cells.end()), m_cells.end());
	}
	/** Whether `cell` was the last of them; each comes once. */
	bool lastOne(CellIndex cell)
	{
		const auto found = std::lower_bound(m_cells.begin(), m_cells.end(), cell);
		if (found == m_cells.end() || *found != cell) return false;
		m_cells.erase(found);
		return m_cells.empty();
	}

private:
	std::vector<CellIndex> m_cells;
};

std::uint32_t dearestStep(const std::vector<Step>& steps, const PlanConfig& config)
{
	std::uint32_t dearest = 0;
	for (const Step& step : steps) dearest = std::max(dearest, step.cost);
	return static_cast<std::uint32_t>(std::ceil(dearest * std::max({1.0 + config.clearance_cost, kEscape, kBlocked})));
}
}  // namespace

std::vector<CellIndex> TravelField::wayTo(CellIndex cell) const
{
	std::vector<CellIndex> way;
	if (!reaches(cell)) return way;
	for (; from[cell] != cell; cell = from[cell]) way.push_back(cell);
	way.push_back(cell);
	std::reverse(way.begin(), way.end());
	return way;
}

TravelField travelFrom(const PlanMap& map, CellIndex start, const RobotConfig& robot, const PlanConfig& config)
{
	return travelBetween(map, start, {}, robot, config);
}

TravelField travelBetween(const PlanMap& map, CellIndex start, const std::vector<CellIndex>& ends,
                          const RobotConfig& robot, const PlanConfig& config)
{
	TravelField field;
	field.cost_per_m = kStep / map.frame.resolution_m;
	field.cost.assign(map.cells.size(), kUnreached);
	field.from.assign(map.cells.size(), kNoCell);
	if (start == kNoCell) return field;
	const std::vector<Step> steps = stepsOf(map.frame);
	const CellWeights weights(map, start, robot, config);
	BucketQueue queue(dearestStep(steps, config));
	Ends open_ends(ends);
	field.start = start;
	field.cost[start] = 0;
	field.from[start] = start;
	queue.push(start, 0);
	while (!queue.empty())
	{
		const auto [cell, cost] = queue.pop();
		if (cost > field.cost[cell]) continue;
		if (open_ends.lastOne(cell)) break;
		const Eigen::Array3i place = map.placeOf(cell);
		for (const Step& step : steps)
		{
			const Eigen::Array3i next_place = place + step.by;
			if (!map.contains(next_place)) continue;
			const CellIndex next = map.cellAt(next_place);
			const double weight = weights.of(next, next_place);
			if (weight == 0.0) continue;
			const std::uint32_t next_cost = cost + static_cast<std::uint32_t>(std::lround(step.cost * weight));
			if (next_cost >= field.cost[next]) continue;
			field.cost[next] = next_cost;
			field.from[next] = cell;
			queue.push(next, next_cost);
		}
	}
	return field;
}

std::vector<Eigen::Vector3d> shortenedWay(const PlanMap& map, const TravelField& field, CellIndex cell,
                                          const PlanConfig& config)
{
	const std::vector<CellIndex> way = field.wayTo(cell);
	std::vector<Eigen::Vector3d> corners;
	if (way.empty()) return corners;
	corners.push_back(map.middleOf(way.front()));
	for (std::size_t at = 0; at + 1 < way.size();)
	{
		std::size_t next = at + 1;
		double clearance_m = std::min<double>(map.obstacle_m[way[at]], config.comfort_m);
		for (std::size_t i = at + 1; i < std::min(way.size(), at + kLongestCut); ++i)
		{
			clearance_m = std::min<double>(clearance_m, map.obstacle_m[way[i]]);
			if (straightWayIsFree(map, way[at], way[i], clearance_m)) next = i;
		}
		corners.push_back(map.middleOf(way[next]));
		at = next;
	}
	return corners;
}

double lengthOf(const std::vector<Eigen::Vector3d>& way)
{
	double length_m = 0.0;
	for (std::size_t i = 1; i < way.size(); ++i) length_m += (way[i] - way[i - 1]).norm();
	return length_m;
}
}  // namespace explore

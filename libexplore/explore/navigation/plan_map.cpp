#include <explore/navigation/capped_distance.h>
#include <explore/navigation/plan_map.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace explore
{
namespace
{
/** Half the edge of a blocked spot. */
constexpr double kBlocked_m = 0.15;
/** Stopped so often within that distance the robot cannot pass: half the edge of what is barred then. */
constexpr std::ptrdiff_t kBarredAfter = 3;
constexpr double kSameSpot_m = 0.6, kBarred_m = 0.3;
/** Half the width of the robot's trail, and the share of its radius that must be free around it still. */
constexpr double kTrail_m = 0.05, kTrailFit = 0.75;

bool isObstacle(CellState state)
{
	return state == CellState::occupied || state == CellState::drop;
}

/** Distances [m] in each layer to the marked cells. */
std::vector<float> distances(const PlanMap& map, const std::vector<std::uint8_t>& marked, double limit_m)
{
	const GridSize size{map.frame.columns, map.frame.rows};
	// A cell more: what is capped must not fall short of the limit by rounding.
	const int limit = std::clamp(static_cast<int>(std::ceil(limit_m / map.frame.resolution_m)) + 1, 1, 127);
	std::vector<float> all;
	all.reserve(marked.size());
	for (std::size_t first = 0; first < marked.size(); first += map.frame.cellsInLayer())
		for (const float cells :
		     cappedDistance(std::span(marked).subspan(first, map.frame.cellsInLayer()), size, limit))
			all.push_back(cells * static_cast<float>(map.frame.resolution_m));
	return all;
}

std::vector<std::uint8_t> obstacles(const PlanMap& map)
{
	std::vector<std::uint8_t> marked(map.cells.size(), 0);
	std::transform(map.cells.begin(), map.cells.end(), marked.begin(),
	               [](CellState state) { return isObstacle(state) ? 1 : 0; });
	return marked;
}

/** Unknown cells beside free ones: others lie behind what stands there. */
std::vector<std::uint8_t> edgesOfUnknown(const PlanMap& map)
{
	std::vector<std::uint8_t> marked(map.cells.size(), 0);
	for (std::size_t i = 0; i < map.cells.size(); ++i)
	{
		if (map.cells[i] != CellState::free) continue;
		forEachBeside(map, static_cast<CellIndex>(i),
		              [&](CellIndex next) { marked[next] |= map.cells[next] == CellState::unknown ? 1 : 0; });
	}
	return marked;
}

void markAllowed(PlanMap& map, const AllowedArea& area)
{
	map.allowed.assign(map.cells.size(), 1);
	if (!area.bounded && area.keep_out.empty()) return;
	for (std::size_t i = 0; i < map.cells.size(); ++i)
		map.allowed[i] = area.allows(map.middleOf(static_cast<CellIndex>(i)).head<2>()) ? 1 : 0;
}

/** The cells of a square in the layer, half its edge `reach_m`; none for kNoCell. */
template <class Visit>
void forEachAround(const PlanMap& map, CellIndex middle, double reach_m, const Visit& visit)
{
	if (middle == kNoCell) return;
	const int reach = static_cast<int>(std::lround(reach_m / map.frame.resolution_m));
	for (int dy = -reach; dy <= reach; ++dy)
		for (int dx = -reach; dx <= reach; ++dx)
			if (const Eigen::Array3i place = map.placeOf(middle) + Eigen::Array3i(dx, dy, 0); map.contains(place))
				visit(map.cellAt(place));
}

/** Where the robot has been it fits, even though things may seem to have come a little nearer since. */
void markTrail(PlanMap& map, const std::vector<Eigen::Vector3d>& trail_in_map, double radius_m)
{
	for (const Eigen::Vector3d& at : trail_in_map)
		forEachAround(map, map.cellOf(at), kTrail_m,
		              [&](CellIndex cell)
		              {
			              const bool fits = map.obstacle_m[cell] >= kTrailFit * radius_m;
			              if (fits && map.allowed[cell] != 0 && map.cells[cell] == CellState::free)
				              map.passable[cell] = 1;
		              });
}

/** Where the robot was stopped a way is dear; where it was stopped again and again there is none for now: whoever
 *  stands there waits for the robot to go. */
void markBlocked(PlanMap& map, const std::vector<Eigen::Vector3d>& spots_in_map)
{
	map.blocked.assign(map.cells.size(), 0);
	for (const Eigen::Vector3d& spot : spots_in_map)
	{
		forEachAround(map, map.cellOf(spot), kBlocked_m, [&](CellIndex cell) { map.blocked[cell] = 1; });
		const auto times =
		    std::count_if(spots_in_map.begin(), spots_in_map.end(),
		                  [&](const Eigen::Vector3d& other) { return (other - spot).norm() < kSameSpot_m; });
		if (times >= kBarredAfter)
			forEachAround(map, map.cellOf(spot), kBarred_m, [&](CellIndex cell) { map.passable[cell] = 0; });
	}
}

/** The cells that are joined to any of `starts` by cells that `is` holds of, themselves included. */
template <class Is>
std::vector<std::uint8_t> joinedTo(const PlanMap& map, const std::vector<CellIndex>& starts, const Is& is)
{
	std::vector<std::uint8_t> reached(map.cells.size(), 0);
	std::vector<CellIndex> open = starts;
	for (const CellIndex cell : starts) reached[cell] = 1;
	while (!open.empty())
	{
		const CellIndex cell = open.back();
		open.pop_back();
		forEachNext(map, cell,
		            [&](CellIndex next)
		            {
			            if (reached[next] != 0 || !is(next)) return;
			            reached[next] = 1;
			            open.push_back(next);
		            });
	}
	return reached;
}

/** The robot's cell; where it stands nearer to things than it may, all that its body covers. */
std::vector<CellIndex> startsOf(const PlanMap& map, CellIndex robot, double radius_m)
{
	if (robot == kNoCell) return {};
	std::vector<CellIndex> starts{robot};
	if (map.obstacle_m[robot] >= map.fit_m) return starts;
	forEachAround(map, robot, radius_m,
	              [&](CellIndex cell)
	              {
		              const bool beneath = (map.middleOf(cell) - map.middleOf(robot)).norm() <= radius_m;
		              if (beneath && cell != robot && map.cells[cell] == CellState::free) starts.push_back(cell);
	              });
	return starts;
}

void markWanted(PlanMap& map, const PlanInput& input, double radius_m)
{
	const CellIndex robot = map.cellOf(input.robot_in_map);
	std::vector<CellIndex> starts = startsOf(map, robot, radius_m);
	// A doorway that it just fits through ends what it might reach, but it has been on both sides.
	for (const Eigen::Vector3d& at : input.trail_in_map)
		if (const CellIndex cell = map.cellOf(at); cell != kNoCell && map.allowed[cell] != 0) starts.push_back(cell);
	map.wanted = joinedTo(map, starts,
	                      [&](CellIndex cell) { return map.allowed[cell] != 0 && map.obstacle_m[cell] >= map.fit_m; });
	// What is seen through a window, or by a ray of noise through a wall, is free but not joined to where the robot is.
	const std::vector<std::uint8_t> joined =
	    joinedTo(map, startsOf(map, robot, 0.0), [&](CellIndex cell) { return map.cells[cell] == CellState::free; });
	map.near_wanted.assign(map.cells.size(), 0);
	for (std::size_t i = 0; i < map.cells.size(); ++i)
	{
		if (map.cells[i] != CellState::unknown) map.wanted[i] = 0;
		if (map.wanted[i] == 0) continue;
		forEachNext(map, static_cast<CellIndex>(i), [&](CellIndex next) { map.near_wanted[next] = joined[next]; });
	}
}
}  // namespace

Eigen::Array3i PlanMap::placeOf(CellIndex cell) const
{
	const int in_layer = static_cast<int>(cell % layerCells());
	return {in_layer % frame.columns, in_layer / frame.columns, static_cast<int>(cell / layerCells())};
}

bool PlanMap::contains(const Eigen::Array3i& place) const
{
	const Eigen::Array3i size(frame.columns, frame.rows, static_cast<int>(frame.altitudes_m.size()));
	return (place >= 0).all() && (place < size).all();
}

CellIndex PlanMap::cellAt(const Eigen::Array3i& place) const
{
	return static_cast<CellIndex>((place.z() * frame.rows + place.y()) * frame.columns + place.x());
}

CellIndex PlanMap::cellOf(const Eigen::Vector3d& point_in_map) const
{
	const Eigen::Array2i at =
	    ((point_in_map.head<2>() - frame.corner_in_map) / frame.resolution_m).array().floor().cast<int>();
	const Eigen::Array3i place(at.x(), at.y(), frame.nearestLayer(point_in_map.z()));
	return contains(place) ? cellAt(place) : kNoCell;
}

Eigen::Vector3d PlanMap::middleOf(CellIndex cell) const
{
	const Eigen::Array3i place = placeOf(cell);
	const Eigen::Vector2d middle =
	    frame.corner_in_map + frame.resolution_m * (place.head<2>().cast<double>() + 0.5).matrix();
	return {middle.x(), middle.y(), frame.altitudes_m[static_cast<std::size_t>(place.z())]};
}

PlanMap planMap(const PlanInput& input, const RobotConfig& robot, const PlanConfig& config)
{
	PlanMap map;
	map.frame = input.layers.frame();
	map.cells = input.layers.cells();
	map.fit_m = robot.radius_m + config.clearance_m;
	map.obstacle_m = distances(map, obstacles(map), std::max(config.comfort_m, map.fit_m) + map.frame.resolution_m);
	// A cell farther than from obstacles: the avoider keeps as far from what is not known as from those, and must not
	// be led into what it would refuse.
	const double known_m = map.fit_m + map.frame.resolution_m;
	const std::vector<float> unknown_m = distances(map, edgesOfUnknown(map), known_m);
	markAllowed(map, input.area);

	const double squeeze_m = robot.radius_m + config.squeeze_m;
	map.passable.resize(map.cells.size());
	for (std::size_t i = 0; i < map.cells.size(); ++i)
	{
		const bool known = unknown_m[i] >= known_m;
		map.passable[i] =
		    map.allowed[i] != 0 && map.cells[i] == CellState::free && map.obstacle_m[i] >= squeeze_m && known ? 1 : 0;
	}
	markTrail(map, input.trail_in_map, robot.radius_m);
	markBlocked(map, input.blocked_in_map);
	markWanted(map, input, robot.radius_m);
	return map;
}

bool straightWayIsFree(const PlanMap& map, CellIndex from, CellIndex to, double clearance_m)
{
	const Eigen::Array3i a = map.placeOf(from), b = map.placeOf(to);
	if (a.z() != b.z()) return false;
	const Eigen::Array2d way = (b - a).head<2>().cast<double>();
	const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * way.abs().maxCoeff())));
	for (int i = 0; i <= steps; ++i)
	{
		const Eigen::Array2i at =
		    (a.head<2>().cast<double>() + way * (static_cast<double>(i) / steps) + 0.5).floor().cast<int>();
		const CellIndex cell = map.cellAt({at.x(), at.y(), a.z()});
		if (map.passable[cell] == 0 || map.blocked[cell] != 0 || map.obstacle_m[cell] < clearance_m) return false;
	}
	return true;
}
}  // namespace explore

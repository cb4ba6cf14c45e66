#include <explore/navigation/left_over.h>

#include <algorithm>
#include <array>
#include <utility>

namespace explore
{
namespace
{
constexpr double kDoorReach_m = 0.8;
constexpr double kDropReach_m = 0.3;
/** Left-overs with the same reason and so near are one. */
constexpr double kJoin_m = 1.0;

/** The unknown cells beside a frontier, each once. */
std::vector<CellIndex> unknownBeside(const PlanMap& map, const FrontierCluster& cluster)
{
	std::vector<CellIndex> cells;
	for (const std::size_t cell : cluster.cells)
		forEachBeside(map, static_cast<CellIndex>(cell),
		              [&](CellIndex next)
		              {
			              if (map.cells[next] == CellState::unknown) cells.push_back(next);
		              });
	std::sort(cells.begin(), cells.end());
	cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
	return cells;
}

/** What a door that cannot be passed says of what is behind it. */
std::optional<LeftOverReason> reasonOfDoor(const FrontierMemory& memory, const Eigen::Vector2d& at, bool wanted)
{
	for (const DoorTrack& track : memory.doors.tracks)
	{
		if ((track.place.center_in_map - at).norm() > kDoorReach_m || !track.existence.confirmed) continue;
		const Verdict verdict = verdictOf(track);
		if (verdict == Verdict::closed || verdict == Verdict::blocked) return LeftOverReason::closed_door;
		if (verdict == Verdict::unknown && wanted) return LeftOverReason::behind_glass;
		if (verdict == Verdict::drop) return LeftOverReason::drop;
	}
	return std::nullopt;
}

bool isNearDrop(const PlanMap& map, CellIndex cell)
{
	const int reach = static_cast<int>(kDropReach_m / map.frame.resolution_m);
	const Eigen::Array3i middle = map.placeOf(cell);
	for (int dy = -reach; dy <= reach; ++dy)
		for (int dx = -reach; dx <= reach; ++dx)
		{
			const Eigen::Array3i place = middle + Eigen::Array3i(dx, dy, 0);
			if (map.contains(place) && map.cells[map.cellAt(place)] == CellState::drop) return true;
		}
	return false;
}

/** What a frontier's cells have in common: beside the jambs of an opening that is wide enough the robot fits as little
 * as beside those of one that is not. */
struct FrontierFacts
{
	bool wanted = false;       ///< the body might get into what is unknown there
	bool roomy = false;        ///< there is room for it somewhere
	bool seen_across = false;  ///< no way leads to any of its cells
	bool passed_by = false;
};

FrontierFacts factsOf(const LeftOverInput& input, const FrontierCluster& cluster, const std::vector<CellIndex>& unknown)
{
	const PlanMap& map = input.map;
	FrontierFacts facts;
	facts.wanted = std::any_of(unknown.begin(), unknown.end(), [&](CellIndex cell) { return map.wanted[cell] != 0; });
	facts.roomy =
	    std::any_of(unknown.begin(), unknown.end(), [&](CellIndex cell) { return map.obstacle_m[cell] >= map.fit_m; });
	facts.seen_across =
	    std::none_of(cluster.cells.begin(), cluster.cells.end(),
	                 [&](std::size_t cell) { return input.field.reaches(static_cast<CellIndex>(cell)); });
	facts.passed_by =
	    std::any_of(input.passed_by_in_map.begin(), input.passed_by_in_map.end(),
	                [&](const Eigen::Vector3d& middle)
	                {
		                const std::size_t cell = map.cellOf(middle);
		                return std::find(cluster.cells.begin(), cluster.cells.end(), cell) != cluster.cells.end();
	                });
	return facts;
}

/** No value: it was not yet looked at. */
std::optional<LeftOverReason> reasonOf(const LeftOverInput& input, const FrontierFacts& facts, CellIndex unknown)
{
	const Eigen::Vector2d at = input.map.middleOf(unknown).head<2>();
	if (!input.area.inBounds(at)) return LeftOverReason::outside_bounds;
	if (input.area.isKeptOut(at)) return LeftOverReason::kept_out;
	if (isNearDrop(input.map, unknown)) return LeftOverReason::drop;
	if (const auto door = reasonOfDoor(input.memory, at, facts.wanted)) return *door;
	if (facts.wanted) return input.wanted;
	return facts.seen_across && facts.roomy ? LeftOverReason::out_of_reach : LeftOverReason::too_narrow;
}

void join(std::vector<LeftOver>& all, const LeftOver& one)
{
	for (LeftOver& other : all)
	{
		if (other.why != one.why || other.passed_by != one.passed_by ||
		    (other.center_in_map - one.center_in_map).norm() > kJoin_m)
			continue;
		const double area_m2 = other.area_m2 + one.area_m2;
		other.center_in_map = (other.center_in_map * other.area_m2 + one.center_in_map * one.area_m2) / area_m2;
		other.area_m2 = area_m2;
		return;
	}
	all.push_back(one);
}
}  // namespace

std::string_view nameOf(LeftOverReason reason)
{
	static constexpr std::array<std::string_view, 8> kNames{
	    "sealed", "too_narrow", "out_of_reach", "closed_door", "behind_glass", "drop", "kept_out", "outside_bounds"};
	return kNames.at(static_cast<std::size_t>(reason));
}

std::vector<LeftOver> leftOver(const LeftOverInput& input)
{
	std::vector<LeftOver> all;
	const PlanMap& map = input.map;
	std::vector<std::uint8_t> counted(map.cells.size(), 0);  // neighbouring clusters share some
	const double cell_m2 = map.frame.resolution_m * map.frame.resolution_m;
	for (const FrontierCluster& cluster : input.memory.frontiers.clusters())
	{
		const std::vector<CellIndex> unknown = unknownBeside(map, cluster);
		const FrontierFacts facts = factsOf(input, cluster, unknown);
		for (const CellIndex cell : unknown)
		{
			if (std::exchange(counted[cell], std::uint8_t{1}) != 0) continue;
			const auto why = reasonOf(input, facts, cell);
			const bool passed_by = why == LeftOverReason::sealed && facts.passed_by;
			if (why) join(all, {map.middleOf(cell), cell_m2, *why, passed_by});
		}
	}
	return all;
}
}  // namespace explore

// Everything that is looked at along each pair of facing walls, once for the corridor's direction and its ends.
#pragma once

#include <explore/config/fields.h>
#include <explore/perception/corridor_edges.h>
#include <explore/perception/corridor_end_evidence.h>
#include <explore/perception/corridor_sides.h>

#include <optional>
#include <vector>

namespace explore
{
struct CorridorPairConfig
{
	double parallel_rad = 0.10471975511965977;  ///< 6°: walls of one corridor, as they are found one by one
	double min_width_m = 0.5, max_width_m = 4.2;
	SideEdgeConfig edges;
	double max_skew = 0.6;           ///< edges stand opposite each other: difference along / width
	double max_wall_again_m = 0.35;  ///< of the wall that is met again past the edge: behind a door it goes on
};
/** Field list of the above; without a section of its own. */
void describe(FieldVisitor& fields, CorridorPairConfig& config);

/** The tolerances of walls, as they were when the walls were found. */
struct WallPrecision
{
	UprightWallConfig walls;
	SensorNoiseConfig noise;
};

/** Where a wall is seen to end and does not go on behind, as it does behind a door. */
struct WallEnd
{
	SideEdge edge;
	int floor = 0;            ///< samples of the floor behind it
	double wall_again_m = 0;  ///< length of wall met again past it
};

/** One pair of facing walls. */
struct CorridorPair
{
	FacingWalls walls;
	TurnedPoints turned_upright, turned_floor;
	SideProfiles sides;
	std::optional<WallEnd> left_end, right_end;
	std::optional<EndLine> end;  ///< where both walls end, opposite each other
};

struct CorridorPairs
{
	const LevelView* view = nullptr;  ///< must outlive the pairs
	std::vector<UprightWall> walls;   ///< as found, followed by those that their companions hint at
	std::size_t found_walls = 0;
	WallPrecision precision;
	PlanPoints upright, floor;
	std::vector<CorridorPair> pairs;

	[[nodiscard]] CorridorScan scanOf(const CorridorPair& pair) const
	{
		return {*view, upright, floor, pair.turned_upright, pair.turned_floor};
	}
};

/** All pairs among `walls`, and between one of them and a companion that was not found by itself. */
CorridorPairs corridorPairs(const LevelView& view, const std::vector<UprightWall>& walls,
                            const CorridorPairConfig& config, const WallPrecision& precision);
}  // namespace explore

// What speaks for a corridor's end between two edges: who passes it, what lies behind, where the walls go on.
#pragma once

#include <explore/perception/corridor_edges.h>
#include <explore/perception/corridor_sides.h>

#include <cmath>
#include <vector>

namespace explore
{
/** The line from edge to edge, along and across the corridor. */
struct EndLine
{
	double left_along_m, right_along_m, left_m, right_m;

	[[nodiscard]] double skew_m() const { return left_along_m - right_along_m; }
	[[nodiscard]] double width_m() const { return left_m + right_m; }
	/** Where the line lies at `across` (positive to the left). */
	[[nodiscard]] double alongAt(double across_m) const
	{
		return right_along_m + skew_m() * (across_m + right_m) / width_m();
	}
};

/** One side of the corridor as it ends. */
struct EndSide
{
	double outward, edge_m, distance_m;

	/** How far behind the side's plane a point lies. */
	[[nodiscard]] double behind_m(float across) const { return outward * across - distance_m; }
};
EndSide sideOf(const FacingWalls& walls, Side side, double edge_m);
EndSide sideOf(const EndLine& end, Side side);

/** The points of a view along and across one corridor. */
struct CorridorScan
{
	const LevelView& view;
	const PlanPoints& upright;
	const PlanPoints& floor;
	const TurnedPoints& turned_upright;
	const TurnedPoints& turned_floor;
};

/** Length of what runs along behind the plane of one side, past its edge and nearer to it than `wider_m`: a niche, or a
 *  corridor that only widens. */
double shallowLength(const EndSide& side, const CorridorScan& scan, double wider_m, const UprightWallConfig& walls);

/** Samples of the floor behind the plane of one side and past its edge. */
int floorBehind(const EndSide& side, const CorridorScan& scan);

/** Length of wall that is met again past the edge of one side [m]. */
double wallAgain(const EndSide& side, const SideProfile& profile, double spacing_rad);

/** Rays that pass between the edges below a robot's height, by lanes from right to left. */
struct EndLanes
{
	static constexpr double kLane_m = 0.05;
	std::vector<int> through;  ///< go on for `free_beyond_m`, or find floor beyond
	std::vector<int> stopped;  ///< do not
	int no_return = 0;         ///< in all lanes

	[[nodiscard]] int passed() const;
	/** Share of those with a return that go on. */
	[[nodiscard]] double throughShare() const;
	/** Width of the widest run of lanes in which nothing stands. */
	[[nodiscard]] double widestClear_m() const;
	/** Share of the lanes in which a ray goes on. */
	[[nodiscard]] double laneShare() const;
};
EndLanes endLanes(const EndLine& end, const Eigen::Vector2d& direction, const CorridorScan& scan, double free_beyond_m);
}  // namespace explore

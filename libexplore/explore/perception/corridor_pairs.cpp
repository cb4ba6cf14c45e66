#include <explore/perception/corridor_companion.h>
#include <explore/perception/corridor_pairs.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace explore
{
namespace
{
constexpr double kLongWall_m = 0.8;  ///< of which a companion is looked for
constexpr double kApart_m = 2.0;     ///< between the ends of facing walls that do not overlap as they were found
constexpr std::size_t kWallsWithCompanion = 4;  ///< the largest
constexpr std::size_t kMostPairs = 6;           ///< the best seen
constexpr double kSame_m = 0.1;                 ///< planes nearer to each other are one

/** Whether `pair` faces each other at all: what was found of them lies side by side, or nearly so. */
bool isSideBySide(const FacingWalls& pair, const std::vector<UprightWall>& walls)
{
	const WallExtent left = extentAlong(walls[pair.left], pair.direction),
	                 right = extentAlong(walls[pair.right], pair.direction);
	return std::min(left.to_m, right.to_m) > std::max(left.from_m, right.from_m) - kApart_m;
}

/** Adds companions of the long walls to the list; those that are there already are left out. */
void addCompanions(CorridorPairs& all, double spacing_rad, const FacingConfig& facing)
{
	for (std::size_t i = 0; i < std::min(all.found_walls, kWallsWithCompanion); ++i)
	{
		const UprightWall wall = all.walls[i];
		if (wall.to_m - wall.from_m < kLongWall_m) continue;
		const auto companion = companionOf(wall, all.upright, spacing_rad, facing);
		if (!companion) continue;
		const auto same = [&](const UprightWall& other)
		{
			return angleBetween(other.tangent(), companion->tangent()) < facing.parallel_rad &&
			       other.normal.dot(companion->normal) > 0 &&
			       std::abs(other.inFront_m(companion->at(0.5 * (companion->from_m + companion->to_m)))) < kSame_m;
		};
		if (std::ranges::none_of(all.walls, same)) all.walls.push_back(*companion);
	}
}

/** Those of which the lesser wall is seen best. */
std::vector<FacingWalls> bestPairs(const std::vector<UprightWall>& walls, const FacingConfig& facing)
{
	std::vector<FacingWalls> pairs = facingWalls(walls, facing);
	std::erase_if(pairs, [&](const FacingWalls& pair) { return !isSideBySide(pair, walls); });
	const auto lesser = [&](const FacingWalls& pair)
	{ return std::min(walls[pair.left].samples, walls[pair.right].samples); };
	std::ranges::stable_sort(pairs, std::greater{}, lesser);
	if (pairs.size() > kMostPairs) pairs.erase(pairs.begin() + kMostPairs, pairs.end());
	return pairs;
}

std::optional<WallEnd> wallEndOf(Side side, const CorridorPair& pair, const CorridorPairs& all,
                                 const CorridorPairConfig& config)
{
	const auto edge =
	    furthestEdge(side, pair.walls, *all.view, all.upright, pair.turned_upright, config.edges, all.precision.walls);
	if (!edge) return std::nullopt;
	const EndSide end = sideOf(pair.walls, side, edge->along_m);
	const SideProfile& profile = side == Side::left ? pair.sides.left : pair.sides.right;
	const WallEnd found{*edge, floorBehind(end, all.scanOf(pair)), wallAgain(end, profile, sampleSpacing(*all.view))};
	const bool ends =
	    isTrueEdge(found.edge, found.floor, config.edges) && found.wall_again_m <= config.max_wall_again_m;
	return ends ? std::optional(found) : std::nullopt;
}

std::optional<EndLine> endOf(const CorridorPair& pair, const CorridorPairConfig& config)
{
	if (!pair.left_end || !pair.right_end) return std::nullopt;
	const EndLine line{pair.left_end->edge.along_m, pair.right_end->edge.along_m, pair.walls.left_m,
	                   pair.walls.right_m};
	return std::abs(line.skew_m()) <= config.max_skew * line.width_m() ? std::optional(line) : std::nullopt;
}
}  // namespace

void describe(FieldVisitor& fields, CorridorPairConfig& config)
{
	fields.degrees("corridor_parallel_deg", config.parallel_rad, {0.5, 20.0},
	               "Walls of one corridor, as they are found one by one, differ by no more.");
	fields.real("facing_min_width", config.min_width_m, {0.3, 10.0}, "m", "Between walls that face each other.");
	fields.real("facing_max_width", config.max_width_m, {0.3, 20.0}, "m", "Between walls that face each other.");
	describe(fields, config.edges);
	fields.real("edge_max_skew", config.max_skew, {0.0, 5.0}, "",
	            "Distance along a corridor from the end of one side to that of the other, in widths.");
	fields.real("edge_max_wall_again", config.max_wall_again_m, {0.0, 5.0}, "m",
	            "Length of the side wall that may be met again past its edge; behind a door it goes on.");
}

CorridorPairs corridorPairs(const LevelView& view, const std::vector<UprightWall>& walls,
                            const CorridorPairConfig& config, const WallPrecision& precision)
{
	const FacingConfig facing{config.min_width_m, config.max_width_m, config.parallel_rad};
	const double spacing = view.image == nullptr || view.samples.size() == 0 ? 0.0 : sampleSpacing(view);
	CorridorPairs all{&view, walls, walls.size(), precision, uprightPoints(view, precision.noise), {}, {}};
	addCompanions(all, spacing, facing);
	for (FacingWalls& facing_walls : bestPairs(all.walls, facing))
	{
		if (all.pairs.empty()) all.floor = floorPoints(view, precision.noise);
		CorridorPair pair;
		pair.walls = std::move(facing_walls);
		fitJointly(pair.walls, all.walls, all.upright, precision.walls);
		if (pair.walls.left_m <= 0 || pair.walls.right_m <= 0) continue;
		pair.turned_upright = turnedTo(pair.walls.direction, all.upright);
		pair.turned_floor = turnedTo(pair.walls.direction, all.floor);
		pair.sides = sideProfiles(pair.walls, all.upright, pair.turned_upright, spacing, precision.walls);
		pair.left_end = wallEndOf(Side::left, pair, all, config);
		pair.right_end = wallEndOf(Side::right, pair, all, config);
		pair.end = endOf(pair, config);
		all.pairs.push_back(std::move(pair));
	}
	return all;
}
}  // namespace explore

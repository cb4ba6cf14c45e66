#include <explore/perception/corridor_end.h>

#include <algorithm>

namespace explore
{
namespace
{
constexpr double kShallow_m = 0.4;  ///< longer is no stray thing
constexpr double kSameEnd_m = 0.5;  ///< centres of one end, found between other pairs of walls

/** Whether space is seen behind the plane of a side before its wall begins: the camera stands outside. */
bool beginsInView(const SideProfile& side)
{
	for (std::size_t strip = 0; strip < SideProfile::kStrips && !side.isWall(strip); ++strip)
		if (side.isOpen(strip)) return true;
	return false;
}

bool opensWide(const EndLine& end, const CorridorScan& scan, const CorridorEndConfig& config,
               const UprightWallConfig& walls)
{
	const EndSide left = sideOf(end, Side::left), right = sideOf(end, Side::right);
	const auto is_free = [&](const EndSide& side, double wider_m)
	{ return shallowLength(side, scan, wider_m, walls) < kShallow_m; };
	return is_free(left, config.wider_m) && is_free(right, config.wider_m) &&
	       (is_free(left, config.much_wider_m) || is_free(right, config.much_wider_m));
}

CorridorEnd placed(const EndLine& end, const FacingWalls& pair)
{
	const Eigen::Vector2d left = end.left_along_m * pair.direction + end.left_m * leftOf(pair.direction);
	const Eigen::Vector2d right = end.right_along_m * pair.direction - end.right_m * leftOf(pair.direction);
	CorridorEnd result;
	result.center = 0.5 * (left + right);
	result.width_m = (left - right).norm();
	result.normal = leftOf((left - right).normalized());
	if (result.normal.dot(result.center) > 0) result.normal = -result.normal;
	return result;
}

/** Whether enough wall is seen before the edges. */
bool hasWalls(const CorridorEnd& end, const SideProfiles& sides, const CorridorEndConfig& config)
{
	const bool outside = beginsInView(sides.left) || beginsInView(sides.right);
	return std::min(end.left_wall_m, end.right_wall_m) >= (outside ? config.min_wall_outside_m : config.min_wall_m);
}

/** Fills in what passes between the edges; false where too little does. */
bool leadsOn(CorridorEnd& result, const CorridorPair& pair, const CorridorScan& scan, const CorridorEndConfig& config)
{
	const EndLanes lanes = endLanes(*pair.end, pair.walls.direction, scan, config.free_beyond_m);
	result.passed = lanes.passed();
	result.through = lanes.throughShare();
	result.open_lanes = lanes.laneShare();
	result.clear_width_m = std::min(result.width_m, lanes.widestClear_m());
	const double returned = result.through > 0 ? result.passed / result.through : 0.0;
	result.no_return = lanes.no_return / std::max(1.0, returned + lanes.no_return);
	return result.through >= config.min_through && result.open_lanes >= config.min_open_lanes;
}

std::optional<CorridorEnd> endOf(const CorridorPair& pair, const CorridorPairs& all, const CorridorEndConfig& config)
{
	if (!pair.end) return std::nullopt;
	CorridorEnd result = placed(*pair.end, pair.walls);
	const WallEnd &left = *pair.left_end, &right = *pair.right_end;
	result.left_rows = left.edge.rows;
	result.right_rows = right.edge.rows;
	result.left_behind_rows = left.edge.rows_behind;
	result.right_behind_rows = right.edge.rows_behind;
	result.left_floor = left.floor;
	result.right_floor = right.floor;
	result.wall_again_m = std::max(left.wall_again_m, right.wall_again_m);
	result.left_wall_m = pair.sides.left.wallBetween(SideProfile::kFirst_m, left.edge.along_m);
	result.right_wall_m = pair.sides.right.wallBetween(SideProfile::kFirst_m, right.edge.along_m);
	const CorridorScan scan = all.scanOf(pair);
	const bool found = hasWalls(result, pair.sides, config) &&
	                   opensWide(*pair.end, scan, config, all.precision.walls) && leadsOn(result, pair, scan, config);
	return found ? std::optional(result) : std::nullopt;
}
}  // namespace

void describe(FieldVisitor& fields, CorridorEndConfig& config)
{
	fields.real("end_min_wall", config.min_wall_m, {0.05, 5.0}, "m", "Wall on either side before a corridor's end.");
	fields.real("end_min_wall_outside", config.min_wall_outside_m, {0.05, 5.0}, "m",
	            "The same where the walls are seen to begin, as the jambs of a door are.");
	fields.real("end_free_beyond", config.free_beyond_m, {0.1, 5.0}, "m", "Free length behind a corridor's end.");
	fields.real("end_wider", config.wider_m, {0.05, 5.0}, "m",
	            "Behind its end there is this much more space on either side of a corridor ...");
	fields.real("end_much_wider", config.much_wider_m, {0.1, 5.0}, "m", "... and this much on one side.");
	fields.real("end_min_through", config.min_through, {0.0, 1.0}, "",
	            "Share of the rays between the edges, of those with a return, that lead on.");
	fields.real("end_min_open_lanes", config.min_open_lanes, {0.0, 1.0}, "",
	            "Share of the width of a corridor's end in which any ray leads on.");
}

std::vector<CorridorEnd> findCorridorEnds(const CorridorPairs& pairs, const CorridorEndConfig& config)
{
	std::vector<CorridorEnd> ends;
	for (const CorridorPair& pair : pairs.pairs)
	{
		const auto end = endOf(pair, pairs, config);
		const auto same = [&](const CorridorEnd& other) { return (other.center - end->center).norm() < kSameEnd_m; };
		if (end && std::ranges::none_of(ends, same)) ends.push_back(*end);
	}
	return ends;
}
}  // namespace explore

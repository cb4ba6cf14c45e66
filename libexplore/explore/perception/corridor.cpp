#include <explore/perception/corridor.h>

#include <algorithm>
#include <array>

namespace explore
{
namespace
{
/** The last part of the walls, and heights at which neither frayed floor nor ceiling is seen. */
constexpr double kAround_m = 0.7;
constexpr float kFromHeight_m = 0.5F, kToHeight_m = 2.0F;
constexpr int kLanes = 12, kLaneSamples = 4;
constexpr double kFilled = 0.75;          ///< of the width: the corridor is closed there
constexpr double kFurthestStart_m = 6.0;  ///< walls that are seen from further on only are too few samples
constexpr double kAcross_rad = 1.0;       ///< a wall that is turned by more stands across
constexpr double kWallThickness_m = 0.3;  ///< its door's jambs may be taken for the corridor's beginning
constexpr double kDoorPost_m = 0.35;      ///< a wall across leaves no more than this to the corridor's side

/** Those of the agreeing walls that were found as such. */
void takeWalls(CorridorSeen& corridor, const std::vector<std::size_t>& agreeing, const CorridorPairs& all)
{
	for (const std::size_t i : agreeing)
	{
		if (i < all.found_walls) corridor.walls.push_back(i);
		corridor.samples += all.walls[i].samples;
	}
}

/** Whether something fills the corridor's width near the last part of its walls, or behind them; a person or a box
 *  leaves room. */
bool isClosed(const CorridorPair& pair, const Overlap& overlap, const CorridorPairs& all)
{
	const TurnedPoints& turned = pair.turned_upright;
	const std::vector<float>& heights = all.view->samples.z;
	std::array<int, kLanes> lanes{};
	for (std::size_t i = 0; i < turned.along.size(); ++i)
	{
		const float height = heights[all.upright.sample[i]];
		if (turned.along[i] < overlap.to_m - kAround_m || height < kFromHeight_m || height > kToHeight_m) continue;
		const double lane = (turned.across[i] + pair.walls.right_m) / pair.walls.width_m() * kLanes;
		if (lane >= 0 && lane < kLanes) ++lanes.at(static_cast<std::size_t>(lane));
	}
	const auto filled = std::ranges::count_if(lanes, [](int points) { return points >= kLaneSamples; });
	return static_cast<double>(filled) >= kFilled * kLanes;
}

/** Whether a wall stands across before the corridor begins: then it is seen through a door, and the robot is not in it.
 */
bool isBehindWall(const FacingWalls& pair, const Overlap& overlap, const std::vector<UprightWall>& walls)
{
	const Eigen::Vector2d left = leftOf(pair.direction);
	const auto stands_before = [&](const UprightWall& wall)
	{
		if (angleBetween(wall.tangent(), pair.direction) < kAcross_rad) return false;
		const Eigen::Vector2d a = wall.at(wall.from_m), b = wall.at(wall.to_m);
		const double along = 0.5 * pair.direction.dot(a + b), across_a = left.dot(a), across_b = left.dot(b);
		return along > 0 && along < overlap.from_m + kWallThickness_m &&
		       std::min(across_a, across_b) < kDoorPost_m - pair.right_m &&
		       std::max(across_a, across_b) > pair.left_m - kDoorPost_m;
	};
	return std::ranges::any_of(walls, stands_before);
}

/** Where the walls are clearly seen to end, of one alone too; no value where they are not. */
std::optional<double> clearEnd(const CorridorPair& pair, const SideEdgeConfig& config)
{
	std::optional<double> nearest;
	const auto has_space = [&](const WallEnd& end)
	{ return end.edge.rows_behind >= config.min_rows || end.floor >= config.min_floor_samples; };
	if (pair.end && has_space(*pair.left_end) && has_space(*pair.right_end))
		nearest = std::max(pair.end->left_along_m, pair.end->right_along_m);
	for (const auto& end : {pair.left_end, pair.right_end})
		if (end && end->edge.rows_behind >= config.min_sharp_rows)
			nearest = std::min(nearest.value_or(end->edge.along_m), end->edge.along_m);
	return nearest;
}

bool isCorridor(const CorridorPair& pair, const Overlap& overlap, bool ends_in_view, const CorridorPairs& all,
                const CorridorConfig& config)
{
	const double widths = overlap.length_m() / pair.walls.width_m();
	if (widths < config.min_open_widths || overlap.from_m > kFurthestStart_m) return false;
	if (isBehindWall(pair.walls, overlap, all.walls)) return false;
	return widths >= config.min_overlap_widths || !(ends_in_view || isClosed(pair, overlap, all));
}

/** What one pair of facing walls amounts to. */
std::optional<CorridorSeen> corridorBetween(const CorridorPair& pair, const CorridorPairs& all,
                                            const CorridorConfig& config)
{
	const FacingWalls& walls = pair.walls;
	if (walls.width_m() < config.min_width_m || walls.width_m() > config.max_width_m) return std::nullopt;
	auto overlap = overlapOf(pair.sides, config.min_wall_share);
	if (!overlap) return std::nullopt;
	const std::optional<double> end = clearEnd(pair, config.pairs.edges);
	if (end) overlap->to_m = std::min(overlap->to_m, *end);
	const bool ends_in_view = end && *end < overlap->to_m + kAround_m;
	if (!isCorridor(pair, *overlap, ends_in_view, all, config)) return std::nullopt;
	CorridorSeen corridor;
	corridor.direction = walls.direction;
	corridor.sigma_rad = walls.sigma_rad;
	corridor.point = overlap->to_m * walls.direction;
	corridor.width_m = walls.width_m();
	corridor.offset_m = 0.5 * (walls.right_m - walls.left_m);
	corridor.from_m = overlap->from_m;
	corridor.to_m = overlap->to_m;
	takeWalls(corridor, walls.agreeing, all);
	return corridor;
}

std::optional<CorridorSeen> longestCorridor(const CorridorPairs& all, const CorridorConfig& config)
{
	std::optional<CorridorSeen> longest;
	for (const CorridorPair& pair : all.pairs)
	{
		auto corridor = corridorBetween(pair, all, config);
		if (!corridor || (longest && corridor->to_m - corridor->from_m <= longest->to_m - longest->from_m)) continue;
		longest = std::move(corridor);
	}
	return longest;
}

/** Walls whose lines run parallel, and the sum of their axes times their samples. */
struct ParallelGroup
{
	std::vector<std::size_t> walls;
	Eigen::Vector2d weighted_axis = Eigen::Vector2d::Zero();
	double samples = 0;
};

/** The paper's way (§3.1): the group of parallel lines with the most inliers; it never abstains. */
std::optional<CorridorSeen> largestGroup(const CorridorPairs& all, const CorridorConfig& config)
{
	const std::vector<UprightWall>& walls = all.walls;
	std::vector<ParallelGroup> groups;
	for (std::size_t i = 0; i < all.found_walls; ++i)
	{
		const auto parallel = std::ranges::find_if(
		    groups, [&](const ParallelGroup& group)
		    { return angleBetween(group.weighted_axis, walls[i].tangent()) <= config.paper_parallel_rad; });
		ParallelGroup& group = parallel == groups.end() ? groups.emplace_back() : *parallel;
		const double sign = group.weighted_axis.dot(walls[i].tangent()) < 0 ? -1.0 : 1.0;
		group.weighted_axis += sign * static_cast<double>(walls[i].samples) * walls[i].tangent();
		group.walls.push_back(i);
		group.samples += static_cast<double>(walls[i].samples);
	}
	const auto largest = std::ranges::max_element(groups, {}, &ParallelGroup::samples);
	if (largest == groups.end()) return std::nullopt;
	CorridorSeen corridor;
	takeWalls(corridor, largest->walls, all);
	const Eigen::Vector2d axis = largest->weighted_axis.normalized();
	double ahead = 0, behind = 0;
	for (const std::size_t i : largest->walls)
	{
		const WallExtent extent = extentAlong(walls[i], axis);
		ahead = std::max(ahead, extent.to_m);
		behind = std::max(behind, -extent.from_m);
	}
	corridor.direction = ahead >= behind ? axis : Eigen::Vector2d(-axis);
	corridor.to_m = std::max(ahead, behind);
	corridor.point = corridor.to_m * corridor.direction;
	return corridor;
}
}  // namespace

void describe(FieldVisitor& fields, CorridorConfig& config)
{
	describe(fields, config.pairs);
	fields.real("corridor_min_width", config.min_width_m, {0.3, 10.0}, "m", "Between facing walls.");
	fields.real("corridor_max_width", config.max_width_m, {0.3, 20.0}, "m", "Between facing walls.");
	fields.real("corridor_min_overlap", config.min_overlap_widths, {0.1, 20.0}, "",
	            "Facing walls are a corridor when they are seen side by side for this many widths.");
	fields.real("corridor_min_open_overlap", config.min_open_widths, {0.1, 20.0}, "",
	            "The same where they are not seen to end.");
	fields.real("corridor_min_wall_share", config.min_wall_share, {0.0, 1.0}, "",
	            "Share of that length that has to be wall on either side; the rest may be doors or hidden.");
}

std::optional<CorridorSeen> findCorridor(const CorridorPairs& pairs, const CorridorConfig& config)
{
	return config.vote ? longestCorridor(pairs, config) : largestGroup(pairs, config);
}

VanishingPoint vanishingPointOf(const CorridorSeen& corridor, const LevelPose& pose)
{
	const Eigen::Vector3d point_in_level(corridor.point.x(), corridor.point.y(), pose.cameraHeight_m());
	const Eigen::Vector3d direction_in_level(corridor.direction.x(), corridor.direction.y(), 0.0);
	return {pose.robot_from_level * point_in_level, pose.robot_from_level.linear() * direction_in_level, corridor.walls,
	        corridor.samples, std::nullopt};
}
}  // namespace explore

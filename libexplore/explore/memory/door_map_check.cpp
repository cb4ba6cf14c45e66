#include <explore/memory/door_map_check.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace explore
{
namespace
{
constexpr double kPassage_m = 0.3;      // in front of the wall's middle and behind it
constexpr double kAboveFloor_m = 0.15;  // above thresholds and the floor's own voxels
/** Pixels on the edge of a jamb lie anywhere between it and what is behind: so few occupied places are no obstacle. */
constexpr int kStray = 3;
constexpr double kShift_m = 0.3;  // of a mirror that is not one
constexpr std::array<double, 5> kMirrorHeights_m{0.3, 0.6, 0.9, 1.2, 1.5};
constexpr double kMirrorBeside_m = 0.5;  // beyond the jambs: what a mirror shows at an angle

/** The heights above the floor between which the robot's body may pass an opening, and how much of them it takes. */
struct BodyRoom
{
	double lowest_m = 0, highest_m = 0, body_m = 0;
};

/** A robot on the ground takes all of its room, one that flies finds its own height in the band that it flies in, and
 *  below the lintel. */
BodyRoom roomOf(const DoorPlace& place, const RobotConfig& robot)
{
	if (robot.kind == RobotKind::ground) return {kAboveFloor_m, robot.height_m, robot.height_m - kAboveFloor_m};
	const double half_m = 0.5 * robot.height_m;
	return {std::max(kAboveFloor_m, robot.min_altitude_m - half_m),
	        std::min(robot.max_altitude_m + half_m, place.height_m.value_or(kUsualDoorHeight_m)), robot.height_m};
}

/** How many places from before the wall to behind it are occupied, at that place of the opening. */
int occupiedAcross(const Eigen::Vector3d& point_in_map, const Eigen::Vector2d& normal, const OccupancyQuery& occupancy,
                   double step_m)
{
	int occupied = 0;
	for (double across_m = -kPassage_m; across_m <= kPassage_m; across_m += step_m)
	{
		Eigen::Vector3d point = point_in_map;
		point.head<2>() += across_m * normal;
		occupied += occupancy(point) == VoxelState::occupied ? 1 : 0;
	}
	return occupied;
}

/** The most columns side by side each of which is free over `levels` neighbouring levels. */
int widestRun(const std::vector<std::vector<int>>& occupied_at_level, std::size_t levels)
{
	int widest = 0;
	for (std::size_t first = 0; first + levels <= occupied_at_level.size(); ++first)
	{
		int run = 0;
		for (std::size_t column = 0; column < occupied_at_level[first].size(); ++column)
		{
			int occupied = 0;
			for (std::size_t level = first; level < first + levels; ++level)
				occupied += occupied_at_level[level][column];
			run = occupied <= kStray ? run + 1 : 0;
			widest = std::max(widest, run);
		}
	}
	return widest;
}

/** Whether the mirror image of `point`, in a mirror `shift_m` in front of the opening's, is occupied; unknown there. */
VoxelState mirrored(const Eigen::Vector3d& point, const DoorPlace& place, double shift_m,
                    const OccupancyQuery& occupancy)
{
	const Eigen::Vector2d normal = place.normal();
	const double in_front_m = (point.head<2>() - place.center_in_map).dot(normal) - shift_m;
	Eigen::Vector3d image = point;
	image.head<2>() -= 2 * in_front_m * normal;
	return occupancy(image);
}

struct Matches
{
	int known = 0, occupied = 0;

	[[nodiscard]] double share() const { return known > 0 ? static_cast<double>(occupied) / known : 0.0; }
	void add(VoxelState state)
	{
		known += state != VoxelState::unknown ? 1 : 0;
		occupied += state == VoxelState::occupied ? 1 : 0;
	}
};
}  // namespace

void describe(FieldVisitor& fields, MapCheckConfig& config)
{
	fields.real("check_step", config.step_m, {0.01, 0.5}, "m", "Distance of the points at which the map is asked.");
	fields.real("min_free_share", config.min_free_share, {0.0, 1.0}, "",
	            "Of an opening's clear width that the map must leave, or it is blocked; 0 = the map is not asked.");
	fields.real("mirror_depth", config.mirror_depth_m, {0.5, 10.0}, "m",
	            "How far behind an opening its mirror image is looked for.");
	fields.real("mirror_share", config.mirror_share, {0.1, 1.0}, "",
	            "Of what stands behind that has to be a mirror image of what stands in front, for a mirror.");
	fields.real("mirror_contrast", config.mirror_contrast, {0.0, 1.0}, "",
	            "By how much this share has to be larger than for a mirror 0.3 m elsewhere.");
	fields.integer("mirror_points", config.mirror_points, {1, 100000}, "", "Points that have to tell, at least.");
}

double mappedClearWidth(const DoorPlace& place, const OccupancyQuery& occupancy, const RobotConfig& robot,
                        const MapCheckConfig& config)
{
	const auto columns = static_cast<std::size_t>(place.width_m / config.step_m);
	if (columns == 0) return place.width_m;
	const double column_m = place.width_m / static_cast<double>(columns);
	const BodyRoom room = roomOf(place, robot);
	if (room.highest_m - room.lowest_m < room.body_m) return 0;
	std::vector<std::vector<int>> occupied_at_level;
	for (double height_m = room.lowest_m; height_m < room.highest_m; height_m += config.step_m)
	{
		std::vector<int>& occupied = occupied_at_level.emplace_back(columns);
		for (std::size_t column = 0; column < columns; ++column)
		{
			const double along_m = (static_cast<double>(column) + 0.5) * column_m - 0.5 * place.width_m;
			occupied[column] = occupiedAcross(place.point(along_m, height_m), place.normal(), occupancy, config.step_m);
		}
	}
	if (occupied_at_level.empty()) return place.width_m;
	const auto levels = static_cast<std::size_t>(std::ceil(room.body_m / config.step_m));
	return widestRun(occupied_at_level, std::min(levels, occupied_at_level.size())) * column_m;
}

MirrorImage mirrorImageOf(const DoorPlace& place, const OccupancyQuery& occupancy, const MapCheckConfig& config)
{
	Matches here, nearer, farther;
	const Eigen::Vector2d normal = place.normal();
	const double side_m = 0.5 * place.width_m + kMirrorBeside_m, step_m = 2 * config.step_m;
	for (double behind_m = kShift_m; behind_m <= config.mirror_depth_m; behind_m += step_m)
		for (double along_m = -side_m; along_m <= side_m; along_m += step_m)
			for (const double height_m : kMirrorHeights_m)
			{
				Eigen::Vector3d point = place.point(along_m, height_m);
				point.head<2>() -= behind_m * normal;
				if (occupancy(point) != VoxelState::occupied) continue;
				here.add(mirrored(point, place, 0, occupancy));
				nearer.add(mirrored(point, place, kShift_m, occupancy));
				farther.add(mirrored(point, place, -kShift_m, occupancy));
			}
	return {here.known, here.share(), here.share() - std::max(nearer.share(), farther.share())};
}

std::optional<Verdict> objectionTo(const DoorPlace& place, double clear_width_m, const OccupancyQuery& occupancy,
                                   const RobotConfig& robot, const MapCheckConfig& config)
{
	const MirrorImage image = mirrorImageOf(place, occupancy, config);
	if (image.points >= config.mirror_points && image.share >= config.mirror_share &&
	    image.contrast >= config.mirror_contrast)
		return Verdict::unknown;
	const double free_m = mappedClearWidth(place, occupancy, robot, config);
	return free_m < config.min_free_share * clear_width_m ? std::optional(Verdict::blocked) : std::nullopt;
}
}  // namespace explore

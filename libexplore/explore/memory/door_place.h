// Where a door stands in the map: a stretch of a wall on the floor plan, with a floor and perhaps a lintel.
#pragma once

#include <explore/core/results.h>

#include <Eigen/Geometry>
#include <optional>

namespace explore
{
struct DoorPlace
{
	Eigen::Vector2d center_in_map = Eigen::Vector2d::Zero();  ///< middle of the opening
	double normal_rad = 0;             ///< azimuth in the map of the wall's normal, toward where it was first seen from
	double width_m = 0;                ///< from jamb to jamb
	double floor_m = 0;                ///< height of the floor in the map
	std::optional<double> height_m{};  ///< of the lintel above the floor; no value: not seen yet

	[[nodiscard]] Eigen::Vector2d normal() const;
	/** Along the wall, to the right as one looks along the normal. */
	[[nodiscard]] Eigen::Vector2d along() const;
	/** `along_m` from the middle, `height_m` above the floor. */
	[[nodiscard]] Eigen::Vector3d point(double along_m, double above_floor_m) const;
};

/** The height [m] of a door whose lintel is not in view: its Door::center is half of it above the floor. */
inline constexpr double kUsualDoorHeight_m = 2.0;

DoorPlace placeOf(const Door& door_in_robot, const Eigen::Isometry3d& map_from_robot);

/** a − b for directions whose sign has no meaning: in (−π/2, π/2]. */
double axisDifference(double a_rad, double b_rad);

/** How the openings of two doors lie to each other. */
struct DoorOverlap
{
	double share = 0;       ///< of the narrower one that the other covers, along the first one's wall, 0–1
	double across_m = 0;    ///< distance of the second one's middle from the first one's wall
	double angle_rad = 0;   ///< between their walls, 0 to π/2
	double distance_m = 0;  ///< of their middles
};
DoorOverlap overlapOf(const DoorPlace& a, const DoorPlace& b);

/** Whether the way from `from` to `to` leads through the opening. */
bool leadsThrough(const DoorPlace& place, const Eigen::Vector2d& from_in_map, const Eigen::Vector2d& to_in_map);

/** The same place in a map that was moved. `new_map_from_map` turns about the vertical (what little it tilts counts for
 *  the height alone). */
DoorPlace moved(const DoorPlace& place, const Eigen::Isometry3d& new_map_from_map);

/** The turn about the vertical [rad] of a rigid motion. */
double turnOf(const Eigen::Isometry3d& motion);
}  // namespace explore

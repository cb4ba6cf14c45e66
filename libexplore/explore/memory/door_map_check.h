// What the map of occupied space, seen from elsewhere, says against passing through an opening.
#pragma once

#include <explore/config/fields.h>
#include <explore/memory/door_place.h>
#include <explore/memory/voxel_block.h>

#include <functional>
#include <optional>

namespace explore
{
/** What the map holds at a point [m] in the map frame. */
using OccupancyQuery = std::function<VoxelState(const Eigen::Vector3d& point_in_map)>;

struct MapCheckConfig
{
	double step_m = 0.05;  ///< between the points that are asked for: the edge of a voxel; twice as far for mirrors
	double min_free_share = 0.5;    ///< of the clear width that the map must leave
	double mirror_depth_m = 3.0;    ///< how far behind the opening its mirror image is looked for
	double mirror_share = 0.85;     ///< of what stands there that has to be a mirror image
	double mirror_contrast = 0.35;  ///< how much more of it than for a mirror that stood a little elsewhere
	int mirror_points = 30;         ///< that have to tell, at least
};
/** Field list of the above; without a section of its own. */
void describe(FieldVisitor& fields, MapCheckConfig& config);

/** The widest stretch [m] of the opening through which the map holds nothing but stray voxels, from 0.3 m in front of
 * the wall's middle to 0.3 m behind it: for a robot on the ground between the heights of its body that are not its
 * wheels, for one that flies at the best altitude of its flight band below the lintel. Unknown counts as free: what was
 * never seen is no objection. 0 where a robot that flies has no room under the lintel. */
double mappedClearWidth(const DoorPlace& place, const OccupancyQuery& occupancy, const RobotConfig& robot,
                        const MapCheckConfig& config);

/** How much of what stands on one side of an opening is the mirror image of the other. */
struct MirrorImage
{
	int points = 0;       ///< occupied behind, with something known at their mirror image
	double share = 0;     ///< of those, occupied there too
	double contrast = 0;  ///< share − the largest share that another place of the mirror, 0.3 m off, would have
};
/** A corridor's walls look the same for any place of the mirror, hence the contrast. The side behind is the one that
 *  place.normal() points away from. */
MirrorImage mirrorImageOf(const DoorPlace& place, const OccupancyQuery& occupancy, const MapCheckConfig& config);

/** Why the robot cannot pass, as far as the map tells: unknown (a mirror), blocked, or no value. */
std::optional<Verdict> objectionTo(const DoorPlace& place, double clear_width_m, const OccupancyQuery& occupancy,
                                   const RobotConfig& robot, const MapCheckConfig& config);
}  // namespace explore

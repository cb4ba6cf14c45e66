// The obstacle set of the avoider: the paper's O = P_f \ P_ground, and the one that method = full makes of every pixel.
#pragma once

#include <explore/config/fields.h>
#include <explore/core/depth_frame.h>
#include <explore/core/robot.h>
#include <explore/perception/planes.h>
#include <explore/perception/sensor_noise.h>

namespace explore
{
/** The points that do not belong to the ground (Algorithm 1, line 6). Points below the plane stay in: what is under the
 *  floor is no free way. */
PointCloud obstaclePoints(const PointCloud& points, const std::optional<FoundPlane>& ground);

struct ObstacleConfig
{
	double max_range_m = 5.0;         ///< depth; what is further away does not matter yet
	double min_height_m = 0.05;       ///< lower things are rolled over; the same holds for steps down
	double overhead_margin_m = 0.05;  ///< what passes this far above a ground robot is no obstacle
	double min_area_m2 = 3e-4;        ///< facing the camera: less of a thing may be noise
	double floor_slack = 0.005;       ///< what the floor may be off per metre of range: slope of the plane, unevenness
	double tolerance_sigmas = 3.0;    ///< of the depth noise
};
void describe(FieldVisitor& fields, ObstacleConfig& config);

/** What `robot` may run into, robot frame, from every pixel of the depth image.
 *
 *  A pixel counts when two of its four neighbours measured nearly the same depth: thin legs and poles do, stray pixels
 *  and those that hang between a silhouette and what is behind it do not. For a ground robot it stands higher above
 *  `ground` than min_height and than what noise makes of a flat floor, and not above the robot's top; or it lies as
 *  much below the floor: a drop. Without `ground` the floor is the plane z = 0 of a ground robot's frame. For a MAV
 *  all count, the floor too.
 *
 *  Of the pixels of a tile of the image (2 × 32 pixels of VGA for a ground robot, 4 × 16 for a MAV) the nearest is
 *  taken that shows min_area of a thing with what is as deep around it, of drops the one whose ray passes through the
 *  floor nearest. What a convex body that holds the camera touches
 *  first along any direction is among the nearest of its ray; so tiles lose nothing but their own size, which is small
 *  near the robot and grows with range.
 *
 *  An unorganised cloud is thinned to voxels of 5 cm, and heights are sorted out in the same way. */
PointCloud nearObstacles(const DepthFrame& frame, const std::optional<Plane>& ground, const RobotConfig& robot,
                         const ObstacleConfig& config, const SensorNoiseConfig& noise);
}  // namespace explore

#include <explore/perception/ground.h>

#include <algorithm>

namespace explore
{
namespace
{
constexpr double kMinCameraHeight_m = 0.05;  // above the ground; shelves and seats at the camera's height are none
constexpr double kParallel_rad = 0.09;       // 5 degrees
constexpr double kMinSupport = 0.1;
constexpr double kMinContrastShare = 0.5;  // of the inliers; a horizontal slice through walls or clutter has about 0

PointCloud pointsBelow(const PointCloud& points, const Plane& plane, double distance_m)
{
	PointCloud below;
	for (std::size_t i = 0; i < points.size(); ++i)
		if (plane.signedDistance(points[i].cast<double>()) < -distance_m) below.push_back(points[i]);
	return below;
}

Plane turnedUp(const Plane& plane, const Eigen::Vector3d& up)
{
	return plane.normal.dot(up) < 0 ? plane.flipped() : plane;
}

bool isFloorLike(const PointCloud& points, const FoundPlane& found, const GroundPrior& prior,
                 const GroundConfig& config, const PlaneSearchConfig& planes)
{
	const double needed = std::max(kMinContrastShare * static_cast<double>(found.inliers.size()),
	                               static_cast<double>(planes.min_inliers));
	return angleBetweenAxes(found.plane.normal, prior.up) <= config.max_tilt_rad &&
	       found.plane.signedDistance(prior.camera) >= kMinCameraHeight_m &&
	       contrast(points, found.plane, planes.tolerance_m) >= needed;
}
/** Whether `lower`, found beneath `higher`, may be the floor under a table: flat surfaces of a room are parallel, and a
 *  handful of stray returns from below the floor is no floor. */
bool replaces(const FoundPlane& lower, const std::optional<FoundPlane>& higher)
{
	return !higher ||
	       (angleBetweenAxes(lower.plane.normal, higher->plane.normal) <= kParallel_rad &&
	        static_cast<double>(lower.inliers.size()) >= kMinSupport * static_cast<double>(higher->inliers.size()));
}
}  // namespace

void describe(FieldVisitor& fields, GroundConfig& config)
{
	fields.degrees("ground_tilt_deg", config.max_tilt_rad, {1.0, 45.0},
	               "The ground may be tilted this much against the robot's (or the IMU's) vertical (paper: 15).");
}

std::optional<FoundPlane> findGround(const PointCloud& points, const GroundPrior& prior, const GroundConfig& config,
                                     const PlaneSearchConfig& planes, RandomEngine& random)
{
	const NormalCone near_horizontal{prior.up, config.max_tilt_rad};
	std::optional<FoundPlane> lowest;
	PointCloud candidates = points;
	while (auto found = dominantPlane(candidates, planes, random, near_horizontal))
	{
		found->plane = turnedUp(found->plane, prior.up);
		if (isFloorLike(points, *found, prior, config, planes) && replaces(*found, lowest))
		{
			lowest = *found;
			// A table may hold more points than the floor: go on among what lies beneath it.
			candidates = pointsBelow(candidates, found->plane, 2 * planes.tolerance_m);
		}
		else
			candidates = without(candidates, found->inliers);
	}
	// Indices so far count what was left of the cloud.
	if (lowest) lowest->inliers = inliersOf(points, lowest->plane, planes.tolerance_m);
	return lowest;
}
}  // namespace explore

// The obstacle set O = P_f \ P_ground (Algorithm 1, line 6).
#pragma once

#include <explore/perception/planes.h>

namespace explore
{
/** The points that do not belong to the ground. Points below the plane stay in: what is under the floor is no free way.
 */
PointCloud obstaclePoints(const PointCloud& points, const std::optional<FoundPlane>& ground);
}  // namespace explore

#include <explore/perception/obstacles.h>

namespace explore
{
PointCloud obstaclePoints(const PointCloud& points, const std::optional<FoundPlane>& ground)
{
	return ground ? without(points, ground->inliers) : points;
}
}  // namespace explore

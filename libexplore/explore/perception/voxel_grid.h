// Voxel grid downsampling to centroids (Algorithm 1, line 3).
#pragma once

#include <explore/config/fields.h>
#include <explore/core/point_cloud.h>

namespace explore
{
struct VoxelGridConfig
{
	double voxel_size_m = 0.05;
};
void describe(FieldVisitor& fields, VoxelGridConfig& config);

/** One point per occupied voxel: the centroid of the points in it, in the order in which voxels are first met. Voxels
 * are aligned to the origin of the cloud's frame. */
PointCloud voxelGrid(const PointCloud& points, const VoxelGridConfig& config);
}  // namespace explore

// The rays of one depth image in the map's voxels: where they start, where they go, how far each saw.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/memory/occupancy_config.h>
#include <explore/memory/voxel_block.h>

#include <Eigen/Core>
#include <vector>

namespace explore
{
/** A point on the ray of pixel (u, v) at depth x is, in voxels from the corner of origin_key,
 *  origin + x · voxels_from_camera · (1, left[u], up[v]). */
struct FrameRays
{
	static constexpr int kLanes = 8;

	int width_px = 0, height_px = 0;
	GridKey origin_key = GridKey::Zero();                              ///< the voxel that the camera is in
	Eigen::Vector3f origin = Eigen::Vector3f::Zero();                  ///< where in it, 0–1
	Eigen::Matrix3f voxels_from_camera = Eigen::Matrix3f::Identity();  ///< directions; lengths from metres to voxels
	Eigen::Matrix3f camera_from_voxels = Eigen::Matrix3f::Identity();
	/** y and z of the rays' directions by column and row, for an x of 1. After the last column come kLanes of NaN, so
	 * that loops may run over it. */
	std::vector<float> left, up;
	/** Depth up to which each pixel's ray saw, row-major; 0 = no return, and kLanes more of them at the end. */
	std::vector<float> reach_m;
	/** Pixel of a direction (1, y, z): axis_px + px_per_tangent · (y, z). */
	Eigen::Array2f axis_px = Eigen::Array2f::Zero(), px_per_tangent = Eigen::Array2f::Zero();

	[[nodiscard]] const float* rowOfReach(int v) const
	{
		return reach_m.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(width_px);
	}
	[[nodiscard]] float reach(int u, int v) const { return rowOfReach(v)[u]; }
	[[nodiscard]] Eigen::Vector3f direction(int u, int v) const
	{
		return voxels_from_camera *
		       Eigen::Vector3f(1.0F, left[static_cast<std::size_t>(u)], up[static_cast<std::size_t>(v)]);
	}
	/** A place given in voxels from the corner of voxel `key`, in camera axes [m]. */
	[[nodiscard]] Eigen::Vector3f inCamera(const GridKey& key, const Eigen::Vector3f& offset) const
	{
		return camera_from_voxels * ((key - origin_key).cast<float>().matrix() + offset - origin);
	}
};

/** Makes `rays` those of the frame, whatever they were before: large arrays are used again. Rays end at the pixel's
 * depth where that is within the range along the ray, otherwise at the range. Throws InputError for a pose outside of
 * an octree's 65536 voxels an axis, or one that is not finite. */
void setRays(FrameRays& rays, const DepthFrame& frame, const OccupancyConfig& config);
}  // namespace explore

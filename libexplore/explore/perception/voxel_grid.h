// Voxel grid downsampling to centroids (Algorithm 1, line 3).
#pragma once

#include <explore/config/fields.h>
#include <explore/core/geometry.h>
#include <explore/core/point_cloud.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace explore
{
struct VoxelGridConfig
{
	double voxel_size_m = 0.05;
};
void describe(FieldVisitor& fields, VoxelGridConfig& config);

/** Sums points into voxels as they come. Voxels are aligned to the origin of the points' frame. */
class VoxelGrid
{
public:
	/** `reach` holds all points that will be added, give or take a voxel. */
	VoxelGrid(const Eigen::AlignedBox3f& reach, const VoxelGridConfig& config);

	void add(const PointBlock& points);
	/** One point per occupied voxel: the centroid of the points in it, in the order in which voxels were first met. */
	[[nodiscard]] PointCloud centroids() const;

private:
	/** Sum and number of the points in one voxel. */
	struct Sum
	{
		float x = 0, y = 0, z = 0;
		std::uint32_t count = 0;
	};
	static constexpr std::size_t kBlock = 256;
	/** The cells of a block's points: their places in m_cells. */
	using Places = std::array<std::int32_t, kBlock>;

	void placesOf(const PointBlock& points, Places& places) const;
	void addTo(std::uint32_t& voxel, const PointBlock& points, std::size_t i);

	float m_voxels_per_m;
	Eigen::Array3f m_first;    ///< first cell of each axis
	Eigen::Array3f m_strides;  ///< of each axis in m_cells; exact in floats, as all cell numbers of an array are
	std::vector<std::uint32_t> m_cells;  ///< the voxel of each cell, where the box is not too large for an array
	std::map<std::array<float, 3>, std::uint32_t> m_far_cells;  ///< the same for far, sparse clouds
	std::vector<Sum> m_sums;
};

/** The centroids of the voxels of a whole cloud. */
PointCloud voxelGrid(const PointCloud& points, const VoxelGridConfig& config);
}  // namespace explore

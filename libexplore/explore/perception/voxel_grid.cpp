#include <explore/perception/voxel_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace explore
{
namespace
{
constexpr std::uint32_t kNoVoxel = ~std::uint32_t{0};
constexpr double kMaxArrayCells = 1 << 24;  // 64 MB; a 10 m × 10 m × 3 m room at 5 cm has 2.4 million
constexpr std::size_t kBlock = 256;

/** Sum and number of the points in one voxel. */
struct VoxelSum
{
	float x = 0, y = 0, z = 0;
	std::uint32_t count = 0;
};

/** The cells of one axis that the cloud reaches. */
struct AxisCells
{
	std::int32_t first = 0;
	std::int64_t count = 0;
	std::array<std::int32_t, kBlock> block{};  ///< cells of the points under work, counted from `first`

	AxisCells(const std::vector<float>& values, float voxels_per_m)
	{
		if (values.empty()) return;
		const Eigen::Map<const Eigen::ArrayXf> array(values.data(), static_cast<Eigen::Index>(values.size()));
		first = static_cast<std::int32_t>(std::floor(array.minCoeff() * voxels_per_m));
		count = static_cast<std::int64_t>(std::floor(array.maxCoeff() * voxels_per_m)) - first + 1;
	}
	/** A loop of its own and without std::floor, because it vectorises. */
	void compute(const float* values, std::size_t n, float voxels_per_m)
	{
		for (std::size_t i = 0; i < n; ++i)
		{
			const float scaled = values[i] * voxels_per_m;
			const auto truncated = static_cast<std::int32_t>(scaled);
			block[i] = truncated - static_cast<std::int32_t>(static_cast<float>(truncated) > scaled) - first;
		}
	}
};

/** The voxel of each cell, as an array over the cloud's bounding box: the fastest look-up there is. */
class ArrayIndex
{
public:
	explicit ArrayIndex(std::size_t cells) : m_voxels(cells, kNoVoxel) {}
	std::uint32_t& operator[](std::int64_t cell) { return m_voxels[static_cast<std::size_t>(cell)]; }

private:
	std::vector<std::uint32_t> m_voxels;
};

/** The same for boxes that are too large for an array: far, sparse clouds. */
class HashIndex
{
public:
	std::uint32_t& operator[](std::int64_t cell) { return m_voxels.try_emplace(cell, kNoVoxel).first->second; }

private:
	std::unordered_map<std::int64_t, std::uint32_t> m_voxels;
};

template <class Index>
std::vector<VoxelSum> sumVoxels(const PointCloud& points, float voxels_per_m, std::array<AxisCells, 3>& axes,
                                Index&& voxel_of_cell)
{
	auto& [x_axis, y_axis, z_axis] = axes;
	std::vector<VoxelSum> voxels;
	for (std::size_t begin = 0; begin < points.size(); begin += kBlock)
	{
		const std::size_t n = std::min(kBlock, points.size() - begin);
		x_axis.compute(&points.x[begin], n, voxels_per_m);
		y_axis.compute(&points.y[begin], n, voxels_per_m);
		z_axis.compute(&points.z[begin], n, voxels_per_m);
		for (std::size_t i = 0; i < n; ++i)
		{
			std::uint32_t& voxel =
			    voxel_of_cell[(x_axis.block[i] * y_axis.count + y_axis.block[i]) * z_axis.count + z_axis.block[i]];
			if (voxel == kNoVoxel)
			{
				voxel = static_cast<std::uint32_t>(voxels.size());
				voxels.emplace_back();
			}
			VoxelSum& sum = voxels[voxel];
			sum.x += points.x[begin + i];
			sum.y += points.y[begin + i];
			sum.z += points.z[begin + i];
			++sum.count;
		}
	}
	return voxels;
}

PointCloud centroids(const std::vector<VoxelSum>& voxels)
{
	PointCloud result;
	result.resize(voxels.size());
	for (std::size_t i = 0; i < voxels.size(); ++i)
	{
		const float weight = 1.0F / static_cast<float>(voxels[i].count);
		result.x[i] = weight * voxels[i].x;
		result.y[i] = weight * voxels[i].y;
		result.z[i] = weight * voxels[i].z;
	}
	return result;
}
}  // namespace

void describe(FieldVisitor& fields, VoxelGridConfig& config)
{
	fields.real("voxel_size", config.voxel_size_m, {0.01, 1.0}, "m",
	            "Edge of the voxels whose points are replaced by their centroid (paper: 0.05 m).");
}

PointCloud voxelGrid(const PointCloud& points, const VoxelGridConfig& config)
{
	const float voxels_per_m = 1.0F / static_cast<float>(config.voxel_size_m);
	std::array<AxisCells, 3> axes{AxisCells(points.x, voxels_per_m), AxisCells(points.y, voxels_per_m),
	                              AxisCells(points.z, voxels_per_m)};
	const double cells =
	    static_cast<double>(axes[0].count) * static_cast<double>(axes[1].count) * static_cast<double>(axes[2].count);
	return centroids(cells <= kMaxArrayCells
	                     ? sumVoxels(points, voxels_per_m, axes, ArrayIndex(static_cast<std::size_t>(cells)))
	                     : sumVoxels(points, voxels_per_m, axes, HashIndex()));
}
}  // namespace explore

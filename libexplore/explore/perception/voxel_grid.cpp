#include <explore/perception/voxel_grid.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr std::uint32_t kNone = 0;         // voxels count from 1 in the tables, which are born full of zeros
constexpr float kMaxArrayCells = 1 << 23;  // 32 MB; a Kinect's view of 5 m at 5 cm has one million
/** Cells that an array reaches to each side of the origin; adding it rounds borders by at most 1/2000 of a voxel. */
constexpr float kShift = 4096;
}  // namespace

void describe(FieldVisitor& fields, VoxelGridConfig& config)
{
	fields.real("voxel_size", config.voxel_size_m, {0.01, 1.0}, "m",
	            "Edge of the voxels whose points are replaced by their centroid (paper: 0.05 m).");
}

VoxelGrid::VoxelGrid(const Eigen::AlignedBox3f& reach, const VoxelGridConfig& config)
    : m_voxels_per_m(1.0F / static_cast<float>(config.voxel_size_m)),
      // One cell more on both sides: points on the box's faces are rounded to either.
      m_first((reach.min().array() * m_voxels_per_m).floor() - 1.0F)
{
	const Eigen::Array3f last = (reach.max().array() * m_voxels_per_m).floor() + 1.0F;
	const Eigen::Array3f size = last - m_first + 1.0F;
	m_strides = Eigen::Array3f(size.y() * size.z(), size.z(), 1.0F);
	const bool near = m_first.minCoeff() > -kShift && last.maxCoeff() < kShift;
	if (near && size.prod() <= kMaxArrayCells) m_cells.resize(static_cast<std::size_t>(size.prod()), kNone);
}

void VoxelGrid::placesOf(const PointBlock& points, Places& places) const
{
	// Positive numbers are rounded down by a mere conversion, which vectorises; std::floor does not.
	const auto cell = [this](float value, float first)
	{ return static_cast<float>(static_cast<std::int32_t>(value * m_voxels_per_m + kShift)) - (first + kShift); };
	const Eigen::Array3f first = m_first, strides = m_strides;
	for (std::size_t i = 0; i < points.count; ++i)
		places[i] =
		    static_cast<std::int32_t>(cell(points.x[i], first.x()) * strides.x() +
		                              cell(points.y[i], first.y()) * strides.y() + cell(points.z[i], first.z()));
}

void VoxelGrid::addTo(std::uint32_t& voxel, const PointBlock& points, std::size_t i)
{
	if (voxel == kNone)
	{
		m_sums.emplace_back();
		voxel = static_cast<std::uint32_t>(m_sums.size());
	}
	Sum& sum = m_sums[voxel - 1];
	sum.x += points.x[i];
	sum.y += points.y[i];
	sum.z += points.z[i];
	++sum.count;
}

void VoxelGrid::add(const PointBlock& points)
{
	if (m_cells.empty())
	{
		const auto cell = [this](float value) { return std::floor(value * m_voxels_per_m); };
		for (std::size_t i = 0; i < points.count; ++i)
			addTo(m_far_cells[{cell(points.x[i]), cell(points.y[i]), cell(points.z[i])}], points, i);
		return;
	}
	Places places{};
	for (std::size_t begin = 0; begin < points.count; begin += kBlock)
	{
		const PointBlock block{points.x + begin, points.y + begin, points.z + begin,
		                       std::min(kBlock, points.count - begin)};
		placesOf(block, places);
		for (std::size_t i = 0; i < block.count; ++i) addTo(m_cells[static_cast<std::size_t>(places[i])], block, i);
	}
}

PointCloud VoxelGrid::centroids() const
{
	PointCloud result;
	result.reserve(m_sums.size());
	for (const Sum& sum : m_sums)
		result.push_back(Eigen::Vector3f(sum.x, sum.y, sum.z) / static_cast<float>(sum.count));
	return result;
}

PointCloud voxelGrid(const PointCloud& points, const VoxelGridConfig& config)
{
	if (points.empty()) return {};
	Eigen::AlignedBox3f box;
	for (std::size_t i = 0; i < points.size(); ++i) box.extend(points[i]);
	VoxelGrid grid(box, config);
	grid.add(blockOf(points));
	return grid.centroids();
}
}  // namespace explore

#include <explore/core/errors.h>
#include <explore/memory/occupancy.h>
#include <explore/memory/ray_ends.h>
#include <explore/memory/ray_passes.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace explore
{
namespace
{
constexpr int kMargin_blocks = 3;
constexpr double kSameSize = 1e-6;
constexpr int kLastKey = 65535;

std::unique_ptr<octomap::OcTree> emptyMap(const OccupancyConfig& config)
{
	return std::make_unique<octomap::OcTree>(config.resolution_m);
}

std::unique_ptr<octomap::OcTree> checkedMap(std::unique_ptr<octomap::OcTree> map, const OccupancyConfig& config)
{
	if (std::abs(map->getResolution() - config.resolution_m) > kSameSize * config.resolution_m)
		throw ConfigError(mrpt::format("[map] resolution is %g m, but the old map has voxels of %g m: set resolution = %g",
		                               config.resolution_m, map->getResolution(), map->getResolution()));
	map->setProbHit(config.hit_probability);
	return map;
}

/** How far from the camera's block the window must reach. */
int windowReach(const OccupancyConfig& config)
{
	return static_cast<int>(std::ceil(config.range_m / (config.resolution_m * kBlockEdge))) + kMargin_blocks;
}

octomap::OcTreeKey treeKey(const GridKey& voxel)
{
	const auto key = [](int i) { return static_cast<octomap::key_type>(i); };
	return {key(voxel.x()), key(voxel.y()), key(voxel.z())};
}
}  // namespace

Occupancy::Occupancy(const OccupancyConfig& config) : Occupancy(config, emptyMap(config)) {}

Occupancy::Occupancy(const OccupancyConfig& config, std::unique_ptr<octomap::OcTree> map)
    : m_config(config), m_sensor(config), m_store(checkedMap(std::move(map), config), m_sensor.lowest, windowReach(config))
{
}

void Occupancy::insert(const DepthFrame& frame)
{
	m_changes.clear();
	if (frame.image.empty()) return;
	const FrameRays rays = raysOf(frame, m_config);
	m_store.moveTo(blockOfVoxel(rays.origin_key));
	const ReachPyramid pyramid(rays);
	std::vector<VoxelBlock*> in_frame;
	markRayEnds(rays, frame.image, m_store, in_frame);
	markRayPasses(rays, pyramid, static_cast<float>(m_config.range_m), m_store, in_frame);
	for (VoxelBlock* block : in_frame) apply(*block);
}

void Occupancy::apply(VoxelBlock& block)
{
	const auto update = [&](int place, float step)
	{
		const float before = block.log_odds[static_cast<std::size_t>(place)];
		const float sum = (std::isnan(before) ? 0.0F : before) + step;
		setLogOdds(block, place, std::clamp(sum, m_sensor.lowest, m_sensor.highest));
	};
	block.hits.forEach([&](int place) { update(place, m_sensor.hit); });
	block.passes.forEach([&](int place) { update(place, m_sensor.miss); });
	block.hits = {};
	block.passes = {};
	block.in_frame = false;
}

void Occupancy::setLogOdds(VoxelBlock& block, int place, float log_odds)
{
	const float before = std::exchange(block.log_odds[static_cast<std::size_t>(place)], log_odds);
	if (before == log_odds) return;
	block.written = false;
	if (log_odds <= m_sensor.lowest)
		block.settled.set(place);
	else
		block.settled.clear(place);
	const VoxelState was = explore::stateOf(before), is = explore::stateOf(log_odds);
	if (was != is) m_changes.push_back({treeKey(block.voxelAt(place)), was, is});
}

VoxelState Occupancy::stateAt(const Eigen::Vector3d& point_in_map) const
{
	const VoxelBox box = statesIn(Eigen::AlignedBox3d(point_in_map, point_in_map));
	return box.states.empty() ? VoxelState::unknown : box.states.front();
}

VoxelState Occupancy::stateOf(const octomap::OcTreeKey& voxel) const
{
	return explore::stateOf(m_store.logOdds({voxel[0], voxel[1], voxel[2]}));
}

VoxelBox Occupancy::statesIn(const Eigen::AlignedBox3d& box_in_map) const
{
	const auto keys = [&](const Eigen::Vector3d& point) -> Eigen::Array3d
	{ return (point.array() / m_config.resolution_m).floor() + 0.5 * (kLastKey + 1); };
	const Eigen::Array3d low = keys(box_in_map.min()).max(0.0), high = keys(box_in_map.max()).min(kLastKey);
	VoxelBox box;
	if (!(low <= high).all()) return box;
	const GridKey first = low.cast<int>();
	box.first = treeKey(first);
	box.size = high.cast<int>() - first + 1;
	box.states.reserve(static_cast<std::size_t>(box.size.cast<std::ptrdiff_t>().prod()));
	for (int z = 0; z < box.size.z(); ++z)
		for (int y = 0; y < box.size.y(); ++y)
			for (int x = 0; x < box.size.x(); ++x)
				box.states.push_back(explore::stateOf(m_store.logOdds(first + GridKey(x, y, z))));
	return box;
}

const octomap::OcTree& Occupancy::tree()
{
	m_store.writeAll();
	return m_store.tree();
}
}  // namespace explore

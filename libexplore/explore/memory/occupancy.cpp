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
constexpr double kSameSize = 1e-6;
constexpr int kLastKey = 2 * kOriginKey - 1;

std::unique_ptr<octomap::OcTree> emptyMap(const OccupancyConfig& config)
{
	return std::make_unique<octomap::OcTree>(config.resolution_m);
}

/** The map with the configured sensor model; throws where its voxels have another size. */
std::unique_ptr<octomap::OcTree> preparedMap(std::unique_ptr<octomap::OcTree> map, const OccupancyConfig& config)
{
	if (std::abs(map->getResolution() - config.resolution_m) > kSameSize * config.resolution_m)
		throw ConfigError(
		    mrpt::format("[map] resolution is %g m, but the old map has voxels of %g m: set resolution = %g",
		                 config.resolution_m, map->getResolution(), map->getResolution()));
	map->setProbHit(config.hit_probability);
	map->setProbMiss(config.miss_probability);
	map->setClampingThresMin(config.min_probability);
	map->setClampingThresMax(config.max_probability);
	return map;
}

/** How far from the camera's block the window must reach, in blocks: a voxel leaves it no sooner than the stations that
 *  it was hit from are forgotten. */
int windowReach(const OccupancyConfig& config)
{
	const double reach_m = config.range_m + std::max(config.window_margin_m, Stations::kForgotten_m);
	return static_cast<int>(std::ceil(reach_m / (config.resolution_m * kBlockEdge))) + 1;
}

/** The numbers of the voxel that holds the point; it may be one that no octree has. */
Eigen::Array3d keyOf(const Eigen::Vector3d& point_in_map, const OccupancyConfig& config)
{
	return (point_in_map.array() / config.resolution_m).floor() + kOriginKey;
}

octomap::OcTreeKey treeKey(const GridKey& voxel)
{
	const auto key = [](int i) { return static_cast<octomap::key_type>(i); };
	return {key(voxel.x()), key(voxel.y()), key(voxel.z())};
}
}  // namespace

Occupancy::Occupancy(const OccupancyConfig& config) : Occupancy(config, emptyMap(config)) {}

Occupancy::Occupancy(const OccupancyConfig& config, std::unique_ptr<octomap::OcTree> map)
    : m_config(config),
      m_sensor(config),
      m_store(preparedMap(std::move(map), config), m_sensor.lowest, windowReach(config))
{
}

void Occupancy::insert(const DepthFrame& frame)
{
	m_changes.clear();
	if (frame.image.empty()) return;
	setRays(m_rays, frame, m_config);
	const FrameRays& rays = m_rays;
	m_store.moveTo(blockOfVoxel(rays.origin_key));
	enterStation(rays);
	const ReachPyramid pyramid(rays);
	std::vector<VoxelBlock*> in_frame;
	markRayEnds(rays, frame.image, m_store, in_frame);
	markRayPasses(rays, pyramid, static_cast<float>(m_config.range_m), m_store, in_frame);
	std::vector<MissedVoxel> missed;
	if (m_config.second_look_range_m > 0.0)
		missed = missedAtSecondLook({rays, frame.image, pyramid, m_store, m_stations, m_config});
	for (VoxelBlock* block : in_frame) apply(*block);
	for (const MissedVoxel& voxel : missed) miss(voxel);
}

void Occupancy::enterStation(const FrameRays& rays)
{
	const Eigen::Vector3d in_voxels =
	    (rays.origin_key - kOriginKey).cast<double>().matrix() + rays.origin.cast<double>();
	if (!m_stations.moveTo(in_voxels * m_config.resolution_m)) return;
	for (VoxelBlock* block : m_store.blocks())
	{
		block->hit_station.fill(0);
		block->last_station = 0;
	}
}

void Occupancy::apply(VoxelBlock& block)
{
	const auto update = [&](int place, float step)
	{
		const float before = block.log_odds[static_cast<std::size_t>(place)];
		const float sum = (std::isnan(before) ? 0.0F : before) + step;
		setLogOdds(block, place, std::clamp(sum, m_sensor.lowest, m_sensor.highest));
	};
	block.hits.forEach(
	    [&](int place)
	    {
		    update(place, m_sensor.hit);
		    block.hit_station[static_cast<std::size_t>(place)] = m_stations.current();
		    block.last_station = m_stations.current();
	    });
	block.passes.forEach([&](int place) { update(place, m_sensor.miss); });
	block.hits = {};
	block.passes = {};
	block.in_frame = false;
}

void Occupancy::miss(const MissedVoxel& voxel)
{
	const float log_odds = voxel.block->log_odds[static_cast<std::size_t>(voxel.place)] + m_sensor.miss;
	setLogOdds(*voxel.block, voxel.place, log_odds < 0.0F ? kUnknown : log_odds);
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
	const Eigen::Array3d key = keyOf(point_in_map, m_config);
	if (!(key >= 0.0 && key <= kLastKey).all()) return VoxelState::unknown;
	return explore::stateOf(m_store.logOdds(key.cast<int>()));
}

VoxelState Occupancy::stateOf(const octomap::OcTreeKey& voxel) const
{
	return explore::stateOf(m_store.logOdds({voxel[0], voxel[1], voxel[2]}));
}

VoxelBox Occupancy::statesIn(const Eigen::AlignedBox3d& box_in_map) const
{
	const Eigen::Array3d low = keyOf(box_in_map.min(), m_config).max(0.0);
	const Eigen::Array3d high = keyOf(box_in_map.max(), m_config).min(kLastKey);
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

std::vector<Occupancy::RecentHits> Occupancy::recentHits() const
{
	std::vector<RecentHits> all;
	for (const VoxelBlock* block : m_store.blocks())
	{
		if (!m_stations.isRecent(block->last_station)) continue;
		RecentHits& hits = all.emplace_back(RecentHits{block->key, block->last_station, {}, {}});
		for (int place = 0; place < kBlockVoxels; ++place)
		{
			const std::uint16_t station = block->hit_station[static_cast<std::size_t>(place)];
			if (!m_stations.isRecent(station)) continue;
			hits.places.push_back(static_cast<std::uint16_t>(place));
			hits.stations.push_back(station);
		}
	}
	return all;
}

void Occupancy::takeRecentHits(const std::vector<RecentHits>& hits)
{
	for (const RecentHits& of : hits)
	{
		VoxelBlock& block = m_store.fetch(of.block);
		block.last_station = of.last_station;
		for (std::size_t i = 0; i < of.places.size(); ++i) block.hit_station[of.places[i]] = of.stations[i];
	}
}

const octomap::OcTree& Occupancy::tree()
{
	m_store.writeAll();
	return m_store.tree();
}
}  // namespace explore

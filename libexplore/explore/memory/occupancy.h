// The map of what is occupied, free or unknown, kept from frame to frame as an octomap::OcTree.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/memory/block_store.h>
#include <explore/memory/occupancy_config.h>
#include <explore/memory/second_look.h>
#include <explore/memory/stations.h>

#include <Eigen/Geometry>
#include <memory>
#include <vector>

namespace explore
{
/** A voxel whose state is another than before the last insert(). */
struct VoxelChange
{
	octomap::OcTreeKey key;
	VoxelState before, after;
};

/** The states of a box of voxels: (x, y, z) is at (z · size.y + y) · size.x + x, and its key is first + (x, y, z). */
struct VoxelBox
{
	octomap::OcTreeKey first;
	Eigen::Array3i size = Eigen::Array3i::Zero();
	std::vector<VoxelState> states;
};

/** Frames go in, the map is ready after each. What a frame says is what OctoMap's insertPointCloud would make of all
 * its pixels: a voxel in which a ray ends is hit; one that a ray passes before it ends, or reaches the range, is
 * missed; a hit wins; pixels without return say nothing but for second_look.h. Same frames, same map, to the last bit.
 *
 *  Memory: the octree, 16 bytes a node, grows with the space seen. Of the blocks of 8³ voxels around the camera each
 * that holds anything takes 3.3 kB more: 5 to 10 MB in a building at 5 cm and 5 m, and never above 141 MB there, when
 * all of the window's 35³ places are taken. */
class Occupancy
{
public:
	explicit Occupancy(const OccupancyConfig& config);
	/** Goes on with an older map. Throws ConfigError when its voxels have another size. */
	Occupancy(const OccupancyConfig& config, std::unique_ptr<octomap::OcTree> map);

	/** Adds the depth image of `frame`, seen from map_from_robot + robot_from_camera; a frame without image adds
	 * nothing. Throws InputError for a pose that is not finite or beyond the octree's reach (1638 m at 5 cm). */
	void insert(const DepthFrame& frame);

	[[nodiscard]] VoxelState stateAt(const Eigen::Vector3d& point_in_map) const;
	[[nodiscard]] VoxelState stateOf(const octomap::OcTreeKey& voxel) const;
	/** Of all voxels that touch the box; its part beyond the octree's reach is left out. */
	[[nodiscard]] VoxelBox statesIn(const Eigen::AlignedBox3d& box_in_map) const;
	/** What the last insert() changed, each voxel once. */
	[[nodiscard]] const std::vector<VoxelChange>& changes() const { return m_changes; }

	/** The whole map, brought up to date: what changed since the last call is written now, inner nodes last. Later
	 * frames change it again only through another call. */
	const octomap::OcTree& tree();
	[[nodiscard]] double resolution_m() const { return m_config.resolution_m; }

	/** Writes all that insert() goes on from, or reads it into an empty map that was made alike. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_stations), archive(m_store);
		std::vector<RecentHits> hits = Archive::kReads ? std::vector<RecentHits>() : recentHits();
		archive(hits);
		if (Archive::kReads) takeRecentHits(hits);
	}

private:
	/** What a block has beside its log-odds: which voxels were hit from the recent stations. */
	struct RecentHits
	{
		GridKey block = GridKey::Zero();
		std::uint16_t last_station = 0;
		std::vector<std::uint16_t> places, stations;
	};
	[[nodiscard]] std::vector<RecentHits> recentHits() const;
	void takeRecentHits(const std::vector<RecentHits>& hits);
	void enterStation(const FrameRays& rays);
	void apply(VoxelBlock& block);
	void miss(const MissedVoxel& voxel);
	void setLogOdds(VoxelBlock& block, int place, float log_odds);

	OccupancyConfig m_config;
	SensorModel m_sensor;
	BlockStore m_store;
	Stations m_stations;
	FrameRays m_rays;  ///< of the last frame
	std::vector<VoxelChange> m_changes;
};
}  // namespace explore

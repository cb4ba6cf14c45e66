// OctoMap's own insertion of depth frames, the reference that the map is compared with, and how far two maps agree.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/memory/occupancy_config.h>
#include <octomap/OcTree.h>

#include <memory>

namespace explore::test
{
/** The frame's valid pixels as points in the map frame. */
octomap::Pointcloud cloudInMap(const DepthFrame& frame);
octomap::point3d cameraInMap(const DepthFrame& frame);

/** An empty tree with the configured sensor model. */
std::unique_ptr<octomap::OcTree> peerTree(const OccupancyConfig& config);

/** Intersection over union of the voxels of one state, as doc/definitions.md has it. */
struct MapAgreement
{
	std::size_t occupied_in_both = 0, occupied_in_either = 0, free_in_both = 0, free_in_either = 0;
	std::size_t wrongly_freed = 0;  ///< free, but occupied in the reference
	std::size_t reference_occupied = 0;

	[[nodiscard]] double occupiedIou() const { return share(occupied_in_both, occupied_in_either); }
	[[nodiscard]] double freeIou() const { return share(free_in_both, free_in_either); }
	[[nodiscard]] double wronglyFreedShare() const { return share(wrongly_freed, reference_occupied); }

private:
	static double share(std::size_t part, std::size_t all)
	{
		return static_cast<double>(part) / static_cast<double>(all);
	}
};
MapAgreement agreement(const octomap::OcTree& map, const octomap::OcTree& reference);
}  // namespace explore::test

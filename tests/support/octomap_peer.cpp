#include "octomap_peer.h"

#include <explore/core/geometry.h>

namespace explore::test
{
namespace
{
/** Calls visit(key, occupied) for every voxel of the lowest level that a leaf stands for. */
template <class Visit>
void forEachVoxel(const octomap::OcTree& tree, const Visit& visit)
{
	for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf)
	{
		const octomap::OcTreeKey first = leaf.getIndexKey();
		const int edge = 1 << (tree.getTreeDepth() - leaf.getDepth());
		for (int x = 0; x < edge; ++x)
			for (int y = 0; y < edge; ++y)
				for (int z = 0; z < edge; ++z)
				{
					const auto key = [](int i) { return static_cast<octomap::key_type>(i); };
					visit(octomap::OcTreeKey(key(first[0] + x), key(first[1] + y), key(first[2] + z)),
					      tree.isNodeOccupied(*leaf));
				}
	}
}
}  // namespace

octomap::point3d cameraInMap(const DepthFrame& frame)
{
	const Eigen::Vector3f at = isometryOf(frame.map_from_robot + frame.robot_from_camera).translation().cast<float>();
	return {at.x(), at.y(), at.z()};
}

octomap::Pointcloud cloudInMap(const DepthFrame& frame)
{
	const Eigen::Isometry3d map_from_camera = isometryOf(frame.map_from_robot + frame.robot_from_camera);
	const CameraIntrinsics& camera = frame.image.intrinsics;
	octomap::Pointcloud cloud;
	cloud.reserve(frame.image.depth_m.size());
	for (int v = 0; v < camera.height_px; ++v)
		for (int u = 0; u < camera.width_px; ++u)
			if (const double depth_m = frame.image.at(u, v); depth_m > 0.0)
			{
				const Eigen::Vector3f point = (map_from_camera * (depth_m * rayOfPixel(camera, u, v))).cast<float>();
				cloud.push_back(point.x(), point.y(), point.z());
			}
	return cloud;
}

std::unique_ptr<octomap::OcTree> peerTree(const OccupancyConfig& config)
{
	auto tree = std::make_unique<octomap::OcTree>(config.resolution_m);
	tree->setProbHit(config.hit_probability);
	tree->setProbMiss(config.miss_probability);
	tree->setClampingThresMin(config.min_probability);
	tree->setClampingThresMax(config.max_probability);
	return tree;
}

MapAgreement agreement(const octomap::OcTree& map, const octomap::OcTree& reference)
{
	MapAgreement result;
	forEachVoxel(reference,
	             [&](const octomap::OcTreeKey& key, bool occupied)
	             {
		             const octomap::OcTreeNode* node = map.search(key);
		             const bool also_occupied = node != nullptr && map.isNodeOccupied(node);
		             const bool also_free = node != nullptr && !also_occupied;
		             (occupied ? result.occupied_in_either : result.free_in_either) += 1;
		             if (occupied && also_occupied) ++result.occupied_in_both;
		             if (!occupied && also_free) ++result.free_in_both;
		             if (occupied) ++result.reference_occupied;
		             if (occupied && also_free) ++result.wrongly_freed;
	             });
	forEachVoxel(map,
	             [&](const octomap::OcTreeKey& key, bool occupied)
	             {
		             const octomap::OcTreeNode* node = reference.search(key);
		             const bool same = node != nullptr && reference.isNodeOccupied(node) == occupied;
		             if (!same) (occupied ? result.occupied_in_either : result.free_in_either) += 1;
	             });
	return result;
}
}  // namespace explore::test

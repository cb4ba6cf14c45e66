// The blocks around the camera, found by their keys at once, and the octree that holds all of the map.
#pragma once

#include <explore/memory/voxel_block.h>
#include <octomap/OcTree.h>

#include <memory>
#include <string>
#include <vector>

namespace explore
{
/** A window of (2 · reach + 1)³ places for blocks over the tree. Only blocks that were asked for take memory; what gets
 *  out of the window lives in the tree alone, to the last bit, so that where the window was makes no difference. */
class BlockStore
{
public:
	/** Voxels of `lowest` log-odds count as settled. */
	BlockStore(std::unique_ptr<octomap::OcTree> tree, float lowest, int reach_blocks);

	/** Puts the window around `center`; blocks that fall out of it are written to the tree and forgotten. */
	void moveTo(const GridKey& center);

	[[nodiscard]] bool contains(const GridKey& block) const
	{
		return (block >= m_first).all() && (block < m_first + m_edge).all();
	}
	/** The number of a block's place, for keys in the window. */
	[[nodiscard]] int placeOf(const GridKey& block) const
	{
		const GridKey at = block - m_first;
		return (at.x() * m_edge + at.y()) * m_edge + at.z();
	}
	/** The block at a place of the window; none where none was fetched. */
	[[nodiscard]] VoxelBlock* at(int place) const { return m_places[static_cast<std::size_t>(place)]; }
	[[nodiscard]] VoxelBlock* find(const GridKey& block) const
	{
		return contains(block) ? at(placeOf(block)) : nullptr;
	}
	/** The block of that key in the window; from the tree where it was not there yet. */
	VoxelBlock& fetch(const GridKey& block);

	/** The middle of a voxel, map frame [m]. */
	[[nodiscard]] Eigen::Vector3d centerOf(const GridKey& voxel) const;
	/** Of any voxel of the map; kUnknown where no ray came. */
	[[nodiscard]] float logOdds(const GridKey& voxel) const;

	/** Writes the block to the tree; nodes above blocks stay as they are. */
	void write(VoxelBlock& block);
	/** Writes what is not yet in the tree, and all nodes above. */
	void writeAll();

	/** The blocks in the window, in the order of their places. */
	[[nodiscard]] std::vector<VoxelBlock*> blocks() const;
	[[nodiscard]] const octomap::OcTree& tree() const { return *m_tree; }
	[[nodiscard]] const GridKey& first() const { return m_first; }
	[[nodiscard]] int edge() const { return m_edge; }

	/** Writes the whole map, or reads it into an empty store that was made alike. What the tree does not have, the
	 *  stations of blocks, is left out. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		std::string tree = Archive::kReads ? std::string() : treeBytes();
		archive(m_first), archive(tree);
		if (Archive::kReads) readTree(tree);
	}

private:
	/** All blocks written, in OctoMap's own format without its header; empty for an empty tree. */
	[[nodiscard]] std::string treeBytes();
	void readTree(const std::string& bytes);
	VoxelBlock& spareBlock();

	std::unique_ptr<octomap::OcTree> m_tree;
	float m_lowest;
	int m_edge;
	GridKey m_first = GridKey::Zero();
	std::vector<VoxelBlock*> m_places;
	std::vector<std::unique_ptr<VoxelBlock>> m_pool;  ///< all blocks ever made
	std::vector<VoxelBlock*> m_spare;                 ///< those not in the window
};
}  // namespace explore

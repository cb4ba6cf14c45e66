#include <explore/memory/block_store.h>
#include <explore/memory/block_tree.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

namespace explore
{
BlockStore::BlockStore(std::unique_ptr<octomap::OcTree> tree, float lowest, int reach_blocks)
    : m_tree(std::move(tree)),
      m_lowest(lowest),
      m_edge(2 * reach_blocks + 1),
      m_places(static_cast<std::size_t>(m_edge) * static_cast<std::size_t>(m_edge) * static_cast<std::size_t>(m_edge))
{
}

void BlockStore::moveTo(const GridKey& center)
{
	const GridKey first = center - m_edge / 2;
	if ((first == m_first).all()) return;
	const std::vector<VoxelBlock*> before = blocks();
	m_first = first;
	std::ranges::fill(m_places, nullptr);
	for (VoxelBlock* block : before)
		if (contains(block->key))
			m_places[static_cast<std::size_t>(placeOf(block->key))] = block;
		else
		{
			write(*block);
			m_spare.push_back(block);
		}
}

VoxelBlock& BlockStore::spareBlock()
{
	if (m_spare.empty())
	{
		m_pool.push_back(std::make_unique<VoxelBlock>());
		m_spare.push_back(m_pool.back().get());
	}
	VoxelBlock& block = *m_spare.back();
	m_spare.pop_back();
	block = VoxelBlock{};
	return block;
}

VoxelBlock& BlockStore::fetch(const GridKey& block)
{
	VoxelBlock*& place = m_places[static_cast<std::size_t>(placeOf(block))];
	if (place == nullptr)
	{
		place = &spareBlock();
		place->key = block;
		place->log_odds = readBlock(*m_tree, block);
		for (int i = 0; i < kBlockVoxels; ++i)
			if (place->log_odds[static_cast<std::size_t>(i)] <= m_lowest) place->settled.set(i);
	}
	return *place;
}

Eigen::Vector3d BlockStore::centerOf(const GridKey& voxel) const
{
	return (voxel.cast<double>() - kOriginKey + 0.5) * m_tree->getResolution();
}

float BlockStore::logOdds(const GridKey& voxel) const
{
	if (const VoxelBlock* block = find(blockOfVoxel(voxel)))
		return block->log_odds[static_cast<std::size_t>(placeInBlock(voxel.x(), voxel.y(), voxel.z()))];
	const auto key = [](int i) { return static_cast<octomap::key_type>(i); };
	const auto* node = m_tree->search(octomap::OcTreeKey(key(voxel.x()), key(voxel.y()), key(voxel.z())));
	return node == nullptr ? kUnknown : node->getLogOdds();
}

void BlockStore::write(VoxelBlock& block)
{
	if (std::exchange(block.written, true)) return;
	writeBlock(*m_tree, block.key, block.log_odds);
}

void BlockStore::writeAll()
{
	for (VoxelBlock* block : blocks()) write(*block);
	updateInnerNodes(*m_tree);
}

std::string BlockStore::treeBytes()
{
	for (VoxelBlock* block : blocks()) write(*block);
	if (m_tree->getRoot() == nullptr) return {};
	std::ostringstream bytes;
	m_tree->writeData(bytes);
	return std::move(bytes).str();
}

void BlockStore::readTree(const std::string& bytes)
{
	m_tree->clear();
	if (bytes.empty()) return;
	std::istringstream stream(bytes);
	m_tree->readData(stream);
}

std::vector<VoxelBlock*> BlockStore::blocks() const
{
	std::vector<VoxelBlock*> all;
	all.reserve(m_pool.size());
	std::ranges::copy_if(m_places, std::back_inserter(all), [](const VoxelBlock* block) { return block != nullptr; });
	return all;
}
}  // namespace explore

#include <explore/memory/block_tree.h>

#include <algorithm>
#include <span>

namespace explore
{
namespace
{
using Node = octomap::OcTreeNode;
constexpr int kLeafDepth = 16;
constexpr int kBlockDepth = kLeafDepth - kBlockBits;

octomap::OcTreeKey firstVoxel(const GridKey& block)
{
	const auto key = [](int i) { return static_cast<octomap::key_type>(i * kBlockEdge); };
	return {key(block.x()), key(block.y()), key(block.z())};
}

unsigned int childOnTheWay(const octomap::OcTreeKey& key, int depth)
{
	return octomap::computeChildIdx(key, kLeafDepth - 1 - depth);
}

void readNode(const octomap::OcTree& tree, const Node& node, std::span<float> values)
{
	if (!tree.nodeHasChildren(&node))
	{
		std::ranges::fill(values, node.getLogOdds());
		return;
	}
	const std::size_t octant = values.size() / 8;
	for (unsigned int i = 0; i < 8; ++i)
		if (tree.nodeChildExists(&node, i))
			readNode(tree, *tree.getNodeChild(&node, i), values.subspan(i * octant, octant));
}

bool isKnown(float log_odds)
{
	return !std::isnan(log_odds);
}

/** Makes the node a leaf. OcTree frees a node's table of children only when it prunes. */
void collapse(octomap::OcTree& tree, Node& node)
{
	if (!tree.nodeHasChildren(&node)) return;
	for (unsigned int i = 0; i < 8; ++i)
	{
		Node& child = tree.nodeChildExists(&node, i) ? *tree.getNodeChild(&node, i) : *tree.createNodeChild(&node, i);
		collapse(tree, child);
		child.setLogOdds(0.0F);
	}
	tree.pruneNode(&node);
}

void erase(octomap::OcTree& tree, Node& node, unsigned int child)
{
	collapse(tree, *tree.getNodeChild(&node, child));
	tree.deleteNodeChild(&node, child);
}

/** `values` have at least one that is known. */
void writeNode(octomap::OcTree& tree, Node& node, std::span<const float> values)
{
	const bool uniform = std::ranges::all_of(values, [&](float value) { return value == values.front(); });
	if (uniform && !tree.nodeHasChildren(&node))
	{
		node.setLogOdds(values.front());
		return;
	}
	const std::size_t octant = values.size() / 8;
	for (unsigned int i = 0; i < 8; ++i)
	{
		const std::span<const float> part = values.subspan(i * octant, octant);
		const bool exists = tree.nodeChildExists(&node, i);
		if (std::ranges::any_of(part, isKnown))
			writeNode(tree, *(exists ? tree.getNodeChild(&node, i) : tree.createNodeChild(&node, i)), part);
		else if (exists)
			erase(tree, node, i);
	}
	if (!tree.pruneNode(&node)) node.updateOccupancyChildren();
}

/** The node of a block, made where there is none. */
Node& blockNode(octomap::OcTree& tree, const octomap::OcTreeKey& key)
{
	Node* node = tree.getRoot();
	bool made = false;
	for (int depth = 0; depth < kBlockDepth; ++depth)
	{
		// An older node without children stands for all of its space.
		if (!made && !tree.nodeHasChildren(node)) tree.expandNode(node);
		const unsigned int child = childOnTheWay(key, depth);
		made = !tree.nodeChildExists(node, child);
		node = made ? tree.createNodeChild(node, child) : tree.getNodeChild(node, child);
	}
	return *node;
}

bool hasOtherChildren(const octomap::OcTree& tree, const Node& node, unsigned int child)
{
	for (unsigned int i = 0; i < 8; ++i)
		if (i != child && tree.nodeChildExists(&node, i)) return true;
	return false;
}

/** Removes the block from below `node`, unless there is nothing else below it: then returns true, and `node` itself is
 *  to be removed, as without children it would be a leaf. */
bool eraseBlock(octomap::OcTree& tree, Node& node, const octomap::OcTreeKey& key, int depth)
{
	if (!tree.nodeHasChildren(&node)) tree.expandNode(&node);
	const unsigned int child = childOnTheWay(key, depth);
	if (!tree.nodeChildExists(&node, child)) return false;
	if (depth + 1 < kBlockDepth && !eraseBlock(tree, *tree.getNodeChild(&node, child), key, depth + 1)) return false;
	if (!hasOtherChildren(tree, node, child)) return true;
	erase(tree, node, child);
	return false;
}

void updateNode(octomap::OcTree& tree, Node& node, int depth)
{
	if (depth == kBlockDepth || !tree.nodeHasChildren(&node)) return;
	for (unsigned int i = 0; i < 8; ++i)
		if (tree.nodeChildExists(&node, i)) updateNode(tree, *tree.getNodeChild(&node, i), depth + 1);
	if (!tree.pruneNode(&node)) node.updateOccupancyChildren();
}
}  // namespace

BlockValues readBlock(const octomap::OcTree& tree, const GridKey& block)
{
	BlockValues values;
	values.fill(kUnknown);
	const Node* node = tree.getRoot();
	if (node == nullptr) return values;
	const octomap::OcTreeKey key = firstVoxel(block);
	for (int depth = 0; depth < kBlockDepth && tree.nodeHasChildren(node); ++depth)
	{
		const unsigned int child = childOnTheWay(key, depth);
		if (!tree.nodeChildExists(node, child)) return values;
		node = tree.getNodeChild(node, child);
	}
	readNode(tree, *node, values);
	return values;
}

void writeBlock(octomap::OcTree& tree, const GridKey& block, const BlockValues& values)
{
	const octomap::OcTreeKey key = firstVoxel(block);
	if (std::ranges::none_of(values, isKnown))
	{
		if (tree.getRoot() != nullptr && eraseBlock(tree, *tree.getRoot(), key, 0)) tree.clear();
		return;
	}
	// The tree itself makes its root with the first value that it gets.
	if (tree.getRoot() == nullptr) tree.setNodeValue(key, 0.0F, true);
	writeNode(tree, blockNode(tree, key), values);
}

void updateInnerNodes(octomap::OcTree& tree)
{
	if (tree.getRoot() != nullptr) updateNode(tree, *tree.getRoot(), 0);
}
}  // namespace explore

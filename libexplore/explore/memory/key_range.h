// Ranges of voxel numbers: those that a band of heights touches, and those that a leaf of the octree stands for.
#pragma once

#include <octomap/OcTree.h>

#include <algorithm>

namespace explore
{
/** Voxel numbers from first to last, ends included; empty where last < first. They are those of octomap::OcTreeKey. */
struct KeyRange
{
	int first = 0, last = -1;

	[[nodiscard]] int size() const { return std::max(0, last - first + 1); }
	[[nodiscard]] bool contains(int key) const { return first <= key && key <= last; }
	[[nodiscard]] KeyRange common(const KeyRange& other) const
	{
		return {std::max(first, other.first), std::min(last, other.last)};
	}
	/** The smallest range that holds both. */
	[[nodiscard]] KeyRange with(const KeyRange& other) const
	{
		if (other.size() == 0) return *this;
		return size() == 0 ? other : KeyRange{std::min(first, other.first), std::max(last, other.last)};
	}
};

/** The voxels that the band touches along one axis of the map; those that it only touches at its upper end do not
 *  count. Empty where high_m is not above low_m. */
KeyRange keysBetween(double low_m, double high_m, double resolution_m);

struct KeyBox
{
	KeyRange x, y, z;
};

/** Calls visit(KeyBox, bool occupied) for each leaf of the map: a cube of voxels of one state. */
template <class Visit>
void forEachLeaf(const octomap::OcTree& map, const Visit& visit)
{
	for (auto leaf = map.begin_leafs(), end = map.end_leafs(); leaf != end; ++leaf)
	{
		const octomap::OcTreeKey first = leaf.getIndexKey();
		const int more = (1 << (map.getTreeDepth() - leaf.getDepth())) - 1;
		visit(KeyBox{{first[0], first[0] + more}, {first[1], first[1] + more}, {first[2], first[2] + more}},
		      map.isNodeOccupied(*leaf));
	}
}
}  // namespace explore

// A map whose voxels change at random, and what changed in it: what incremental layers are tested with.
#pragma once

#include <explore/memory/occupancy.h>

#include <array>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace explore::test
{
/** In a box of 2.4 m × 1.8 m, from 0.7 m below the map's origin to 2.4 m above. */
class RandomVoxels
{
public:
	explicit RandomVoxels(std::uint32_t seed) : m_random(seed) {}

	/** Gives that many voxels new states, mostly free or unknown. Those of the last call are in changes(). */
	void change(int count, const Eigen::Array3i& shift = {0, 0, 0})
	{
		m_changes.clear();
		for (int i = 0; i < count; ++i) changeOne(shift);
	}
	[[nodiscard]] octomap::OcTree map() const
	{
		octomap::OcTree map(0.05);
		for (const auto& [voxel, state] : m_states)
			if (state != VoxelState::unknown)
				map.setNodeValue(keyOf(voxel), state == VoxelState::occupied ? 2.0F : -1.5F);
		return map;
	}
	[[nodiscard]] const std::vector<VoxelChange>& changes() const { return m_changes; }

private:
	using Voxel = std::array<int, 3>;

	void changeOne(const Eigen::Array3i& shift)
	{
		const auto draw = [&](int first, int count)
		{ return kOriginKey + first + static_cast<int>(m_random() % static_cast<unsigned>(count)); };
		const Voxel voxel{shift.x() + draw(-20, 48), shift.y() + draw(-9, 36), shift.z() + draw(-14, 62)};
		const unsigned dice = m_random() % 100;
		VoxelState after = VoxelState::unknown;
		if (dice < 60) after = dice < 3 ? VoxelState::occupied : VoxelState::free;
		const VoxelState before = std::exchange(m_states[voxel], after);
		if (before != after) m_changes.push_back({keyOf(voxel), before, after});
	}
	static octomap::OcTreeKey keyOf(const Voxel& voxel)
	{
		const auto number = [&](std::size_t axis) { return static_cast<octomap::key_type>(voxel[axis]); };
		return {number(0), number(1), number(2)};
	}

	std::mt19937 m_random;
	std::map<Voxel, VoxelState> m_states;
	std::vector<VoxelChange> m_changes;
};
}  // namespace explore::test

// A cube of 8 × 8 × 8 voxels, the unit in which the map is kept near the camera.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace explore
{
enum class VoxelState : std::uint8_t
{
	unknown,
	free,
	occupied,
};

/** Log-odds of a voxel that no ray has reached. Every comparison with it is false. */
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

[[nodiscard]] inline VoxelState stateOf(float log_odds)
{
	if (std::isnan(log_odds)) return VoxelState::unknown;
	return log_odds >= 0.0F ? VoxelState::occupied : VoxelState::free;
}

/** A voxel's or block's number along x, y and z of the map. A voxel's are those of its octomap::OcTreeKey, 32768 at the
 *  map's origin; a block's are its voxels' divided by 8. */
using GridKey = Eigen::Array3i;

constexpr int kOriginKey = 32768;  // of the first voxel above the map's origin

constexpr int kBlockBits = 3;
constexpr int kBlockEdge = 1 << kBlockBits;
constexpr int kBlockVoxels = kBlockEdge * kBlockEdge * kBlockEdge;

[[nodiscard]] inline GridKey blockOfVoxel(const GridKey& voxel)
{
	return {voxel.x() >> kBlockBits, voxel.y() >> kBlockBits, voxel.z() >> kBlockBits};
}

/** Where a voxel's three lowest key bits put it in its block: in octree order, so that each octant, and each octant's
 *  octants, lie together as OcTree has them. */
[[nodiscard]] constexpr int placeInBlock(int x, int y, int z)
{
	const auto spread = [](int bits) { return (bits & 1) | ((bits & 2) << 2) | ((bits & 4) << 4); };
	return spread(x) | (spread(y) << 1) | (spread(z) << 2);
}
/** The inverse: 0–7 along each axis. */
[[nodiscard]] constexpr std::array<int, 3> coordinatesOfPlace(int place)
{
	const auto gather = [](int bits) { return (bits & 1) | ((bits >> 2) & 2) | ((bits >> 4) & 4); };
	return {gather(place), gather(place >> 1), gather(place >> 2)};
}

/** One bit a voxel, by its place in the block. */
struct VoxelBits
{
	std::array<std::uint64_t, kBlockVoxels / 64> words{};

	void set(int place) { words[static_cast<std::size_t>(place) / 64] |= bit(place); }
	[[nodiscard]] bool test(int place) const { return (words[static_cast<std::size_t>(place) / 64] & bit(place)) != 0; }
	void clear(int place) { words[static_cast<std::size_t>(place) / 64] &= ~bit(place); }
	/** The bits of places 8 · octet … 8 · octet + 7: a cube of 2³ voxels. */
	[[nodiscard]] std::uint8_t octet(int octet) const
	{
		return static_cast<std::uint8_t>(words[static_cast<std::size_t>(octet) / 8] >> (8 * (octet % 8)));
	}
	void setOctet(int octet, std::uint8_t bits)
	{
		words[static_cast<std::size_t>(octet) / 8] |= std::uint64_t{bits} << (8 * (octet % 8));
	}
	[[nodiscard]] bool all() const
	{
		return std::ranges::all_of(words, [](std::uint64_t word) { return word == ~std::uint64_t{0}; });
	}
	[[nodiscard]] bool any() const
	{
		return std::ranges::any_of(words, [](std::uint64_t word) { return word != 0; });
	}
	friend VoxelBits operator|(VoxelBits a, const VoxelBits& b)
	{
		for (std::size_t i = 0; i < a.words.size(); ++i) a.words[i] |= b.words[i];
		return a;
	}
	/** Calls visit(place) for each set bit, in order. */
	template <class Visit>
	void forEach(const Visit& visit) const
	{
		for (std::size_t i = 0; i < words.size(); ++i)
			for (std::uint64_t rest = words[i]; rest != 0; rest &= rest - 1)
				visit(static_cast<int>(64 * i) + std::countr_zero(rest));
	}

private:
	static std::uint64_t bit(int place) { return std::uint64_t{1} << (static_cast<unsigned>(place) % 64); }
};

using BlockValues = std::array<float, kBlockVoxels>;

struct VoxelBlock
{
	GridKey key = GridKey::Zero();
	BlockValues log_odds{};  ///< by place; kUnknown where no ray came
	/** Where the camera was (stations.h) at each voxel's last hit; 0 = never, or too long ago. */
	std::array<std::uint16_t, kBlockVoxels> hit_station{};
	std::uint16_t last_station = 0;  ///< the latest of them
	VoxelBits settled;               ///< those that cannot get any freer
	VoxelBits hits, passes;          ///< of the frame that is being inserted
	bool in_frame = false;           ///< there are any
	bool written = true;             ///< the tree has these log-odds

	[[nodiscard]] GridKey voxelAt(int place) const;
};
}  // namespace explore

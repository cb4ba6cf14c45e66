// Rays in packets: the 4 × 4 pixels of a tile at a time, which is how neighbouring rays are traced fastest.
#pragma once

#include <explore/simulation/ray_scene.h>

#include <array>
#include <cstddef>

namespace explore::simulation
{
constexpr int kTileSide = 4;
constexpr int kLanes = kTileSide * kTileSide;  ///< lane = row · 4 + column within the tile

// NOLINTBEGIN(modernize-avoid-c-arrays): as in Embree's own packets, so that loops over both vectorise alike
struct alignas(64) TileVectors
{
	float x[kLanes], y[kLanes], z[kLanes];
};

/** −1 = true, 0 = false, as Embree wants it. */
struct alignas(64) TileMask
{
	std::array<int, kLanes> lane{};
	int& operator[](int i) { return lane[static_cast<std::size_t>(i)]; }
	int operator[](int i) const { return lane[static_cast<std::size_t>(i)]; }
};

/** As RayHit, a lane each; material = kNoHit where nothing was hit. */
struct alignas(64) TileHits
{
	double distance[kLanes];
	TileVectors normal;
	std::uint32_t material[kLanes], body[kLanes];
	std::int32_t moving[kLanes];
};
// NOLINTEND(modernize-avoid-c-arrays)

/** Which lanes of the tile whose first pixel is in column `u`, row `v` lie in the image. */
TileMask tileInside(int u, int v, int width, int height);

/** Traces rays that share one end. `scene` outlives it. The constructor throws std::invalid_argument for an origin that
 *  is not finite. */
class TileTracer
{
public:
	TileTracer(const RayScene& scene, const Eigen::Vector3d& origin, Panes panes);

	/** As RayScene::cast() for the lanes of `valid`; a direction that is not finite hits nothing. */
	void cast(const TileVectors& directions, const TileMask& valid, double max_distance, TileHits& hits) const;
	/** As RayScene::occluded() between the origin and the points `to`, for the lanes of `valid` (not finite: false). */
	[[nodiscard]] TileMask occluded(const TileVectors& to, const TileMask& valid, double margin_m) const;

private:
	const RayScene& m_scene;
	Eigen::Vector3d m_origin;
	Panes m_panes;
};
}  // namespace explore::simulation

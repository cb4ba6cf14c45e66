#include <explore/simulation/parallel_rows.h>
#include <explore/simulation/ray_packets.h>

#include <algorithm>
#include <cstddef>

namespace explore::simulation
{
namespace
{
/** Calls work(pixel of lane, lane) for the lanes of `mask`. */
template <class Work>
void forLanes(const TileMask& mask, int u, int v, int width, const Work& work)
{
	for (int i = 0; i < kLanes; ++i)
		if (mask[i] != 0)
			work(static_cast<std::size_t>(v + i / kTileSide) * static_cast<std::size_t>(width) +
			         static_cast<std::size_t>(u + i % kTileSide),
			     i);
}

template <class Work>
void forTiles(int width, int height, int threads, const Work& work)
{
	parallelRows(height, kTileSide, threads,
	             [&](int first, int last)
	             {
		             for (int v = first; v < last; v += kTileSide)
			             for (int u = 0; u < width; u += kTileSide) work(u, v, tileInside(u, v, width, height));
	             });
}

/** Lanes that are not in the mask get the vector (1, 0, 0). */
TileVectors vectorsOf(std::span<const Eigen::Vector3f> image, const TileMask& mask, int u, int v, int width)
{
	TileVectors vectors;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
	std::fill_n(vectors.x, kLanes, 1.0F);
	std::fill_n(vectors.y, kLanes, 0.0F);
	std::fill_n(vectors.z, kLanes, 0.0F);
	forLanes(mask, u, v, width,
	         [&](std::size_t pixel, int i)
	         {
		         vectors.x[i] = image[pixel].x();
		         vectors.y[i] = image[pixel].y();
		         vectors.z[i] = image[pixel].z();
	         });
	return vectors;
}
}  // namespace

void RayScene::castImage(const Eigen::Vector3d& origin, std::span<const Eigen::Vector3f> directions, int width,
                         int height, double max_distance, std::span<RayHit> hits, int threads) const
{
	const TileTracer tracer(*this, origin, Panes::block);
	forTiles(width, height, threads,
	         [&](int u, int v, const TileMask& inside)
	         {
		         TileHits found;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled by the packet
		         const TileVectors along = vectorsOf(directions, inside, u, v, width);
		         tracer.cast(along, inside, max_distance, found);
		         forLanes(inside, u, v, width,
		                  [&](std::size_t pixel, int i)
		                  {
			                  hits[pixel] = {found.distance[i],
			                                 {found.normal.x[i], found.normal.y[i], found.normal.z[i]},
			                                 found.material[i],
			                                 found.moving[i],
			                                 found.body[i]};
		                  });
	         });
}

void RayScene::occludedImage(const Eigen::Vector3d& from, std::span<const Eigen::Vector3f> to, int width, int height,
                             double margin_m, std::span<std::uint8_t> occluded, int threads, Panes panes) const
{
	const TileTracer tracer(*this, from, panes);
	forTiles(width, height, threads,
	         [&](int u, int v, const TileMask& inside)
	         {
		         const TileMask dark = tracer.occluded(vectorsOf(to, inside, u, v, width), inside, margin_m);
		         forLanes(inside, u, v, width,
		                  [&](std::size_t pixel, int i) { occluded[pixel] = dark[i] != 0 ? 1 : 0; });
	         });
}
}  // namespace explore::simulation

#include <explore/core/vector_code.h>
#include <explore/simulation/parallel_rows.h>
#include <explore/simulation/projector_shadow.h>
#include <explore/simulation/sensor_view.h>
#include <explore/simulation/sight.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace explore::simulation
{
namespace
{
constexpr double kPastRange = 1.05;  ///< noise may bring into range what is just out of it
constexpr double kPictureReach_m = 200.0;
constexpr double kShadowMargin_m = 0.005;
constexpr double kNearestUnseen_m = 0.3;  ///< nothing nearer stands beside the picture and throws a shadow into it
constexpr int kGrain = 16;

/** What the inner loop asks of a material. */
struct Look
{
	bool simple = true;  ///< the ray ends here
	std::uint8_t black = 0;
	float reflectance = 0;
};

/** What the lanes of a tile see, worked out for all alike; what of it holds is decided later. */
struct alignas(64) TileSight
{
	float depth[kLanes], cosine[kLanes], disparity[kLanes];  // NOLINT(modernize-avoid-c-arrays): as TileVectors
	TileVectors points;
};

[[gnu::always_inline]] inline void workOut(const TileVectors& along, const TileHits& hits,
                                           const Eigen::Vector3f& origin, float focal_baseline, TileSight& sight)
{
	const float from_x = origin.x(), from_y = origin.y(), from_z = origin.z();
	for (int i = 0; i < kLanes; ++i)
	{
		const float x = along.x[i], y = along.y[i], z = along.z[i], depth = static_cast<float>(hits.distance[i]);
		const float against = -(hits.normal.x[i] * x + hits.normal.y[i] * y + hits.normal.z[i] * z);
		sight.depth[i] = depth;
		sight.cosine[i] = std::min(std::max(against / std::sqrt(x * x + y * y + z * z), 0.0F), 1.0F);
		sight.disparity[i] = hits.material[i] == RayScene::kNoHit ? 0.0F : focal_baseline / depth;
		sight.points.x[i] = from_x + depth * x;
		sight.points.y[i] = from_y + depth * y;
		sight.points.z[i] = from_z + depth * z;
	}
}

EXPLORE_VECTOR_CODE(workOutLanes, workOut,
                    (const TileVectors& along, const TileHits& hits, const Eigen::Vector3f& origin,
                     float focal_baseline, TileSight& sight),
                    (along, hits, origin, focal_baseline, sight))

class Looker
{
public:
	Looker(const RayScene& scene, const DepthCameraConfig& config, const Eigen::Isometry3d& map_from_camera,
	       std::uint64_t seed, SensorView& view)
	    : m_scene(scene),
	      m_config(config),
	      m_map_from_camera(map_from_camera),
	      m_range_m(kPastRange * config.max_range_m),
	      m_reach_m(config.color ? kPictureReach_m : m_range_m),
	      m_eye(scene, map_from_camera.translation(), Panes::block),
	      m_projector(scene, map_from_camera * Eigen::Vector3d(0.0, -config.baseline_m, 0.0), Panes::pass),
	      m_follower(scene, m_reach_m, config.glass_dropout, seed),
	      m_view(view)
	{
		for (const Material& material : scene.world().materials)
			m_looks.push_back({material.surface == Surface::matte || material.surface == Surface::black,
			                   static_cast<std::uint8_t>(material.surface == Surface::black ? 1 : 0),
			                   material.color.mean()});
	}

	void look(int row, TileStrip& strip) const;
	void addShadow(int row, const TileStrip& strip) const;

private:
	[[nodiscard]] std::size_t pixelOf(int u, int v) const
	{
		return static_cast<std::size_t>(v) * static_cast<std::size_t>(m_config.intrinsics.width_px) +
		       static_cast<std::size_t>(u);
	}
	[[nodiscard]] TileVectors aim(int u, int v) const;
	[[nodiscard]] bool see(int u, int v, const TileHits& hits, const TileSight& tile, int lane) const;
	[[nodiscard]] bool seeFarther(int u, int v, const TileVectors& along, const TileHits& hits, int lane,
	                              TileVectors& points) const;
	void paint(std::size_t pixel, const Eigen::Vector3f& color) const;

	const RayScene& m_scene;
	const DepthCameraConfig& m_config;
	Eigen::Isometry3d m_map_from_camera;
	double m_range_m, m_reach_m;
	TileTracer m_eye, m_projector;
	SightFollower m_follower;
	SensorView& m_view;
	std::vector<Look> m_looks;  ///< by material
};

/** Directions of the tile at (u, v). */
TileVectors Looker::aim(int u, int v) const
{
	const Eigen::Matrix3f turn = m_map_from_camera.linear().cast<float>();
	const Eigen::Vector3f first = rayOfPixel(m_config.intrinsics, u, v).cast<float>();
	const Eigen::Vector3f next = rayOfPixel(m_config.intrinsics, u + 1, v + 1).cast<float>() - first;
	TileVectors along;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
	for (int i = 0; i < kLanes; ++i)
	{
		const int tile_row = i / kTileSide;
		const float y = first.y() + static_cast<float>(i % kTileSide) * next.y();
		const float z = first.z() + static_cast<float>(tile_row) * next.z();
		along.x[i] = turn(0, 0) + y * turn(0, 1) + z * turn(0, 2);
		along.y[i] = turn(1, 0) + y * turn(1, 1) + z * turn(1, 2);
		along.z[i] = turn(2, 0) + y * turn(2, 1) + z * turn(2, 2);
	}
	return along;
}

void Looker::paint(std::size_t pixel, const Eigen::Vector3f& color) const
{
	for (std::size_t channel = 0; channel < 3; ++channel)
		m_view.rgb[3 * pixel + channel] = static_cast<std::uint8_t>(
		    std::lround(255.0F * std::clamp(color[static_cast<Eigen::Index>(channel)], 0.0F, 1.0F)));
}

/** A pixel of a pane or a mirror, whose point may be another one. Returns whether a shadow can fall there. */
bool Looker::seeFarther(int u, int v, const TileVectors& along, const TileHits& hits, int lane,
                        TileVectors& points) const
{
	const Eigen::Vector3d direction = Eigen::Vector3f(along.x[lane], along.y[lane], along.z[lane]).cast<double>();
	const Eigen::Vector3d origin = m_map_from_camera.translation();
	const RayHit first{hits.distance[lane],
	                   {hits.normal.x[lane], hits.normal.y[lane], hits.normal.z[lane]},
	                   hits.material[lane],
	                   hits.moving[lane],
	                   hits.body[lane]};
	const Sight sight = m_follower.follow(first, origin, direction, u, v);
	const std::size_t pixel = pixelOf(u, v);
	if (m_config.color) paint(pixel, sight.color);
	if (!(sight.distance > 0.0 && sight.distance <= m_range_m)) return false;
	m_view.depth_m[pixel] = static_cast<float>(sight.distance);
	m_view.cosine[pixel] = sight.cosine;
	if (!m_view.reflectance.empty()) m_view.reflectance[pixel] = sight.reflectance;
	m_view.lost[pixel] = sight.lost ? 1 : 0;
	const Eigen::Vector3f point = (origin + sight.distance * direction).cast<float>();
	points.x[lane] = point.x();
	points.y[lane] = point.y();
	points.z[lane] = point.z();
	return !sight.mirrored && !sight.lost;
}

/** Returns whether a shadow can fall there. */
bool Looker::see(int u, int v, const TileHits& hits, const TileSight& tile, int lane) const
{
	const std::size_t pixel = pixelOf(u, v);
	const std::uint32_t material = hits.material[lane];
	if (m_config.color)
		paint(pixel, material == RayScene::kNoHit
		                 ? backgroundColor()
		                 : shaded(m_scene.world().materials[material],
		                          {hits.normal.x[lane], hits.normal.y[lane], hits.normal.z[lane]}));
	if (material == RayScene::kNoHit || hits.distance[lane] > m_range_m) return false;
	const Look& surface = m_looks[material];
	m_view.depth_m[pixel] = tile.depth[lane];
	m_view.cosine[pixel] = tile.cosine[lane];
	if (!m_view.reflectance.empty()) m_view.reflectance[pixel] = surface.reflectance;
	m_view.lost[pixel] = surface.black;
	return surface.black == 0;
}

/** Traces the tiles whose first row is `row`. */
void Looker::look(int row, TileStrip& strip) const
{
	const CameraIntrinsics& camera = m_config.intrinsics;
	const auto focal_baseline = static_cast<float>(camera.fx_px * m_config.baseline_m);
	const Eigen::Vector3f origin = m_map_from_camera.translation().cast<float>();
	for (int tile = 0; tile < strip.tiles; ++tile)
	{
		const int u = tile * kTileSide;
		const TileVectors along = aim(u, row);
		const TileMask inside = tileInside(u, row, camera.width_px, camera.height_px);
		TileHits hits;    // NOLINT(cppcoreguidelines-pro-type-member-init): filled by cast()
		TileSight sight;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled by workOut()
		m_eye.cast(along, inside, m_reach_m, hits);
		workOutLanes(along, hits, origin, focal_baseline, sight);
		TileMask& can_be_dark = strip.can_be_dark[static_cast<std::size_t>(tile)];
		for (int i = 0; i < kLanes; ++i)
		{
			const int column = u + i % kTileSide, v = row + i / kTileSide;
			const bool simple = hits.material[i] == RayScene::kNoHit || m_looks[hits.material[i]].simple;
			const bool reaches = inside[i] != 0 && (simple ? see(column, v, hits, sight, i)
			                                               : seeFarther(column, v, along, hits, i, sight.points));
			can_be_dark[i] = reaches ? -1 : 0;
		}
		strip.points[static_cast<std::size_t>(tile)] = sight.points;
		std::copy_n(sight.disparity, kLanes, &strip.disparity[static_cast<std::size_t>(tile) * kLanes]);
	}
}

/** Takes the light from the points that the projector does not see. */
void Looker::addShadow(int row, const TileStrip& strip) const
{
	const CameraIntrinsics& camera = m_config.intrinsics;
	const auto unseen_px = static_cast<float>(camera.fx_px * m_config.baseline_m / kNearestUnseen_m);
	const std::vector<std::uint8_t> in_doubt = tilesInDoubt(strip, camera.width_px, unseen_px);
	for (int tile = 0; tile < strip.tiles; ++tile)
	{
		const auto index = static_cast<std::size_t>(tile);
		if (in_doubt[index] == 0) continue;
		const TileMask dark = m_projector.occluded(strip.points[index], strip.can_be_dark[index], kShadowMargin_m);
		for (int i = 0; i < kLanes; ++i)
			if (dark[i] != 0) m_view.lost[pixelOf(tile * kTileSide + i % kTileSide, row + i / kTileSide)] = 1;
	}
}
}  // namespace

SensorView lookAround(const RayScene& scene, const DepthCameraConfig& config, const Eigen::Isometry3d& map_from_camera,
                      std::uint64_t seed, bool with_shadow)
{
	const auto pixels =
	    static_cast<std::size_t>(config.intrinsics.width_px) * static_cast<std::size_t>(config.intrinsics.height_px);
	SensorView view;
	view.depth_m.resize(pixels);
	view.cosine.resize(pixels);
	view.lost.resize(pixels);
	if (config.noise == NoiseModel::speckle) view.reflectance.resize(pixels);
	if (config.color) view.rgb.resize(3 * pixels);
	const Looker looker(scene, config, map_from_camera, seed, view);
	parallelRows(config.intrinsics.height_px, kGrain, config.threads,
	             [&](int first, int last)
	             {
		             TileStrip strip(config.intrinsics.width_px);
		             for (int row = first; row < last; row += kTileSide)
		             {
			             looker.look(row, strip);
			             if (with_shadow) looker.addShadow(row, strip);
		             }
	             });
	return view;
}
}  // namespace explore::simulation

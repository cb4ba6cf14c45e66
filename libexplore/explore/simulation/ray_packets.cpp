#include <explore/core/vector_code.h>
#include <explore/simulation/ray_packets.h>
#include <explore/simulation/ray_scene_impl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace explore::simulation
{
namespace
{
RTCIntersectContext coherentContext()
{
	RTCIntersectContext context{};
	rtcInitIntersectContext(&context);
	context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
	return context;
}

/** All but directions and limits. */
void startRays(RTCRay16& ray, const Eigen::Vector3d& origin)
{
	const Eigen::Vector3f start = origin.cast<float>();
	std::fill_n(ray.org_x, kLanes, start.x());
	std::fill_n(ray.org_y, kLanes, start.y());
	std::fill_n(ray.org_z, kLanes, start.z());
	std::fill_n(ray.time, kLanes, 0.0F);
	std::fill_n(ray.mask, kLanes, ~0U);
	std::fill_n(ray.id, kLanes, 0U);
	std::fill_n(ray.flags, kLanes, 0U);
}

/** The planes of the triangles that the lanes hit. */
struct alignas(64) LanePlanes
{
	double x[kLanes], y[kLanes], z[kLanes], offset[kLanes];  // NOLINT(modernize-avoid-c-arrays): as TileVectors
};

/** Distances in double precision, and normals toward the origin. */
[[gnu::always_inline]] inline void refine(const LanePlanes& plane, const Eigen::Vector3d& origin,
                                          const TileVectors& direction, const float* distance, TileHits& hits)
{
	const double x = origin.x(), y = origin.y(), z = origin.z();
	for (int i = 0; i < kLanes; ++i)
	{
		const double height = plane.offset[i] - (plane.x[i] * x + plane.y[i] * y + plane.z[i] * z);
		const double slope = plane.x[i] * static_cast<double>(direction.x[i]) +
		                     plane.y[i] * static_cast<double>(direction.y[i]) +
		                     plane.z[i] * static_cast<double>(direction.z[i]);
		const double toward = slope > 0.0 ? -1.0 : 1.0;
		hits.distance[i] = refinedDistance(height, slope, static_cast<double>(distance[i]));
		hits.normal.x[i] = static_cast<float>(toward * plane.x[i]);
		hits.normal.y[i] = static_cast<float>(toward * plane.y[i]);
		hits.normal.z[i] = static_cast<float>(toward * plane.z[i]);
	}
}

EXPLORE_VECTOR_CODE(refineLanes, refine,
                    (const LanePlanes& plane, const Eigen::Vector3d& origin, const TileVectors& direction,
                     const float* distance, TileHits& hits),
                    (plane, origin, direction, distance, hits))

/** Looks up what stands still; leaves lanes that hit moving bodies for later, and says whether there are any. */
template <class Scene>
bool lookUp(const Scene& scene, const RTCRayHit16& query, LanePlanes& planes, TileHits& hits)
{
	static const Facet kNothing{{Eigen::Vector3d::UnitX(), 0.0}, 0, RayScene::kNoHit, 0};
	bool any_moving = false;
	for (int i = 0; i < kLanes; ++i)
	{
		const bool hit = query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
		const bool still = hit && query.hit.instID[0][i] == RTC_INVALID_GEOMETRY_ID;
		any_moving = any_moving || (hit && !still);
		const Facet& facet = still ? scene.still.facets[query.hit.geomID[i]][query.hit.primID[i]] : kNothing;
		planes.x[i] = facet.plane.normal.x();
		planes.y[i] = facet.plane.normal.y();
		planes.z[i] = facet.plane.normal.z();
		planes.offset[i] = facet.plane.offset;
		hits.material[i] = facet.material;
		hits.body[i] = facet.body;
		hits.moving[i] = -1;
	}
	return any_moving;
}

void store(TileHits& hits, int lane, const RayHit& hit)
{
	hits.distance[lane] = hit.distance;
	hits.normal.x[lane] = hit.normal.x();
	hits.normal.y[lane] = hit.normal.y();
	hits.normal.z[lane] = hit.normal.z();
	hits.material[lane] = hit.material;
	hits.moving[lane] = hit.moving;
	hits.body[lane] = hit.body;
}

/** Directions and limits of the rays to the points; takes away the lanes that have no point, or one too near. Embree
 *  may never return from a packet with values that are not finite, be it in lanes that do not count. */
void aimAt(const TileVectors& to, float margin, RTCRay16& ray, TileMask& valid)
{
	for (int i = 0; i < kLanes; ++i)
	{
		const float dx = to.x[i] - ray.org_x[i], dy = to.y[i] - ray.org_y[i], dz = to.z[i] - ray.org_z[i];
		const float length = std::sqrt(dx * dx + dy * dy + dz * dz);
		const bool usable = valid[i] != 0 && length > 2.0F * margin && length <= std::numeric_limits<float>::max();
		ray.dir_x[i] = usable ? dx : 1.0F;
		ray.dir_y[i] = usable ? dy : 0.0F;
		ray.dir_z[i] = usable ? dz : 0.0F;
		ray.tnear[i] = usable ? margin / length : 1.0F;
		ray.tfar[i] = usable ? 1.0F - margin / length : 0.0F;
		valid[i] = usable ? -1 : 0;
	}
}

/** Aims the lanes; takes away those without a finite direction. Embree does not heed the mask on every processor, but a
 *  ray that ends before it begins. */
void aimAlong(const TileVectors& directions, float far, RTCRay16& ray, TileMask& valid)
{
	for (int i = 0; i < kLanes; ++i)
	{
		const float x = directions.x[i], y = directions.y[i], z = directions.z[i];
		const bool usable =
		    valid[i] != 0 && std::abs(x) + std::abs(y) + std::abs(z) <= std::numeric_limits<float>::max();
		ray.dir_x[i] = usable ? x : 1.0F;
		ray.dir_y[i] = usable ? y : 0.0F;
		ray.dir_z[i] = usable ? z : 0.0F;
		ray.tnear[i] = usable ? 0.0F : 1.0F;
		ray.tfar[i] = usable ? far : 0.0F;
		valid[i] = usable ? -1 : 0;
	}
}

bool any(const TileMask& mask)
{
	return std::any_of(mask.lane.begin(), mask.lane.end(), [](int lane) { return lane != 0; });
}

/** Adds to `dark` the lanes of `left` that something in `scene` is in the way of, and takes them from `left`. */
void findDark(RTCScene scene, RTCRay16& ray, TileMask& left, TileMask& dark)
{
	if (!scene || !any(left)) return;
	RTCIntersectContext context = coherentContext();
	rtcOccluded16(left.lane.data(), scene, &context, &ray);
	for (int i = 0; i < kLanes; ++i)
		if (left[i] != 0 && ray.tfar[i] < 0.0F)
		{
			dark[i] = -1;
			left[i] = 0;
			ray.tnear[i] = 1.0F;
			ray.tfar[i] = 0.0F;
		}
}

}  // namespace

TileMask tileInside(int u, int v, int width, int height)
{
	TileMask inside;
	for (int i = 0; i < kLanes; ++i) inside[i] = u + i % kTileSide < width && v + i / kTileSide < height ? -1 : 0;
	return inside;
}

TileTracer::TileTracer(const RayScene& scene, const Eigen::Vector3d& origin, Panes panes)
    : m_scene(scene), m_origin(origin), m_panes(panes)
{
	if (!origin.allFinite()) throw std::invalid_argument("rays: their origin is not finite");
}

void TileTracer::cast(const TileVectors& directions, const TileMask& valid, double max_distance, TileHits& hits) const
{
	const RayScene::Impl& impl = *m_scene.m_impl;
	const ScenePair scenes = impl.scenes(m_panes);
	RTCRayHit16 query;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled lane by lane
	startRays(query.ray, m_origin);
	TileMask usable = valid;
	aimAlong(directions, static_cast<float>(max_distance), query.ray, usable);
	if (!any(usable)) return static_cast<void>(std::fill_n(hits.material, kLanes, RayScene::kNoHit));
	std::fill_n(query.hit.geomID, kLanes, RTC_INVALID_GEOMETRY_ID);
	std::fill_n(query.hit.instID[0], kLanes, RTC_INVALID_GEOMETRY_ID);
	RTCIntersectContext context = coherentContext();
	rtcIntersect16(usable.lane.data(), scenes.still, &context, &query);
	if (scenes.moving) rtcIntersect16(usable.lane.data(), scenes.moving, &context, &query);

	LanePlanes planes;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled lane by lane
	const bool any_moving = lookUp(impl, query, planes, hits);
	refineLanes(planes, m_origin, directions, query.ray.tfar, hits);
	for (int i = 0; any_moving && i < kLanes; ++i)
		if (query.hit.instID[0][i] != RTC_INVALID_GEOMETRY_ID)
			store(hits, i,
			      impl.resolve(query.hit.instID[0][i], query.hit.geomID[i], query.hit.primID[i],
			                   static_cast<double>(query.ray.tfar[i]), m_origin,
			                   Eigen::Vector3f(directions.x[i], directions.y[i], directions.z[i]).cast<double>()));
}

TileMask TileTracer::occluded(const TileVectors& to, const TileMask& valid, double margin_m) const
{
	const ScenePair scenes = m_scene.m_impl->scenes(m_panes);
	RTCRay16 ray;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled lane by lane
	TileMask left = valid, dark;
	startRays(ray, m_origin);
	aimAt(to, static_cast<float>(margin_m), ray, left);
	findDark(scenes.still, ray, left, dark);
	findDark(scenes.moving, ray, left, dark);
	return dark;
}
}  // namespace explore::simulation

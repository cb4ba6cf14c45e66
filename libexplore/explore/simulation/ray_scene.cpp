#include <explore/simulation/ray_scene_impl.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace explore::simulation
{
namespace
{
constexpr auto kNone = RTC_INVALID_GEOMETRY_ID;

std::vector<Belonging> belongingsOf(const World& world)
{
	std::vector<Belonging> belongings;
	belongings.reserve(world.body_of_triangle.size());
	for (const std::uint32_t body : world.body_of_triangle)
	{
		if (body >= world.bodies.size())
			throw std::invalid_argument("world: a triangle names body " + std::to_string(body) + " of " +
			                            std::to_string(world.bodies.size()));
		belongings.push_back({static_cast<std::uint32_t>(world.bodies[body].material), body});
	}
	return belongings;
}

Eigen::Isometry3d startOf(const MovingBody& body)
{
	Eigen::Isometry3d map_from_body = Eigen::Isometry3d::Identity();
	if (body.track.empty()) return map_from_body;
	const Waypoint& first = body.track.front();
	map_from_body.translate(Eigen::Vector3d(first.position_in_map.x(), first.position_in_map.y(), first.z_m));
	map_from_body.rotate(Eigen::AngleAxisd(first.yaw_rad, Eigen::Vector3d::UnitZ()));
	return map_from_body;
}

RTCRay rayAlong(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double near, double far)
{
	RTCRay ray{};
	ray.org_x = static_cast<float>(origin.x());
	ray.org_y = static_cast<float>(origin.y());
	ray.org_z = static_cast<float>(origin.z());
	ray.dir_x = static_cast<float>(direction.x());
	ray.dir_y = static_cast<float>(direction.y());
	ray.dir_z = static_cast<float>(direction.z());
	ray.tnear = static_cast<float>(near);
	ray.tfar = static_cast<float>(far);
	ray.mask = ~0U;
	return ray;
}

/** Embree may abort or never return when asked about numbers that are not finite as floats. */
bool finite(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
	return a.cast<float>().allFinite() && b.cast<float>().allFinite();
}

RayHit hitOn(const Facet& facet, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double distance)
{
	const ExactPlane& plane = facet.plane;
	const double slope = plane.normal.dot(direction);
	RayHit hit;
	hit.distance = refinedDistance(plane.offset - plane.normal.dot(origin), slope, distance);
	hit.normal = (slope > 0.0 ? Eigen::Vector3d(-plane.normal) : plane.normal).cast<float>();
	hit.material = facet.material;
	hit.body = facet.body;
	return hit;
}
}  // namespace

RayScene::Impl::Impl(const World& the_world, SameRays same)
    : world(the_world),
      device(makeEmbreeDevice(same)),
      still(bake(device.get(), world.mesh, belongingsOf(world), world.materials)),
      moving_scene(makeEmbreeScene(device.get())),
      moving_opaque_scene(makeEmbreeScene(device.get()))
{
	for (const MovingBody& body : world.moving)
	{
		PlacedBody placed;
		placed.mesh =
		    bake(device.get(), body.mesh,
		         std::vector(body.mesh.triangles.size(), Belonging{static_cast<std::uint32_t>(body.material), 0}),
		         world.materials);
		placed.instance.reset(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
		rtcSetGeometryInstancedScene(placed.instance.get(), placed.mesh.scene.get());
		const auto id = static_cast<unsigned>(moving.size());
		rtcAttachGeometryByID(moving_scene.get(), placed.instance.get(), id);
		if (!placed.mesh.opaque_scene) rtcAttachGeometryByID(moving_opaque_scene.get(), placed.instance.get(), id);
		moving.push_back(std::move(placed));
		place(id, startOf(body));
	}
	commit();
}

void RayScene::Impl::place(std::size_t index, const Eigen::Isometry3d& map_from_body)
{
	PlacedBody& body = moving[index];
	body.map_from_body = map_from_body;
	body.body_from_map = map_from_body.inverse();
	const Eigen::Matrix<float, 3, 4> columns = map_from_body.matrix().topRows<3>().cast<float>();
	rtcSetGeometryTransform(body.instance.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
	rtcCommitGeometry(body.instance.get());
}

void RayScene::Impl::commit()  // NOLINT(readability-make-member-function-const): changes what rays hit
{
	rtcCommitScene(moving_scene.get());
	rtcCommitScene(moving_opaque_scene.get());
}

ScenePair RayScene::Impl::scenes(Panes panes) const
{
	const bool block = panes == Panes::block;
	ScenePair pair{still.sceneFor(block), nullptr};
	if (!moving.empty()) pair.moving = block ? moving_scene.get() : moving_opaque_scene.get();
	return pair;
}

RayHit RayScene::Impl::resolve(unsigned instance, unsigned geometry, unsigned primitive, double distance,
                               const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const
{
	if (instance == kNone) return hitOn(still.facets[geometry][primitive], origin, direction, distance);
	const PlacedBody& body = moving[instance];
	RayHit hit = hitOn(body.mesh.facets[geometry][primitive], body.body_from_map * origin,
	                   body.body_from_map.linear() * direction, distance);
	hit.normal = body.map_from_body.linear().cast<float>() * hit.normal;
	hit.moving = static_cast<std::int32_t>(instance);
	return hit;
}

RayScene::RayScene(const World& world, SameRays same) : m_impl(std::make_unique<Impl>(world, same)) {}

RayScene::~RayScene() = default;

const World& RayScene::world() const
{
	return m_impl->world;
}

void RayScene::place(std::span<const Eigen::Isometry3d> map_from_body)
{
	if (map_from_body.size() != m_impl->moving.size())
		throw std::invalid_argument("RayScene::place: " + std::to_string(map_from_body.size()) + " places for " +
		                            std::to_string(m_impl->moving.size()) + " moving bodies");
	for (std::size_t i = 0; i < map_from_body.size(); ++i) m_impl->place(i, map_from_body[i]);
	m_impl->commit();
}

std::vector<Eigen::Isometry3d> RayScene::placement() const
{
	std::vector<Eigen::Isometry3d> map_from_body;
	for (const PlacedBody& body : m_impl->moving) map_from_body.push_back(body.map_from_body);
	return map_from_body;
}

std::optional<RayHit> RayScene::cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                     double max_distance) const
{
	if (!finite(origin, direction)) return std::nullopt;
	RTCRayHit query{rayAlong(origin, direction, 0.0, max_distance), {}};
	query.hit.geomID = query.hit.instID[0] = kNone;
	RTCIntersectContext context{};
	rtcInitIntersectContext(&context);
	const ScenePair scenes = m_impl->scenes(Panes::block);
	rtcIntersect1(scenes.still, &context, &query);
	if (scenes.moving) rtcIntersect1(scenes.moving, &context, &query);
	if (query.hit.geomID == kNone) return std::nullopt;
	return m_impl->resolve(query.hit.instID[0], query.hit.geomID, query.hit.primID, query.ray.tfar, origin, direction);
}

bool RayScene::occluded(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double margin_m, Panes panes) const
{
	const double length = (to - from).norm();
	if (!(length > 2.0 * margin_m)) return false;
	if (!finite(from, to)) return false;
	const double margin = margin_m / length;
	RTCRay ray = rayAlong(from, to - from, margin, 1.0 - margin);
	RTCIntersectContext context{};
	rtcInitIntersectContext(&context);
	const ScenePair scenes = m_impl->scenes(panes);
	rtcOccluded1(scenes.still, &context, &ray);
	if (scenes.moving && ray.tfar >= 0.0F) rtcOccluded1(scenes.moving, &context, &ray);
	return ray.tfar < 0.0F;
}
}  // namespace explore::simulation

// What a RayScene is made of: Embree scenes of all that stands still and of the moving bodies.
#pragma once

#include <explore/simulation/baked_mesh.h>
#include <explore/simulation/ray_scene.h>
#include <explore/simulation/triangle_distance.h>

#include <cmath>
#include <functional>
#include <vector>

namespace explore::simulation
{
/** A moving body: an instance of its own mesh. */
struct PlacedBody
{
	BakedMesh mesh;
	EmbreeHandle<RTCGeometry> instance;
	Eigen::Isometry3d map_from_body = Eigen::Isometry3d::Identity();
	Eigen::Isometry3d body_from_map = Eigen::Isometry3d::Identity();
};

/** Embree's distance is a float's worth of right; the plane of the triangle it found gives all of a double, and the
 *  same on every processor. Slivers, whose plane means little, keep Embree's. `height` = offset − normal · origin,
 *  `slope` = normal · direction. */
[[gnu::always_inline]] inline double refinedDistance(double height, double slope, double distance)
{
	constexpr double kAgreement = 1e-3;
	const double refined = height / slope;
	return std::abs(refined - distance) <= kAgreement * (distance + kAgreement) ? refined : distance;
}

/** What still and moving scene a ray goes through. */
struct ScenePair
{
	RTCScene still = nullptr, moving = nullptr;  ///< moving is null where nothing moves
};

struct RayScene::Impl
{
	Impl(const World& the_world, SameRays same);

	void place(std::size_t index, const Eigen::Isometry3d& map_from_body);
	void commit();
	[[nodiscard]] ScenePair scenes(Panes panes) const;
	/** The hit on a primitive of what stands still, or of the moving body `instance`; its distance is worked out anew
	 * in double precision. */
	[[nodiscard]] RayHit resolve(unsigned instance, unsigned geometry, unsigned primitive, double distance,
	                             const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;

	/** Calls visit(triangle in map) for all that come within `radius_m` of `center` (and some beyond); `visit` returns
	 * the radius to go on with. */
	void visitTriangles(const Eigen::Vector3d& center, double radius_m,
	                    const std::function<double(const Triangle&)>& visit) const;

	const World& world;
	EmbreeHandle<RTCDevice> device;
	BakedMesh still;
	std::vector<PlacedBody> moving;
	EmbreeHandle<RTCScene> moving_scene, moving_opaque_scene;
};
}  // namespace explore::simulation

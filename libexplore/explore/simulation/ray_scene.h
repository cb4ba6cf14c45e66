// Rays, distances and contacts in a world, at one moment of it.
#pragma once

#include <explore/simulation/world.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace explore::simulation
{
struct RayHit
{
	double distance = 0;                                ///< in multiples of the ray's direction
	Eigen::Vector3f normal = Eigen::Vector3f::UnitX();  ///< unit, of the surface, toward the ray's origin
	std::uint32_t material = 0;                         ///< index into World::materials
	std::int32_t moving = -1;                           ///< index into World::moving; −1 = stands still
	std::uint32_t body = 0;                             ///< index into World::bodies where moving < 0
};

/** Whether light ends at a pane of glass. */
enum class Panes
{
	block,
	pass,
};

/** Which processors agree on every ray to the last bit. */
enum class SameRays
{
	on_every_processor,  ///< with AVX2 at least: what recorded logs need
	on_this_processor,   ///< all of its vector instructions, a third faster where there is AVX-512
};

/** `world` outlives it and is not changed. Surfaces count from both sides. Queries are const and may run on several
 *  threads; place() may not run beside them. The constructor throws std::invalid_argument for a world whose indices
 *  point nowhere; triangles with a corner that is not finite are left out. */
class RayScene
{
public:
	explicit RayScene(const World& world, SameRays same = SameRays::on_every_processor);
	~RayScene();
	RayScene(const RayScene&) = delete;
	RayScene& operator=(const RayScene&) = delete;

	[[nodiscard]] const World& world() const;

	/** Puts the moving bodies at these map_from_body, in the order of World::moving. At first each stands where its
	 * track begins. */
	void place(std::span<const Eigen::Isometry3d> map_from_body);
	/** Where they stand now: map_from_body in the order of World::moving. */
	[[nodiscard]] std::vector<Eigen::Isometry3d> placement() const;

	/** The first surface along origin + s · direction, 0 < s ≤ max_distance (in multiples of `direction`). */
	[[nodiscard]] std::optional<RayHit> cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
	                                         double max_distance) const;
	/** As cast() for a whole image at once, origin shared: one hit (or none: material = kNoHit) a direction. The
	 *  directions of a width × height image, row-major, so that neighbours can be traced together. */
	static constexpr std::uint32_t kNoHit = 0xffffffffU;
	void castImage(const Eigen::Vector3d& origin, std::span<const Eigen::Vector3f> directions, int width, int height,
	               double max_distance, std::span<RayHit> hits, int threads = 1) const;

	/** Whether anything stands between two points; `margin_m` at both ends is left out. */
	[[nodiscard]] bool occluded(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double margin_m = 0.005,
	                            Panes panes = Panes::block) const;
	/** Many segments with one shared end, as for a projector's shadow: 1 where occluded, else 0. A `to` that is not
	 *  finite is not looked at and gives 0. */
	void occludedImage(const Eigen::Vector3d& from, std::span<const Eigen::Vector3f> to, int width, int height,
	                   double margin_m, std::span<std::uint8_t> occluded, int threads = 1,
	                   Panes panes = Panes::block) const;

	/** Distance [m] from `point` to the nearest surface, or `max_m` when nothing is nearer. */
	[[nodiscard]] double clearance(const Eigen::Vector3d& point, double max_m) const;
	/** Whether a vertical cylinder (axis through base, upward) touches any surface: also the floor that it stands on,
	 * so give a base a little above it. */
	[[nodiscard]] bool touchesCylinder(const Eigen::Vector3d& base, double radius_m, double height_m) const;
	/** Whether a vertical capsule (a sphere of `radius_m` swept from `low` to `high`) touches any surface. */
	[[nodiscard]] bool touchesCapsule(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double radius_m) const;

private:
	friend class TileTracer;
	struct Impl;
	std::unique_ptr<Impl> m_impl;
};
}  // namespace explore::simulation

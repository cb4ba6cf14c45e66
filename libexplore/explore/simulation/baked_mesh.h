// A triangle mesh as Embree holds it, with the exact plane of each triangle beside it.
#pragma once

#include <embree3/rtcore.h>
#include <explore/simulation/ray_scene.h>

#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace explore::simulation
{
struct EmbreeRelease
{
	void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
	void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
	void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
	void operator()(RTCBuffer buffer) const { rtcReleaseBuffer(buffer); }
};
template <class Pointer>
using EmbreeHandle = std::unique_ptr<std::remove_pointer_t<Pointer>, EmbreeRelease>;

/** One build thread, so that the tree and with it every result is the same on each run. Throws std::runtime_error when
 *  Embree does not start. */
EmbreeHandle<RTCDevice> makeEmbreeDevice(SameRays same);
EmbreeHandle<RTCScene> makeEmbreeScene(RTCDevice device);

/** Points x with normal · x = offset; `normal` is a unit vector, zero for a degenerate triangle. */
struct ExactPlane
{
	Eigen::Vector3d normal;
	double offset = 0;
};

/** What is to be known of a triangle that a ray hits. */
struct Facet
{
	ExactPlane plane;
	std::uint32_t triangle = 0, material = 0, body = 0;
};

/** Opaque triangles are geometry 0 and panes of glass geometry 1 of `scene`. */
struct BakedMesh
{
	const TriangleMesh* mesh = nullptr;
	EmbreeHandle<RTCScene> scene;
	EmbreeHandle<RTCScene> opaque_scene;       ///< without the panes; null when there are none
	std::array<std::vector<Facet>, 2> facets;  ///< by geometry and primitive

	[[nodiscard]] RTCScene sceneFor(bool panes_block) const
	{
		return panes_block || !opaque_scene ? scene.get() : opaque_scene.get();
	}
	[[nodiscard]] std::array<Eigen::Vector3d, 3> corners(std::uint32_t triangle) const;
};

/** What a triangle belongs to: indices into World::materials and World::bodies. */
struct Belonging
{
	std::uint32_t material = 0, body = 0;
};

/** `belongings` has one element a triangle. `mesh` outlives the result. */
BakedMesh bake(RTCDevice device, const TriangleMesh& mesh, const std::vector<Belonging>& belongings,
               const std::vector<Material>& materials);
}  // namespace explore::simulation

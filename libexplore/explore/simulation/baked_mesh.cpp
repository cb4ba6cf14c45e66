#include <explore/simulation/baked_mesh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace explore::simulation
{
namespace
{
void checkIndices(const TriangleMesh& mesh, const std::vector<Belonging>& belongings, std::size_t materials)
{
	if (belongings.size() != mesh.triangles.size())
		throw std::invalid_argument("world: " + std::to_string(mesh.triangles.size()) + " triangles but " +
		                            std::to_string(belongings.size()) + " with a material");
	for (const auto& triangle : mesh.triangles)
		for (const std::uint32_t corner : triangle)
			if (corner >= mesh.vertices.size())
				throw std::invalid_argument("world: a triangle names vertex " + std::to_string(corner) + " of " +
				                            std::to_string(mesh.vertices.size()));
	for (const Belonging& belonging : belongings)
		if (belonging.material >= materials)
			throw std::invalid_argument("world: a triangle names material " + std::to_string(belonging.material) +
			                            " of " + std::to_string(materials));
}

/** Embree reads 16 bytes a vertex. */
EmbreeHandle<RTCBuffer> vertexBuffer(RTCDevice device, const TriangleMesh& mesh)
{
	constexpr std::size_t kStride = 4;
	EmbreeHandle<RTCBuffer> buffer(
	    rtcNewBuffer(device, std::max<std::size_t>(mesh.vertices.size(), 1) * kStride * sizeof(float)));
	auto* out = static_cast<float*>(rtcGetBufferData(buffer.get()));
	for (const Eigen::Vector3f& vertex : mesh.vertices)
	{
		for (int axis = 0; axis < 3; ++axis) out[axis] = vertex[axis];
		out[3] = 0.0F;
		out += kStride;
	}
	return buffer;
}

EmbreeHandle<RTCGeometry> geometryOf(RTCDevice device, RTCBuffer vertices, const TriangleMesh& mesh,
                                     const std::vector<Facet>& chosen)
{
	EmbreeHandle<RTCGeometry> geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
	rtcSetGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices, 0, 4 * sizeof(float),
	                     mesh.vertices.size());
	auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
	    geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), chosen.size()));
	for (const Facet& facet : chosen)
		for (const std::uint32_t corner : mesh.triangles[facet.triangle]) *indices++ = corner;
	rtcCommitGeometry(geometry.get());
	return geometry;
}

ExactPlane planeOf(const std::array<Eigen::Vector3d, 3>& corners)
{
	// Eigen leaves a zero vector as it is when it normalises.
	const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
	return {normal, normal.dot(corners[0])};
}
}  // namespace

EmbreeHandle<RTCDevice> makeEmbreeDevice(SameRays same)
{
	// One instruction set wherever there is AVX2: others round differently, and rays along an edge would fall to its
	// other side.
	const bool everywhere = same == SameRays::on_every_processor;
	EmbreeHandle<RTCDevice> device(
	    rtcNewDevice(everywhere ? "threads=1,set_affinity=0,max_isa=avx2" : "threads=1,set_affinity=0"));
	if (!device) throw std::runtime_error("Embree does not start: error " + std::to_string(rtcGetDeviceError(nullptr)));
	return device;
}

EmbreeHandle<RTCScene> makeEmbreeScene(RTCDevice device)
{
	EmbreeHandle<RTCScene> scene(rtcNewScene(device));
	rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
	return scene;
}

std::array<Eigen::Vector3d, 3> BakedMesh::corners(std::uint32_t triangle) const
{
	const auto& [a, b, c] = mesh->triangles[triangle];
	return {mesh->vertices[a].cast<double>(), mesh->vertices[b].cast<double>(), mesh->vertices[c].cast<double>()};
}

BakedMesh bake(RTCDevice device, const TriangleMesh& mesh, const std::vector<Belonging>& belongings,
               const std::vector<Material>& materials)
{
	checkIndices(mesh, belongings, materials.size());
	BakedMesh baked;
	baked.mesh = &mesh;
	for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
	{
		const bool pane = materials[belongings[i].material].surface == Surface::glass;
		baked.facets[pane ? 1 : 0].push_back(
		    {planeOf(baked.corners(i)), i, belongings[i].material, belongings[i].body});
	}
	const bool has_panes = !baked.facets[1].empty();
	baked.scene = makeEmbreeScene(device);
	if (has_panes) baked.opaque_scene = makeEmbreeScene(device);
	const EmbreeHandle<RTCBuffer> vertices = vertexBuffer(device, mesh);
	for (unsigned geometry_id = 0; geometry_id < 2; ++geometry_id)
	{
		const auto& chosen = baked.facets[geometry_id];
		if (chosen.empty()) continue;
		const auto geometry = geometryOf(device, vertices.get(), mesh, chosen);
		rtcAttachGeometryByID(baked.scene.get(), geometry.get(), geometry_id);
		if (has_panes && geometry_id == 0) rtcAttachGeometryByID(baked.opaque_scene.get(), geometry.get(), geometry_id);
	}
	rtcCommitScene(baked.scene.get());
	if (has_panes) rtcCommitScene(baked.opaque_scene.get());
	return baked;
}
}  // namespace explore::simulation

#include <explore/simulation/world.h>

#include <algorithm>
#include <cctype>

namespace explore::simulation
{
Surface surfaceOf(const std::string& material_name)
{
	std::string lower = material_name;
	std::transform(lower.begin(), lower.end(), lower.begin(),
	               [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
	const auto has = [&lower](const char* word) { return lower.find(word) != std::string::npos; };
	if (lower.starts_with("gazebo/")) return Surface::matte;
	if (has("mirror")) return Surface::mirror;
	if (has("glass")) return Surface::glass;
	return has("black") ? Surface::black : Surface::matte;
}

std::size_t World::add(const std::string& body_name, const TriangleMesh& piece, std::size_t material)
{
	const std::size_t body = bodies.size();
	bodies.push_back({body_name, material});
	append(mesh, piece, Eigen::Isometry3d::Identity());
	body_of_triangle.resize(mesh.triangles.size(), static_cast<std::uint32_t>(body));
	return body;
}

std::size_t World::materialNamed(const std::string& material_name, const Eigen::Vector3f& color)
{
	const auto same = [&material_name](const Material& material) { return material.name == material_name; };
	const auto found = std::find_if(materials.begin(), materials.end(), same);
	const auto index = static_cast<std::size_t>(found - materials.begin());
	if (found == materials.end()) materials.push_back({material_name, surfaceOf(material_name), color});
	return index;
}

Eigen::AlignedBox3f solidBounds(const World& world)
{
	constexpr float kFlat_m = 0.1F;
	std::vector<Eigen::AlignedBox3f> bodies(world.bodies.size());
	for (std::size_t i = 0; i < world.mesh.triangles.size(); ++i)
		for (const std::uint32_t corner : world.mesh.triangles[i])
			bodies[world.body_of_triangle[i]].extend(world.mesh.vertices[corner]);
	Eigen::AlignedBox3f solid;
	for (const Eigen::AlignedBox3f& body : bodies)
		if (!body.isEmpty() && body.sizes().z() > kFlat_m) solid.extend(body);
	return solid;
}

void append(TriangleMesh& mesh, const TriangleMesh& piece, const Eigen::Isometry3d& mesh_from_piece)
{
	const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
	for (const Eigen::Vector3f& vertex : piece.vertices)
		mesh.vertices.emplace_back((mesh_from_piece * vertex.cast<double>()).cast<float>());
	for (const auto& [a, b, c] : piece.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
}
}  // namespace explore::simulation

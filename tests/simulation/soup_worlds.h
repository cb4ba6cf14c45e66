// Worlds of random triangles with slow, obvious answers to what fast code is asked about them.
#pragma once

#include <explore/simulation/world.h>
#include <support/random_points.h>

#include <array>
#include <optional>
#include <vector>

namespace explore::simulation::test
{
using explore::test::randomDirection;
using explore::test::uniform;
using Corners = std::array<Eigen::Vector3d, 3>;

inline TriangleMesh soupMesh(std::mt19937& random, int triangles, double half_size_m, double triangle_size_m)
{
	TriangleMesh mesh;
	for (int i = 0; i < triangles; ++i)
	{
		const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
		const Eigen::Vector3d center(uniform(random, -half_size_m, half_size_m),
		                             uniform(random, -half_size_m, half_size_m),
		                             uniform(random, -half_size_m, half_size_m));
		for (int corner = 0; corner < 3; ++corner)
			mesh.vertices.emplace_back((center + triangle_size_m * randomDirection(random)).cast<float>());
		mesh.triangles.push_back({first, first + 1, first + 2});
	}
	return mesh;
}

/** Three materials by turns, the last of them glass, and `moving` bodies that stand about. */
inline World soupWorld(std::mt19937& random, int triangles, int moving)
{
	World world;
	const std::array<std::size_t, 3> materials{world.materialNamed("wall"), world.materialNamed("wood"),
	                                           world.materialNamed("glass")};
	for (int i = 0; i < 6; ++i)
		world.add("body" + std::to_string(i), soupMesh(random, triangles / 6, 3.0, 0.8),
		          materials[static_cast<std::size_t>(i % 3)]);
	for (int i = 0; i < moving; ++i)
	{
		MovingBody body;
		body.mesh = soupMesh(random, 8, 0.4, 0.5);
		body.material = materials[static_cast<std::size_t>(i % 3)];
		body.track.push_back(
		    {0.0, {uniform(random, -3, 3), uniform(random, -3, 3)}, uniform(random, -1, 1), uniform(random, -3, 3)});
		world.moving.push_back(body);
	}
	return world;
}

inline std::vector<Eigen::Isometry3d> randomPlaces(std::mt19937& random, std::size_t count)
{
	std::vector<Eigen::Isometry3d> places;
	for (std::size_t i = 0; i < count; ++i)
	{
		Eigen::Isometry3d place(Eigen::AngleAxisd(uniform(random, -3, 3), randomDirection(random)));
		place.pretranslate(Eigen::Vector3d(uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -3, 3)));
		places.push_back(place);
	}
	return places;
}

/** A triangle in the map and what it belongs to. */
struct PlacedTriangle
{
	Corners corners;
	std::uint32_t material = 0;
	int moving = -1;
	bool glass = false;
};

inline std::vector<PlacedTriangle> allTriangles(const World& world, const std::vector<Eigen::Isometry3d>& places)
{
	std::vector<PlacedTriangle> all;
	const auto addMesh =
	    [&](const TriangleMesh& mesh, const Eigen::Isometry3d& place, int moving, const auto& materialOf)
	{
		for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
		{
			PlacedTriangle placed;
			for (std::size_t corner = 0; corner < 3; ++corner)
				placed.corners[corner] = place * mesh.vertices[mesh.triangles[i][corner]].cast<double>();
			placed.material = static_cast<std::uint32_t>(materialOf(i));
			placed.moving = moving;
			placed.glass = world.materials[placed.material].surface == Surface::glass;
			all.push_back(placed);
		}
	};
	addMesh(world.mesh, Eigen::Isometry3d::Identity(), -1,
	        [&](std::size_t i) { return world.bodies[world.body_of_triangle[i]].material; });
	for (std::size_t body = 0; body < world.moving.size(); ++body)
		addMesh(world.moving[body].mesh, places[body], static_cast<int>(body),
		        [&](std::size_t) { return world.moving[body].material; });
	return all;
}

/** Where the ray meets the triangle; `margin` tells by how much it stays inside (barycentric, negative = outside). */
struct Crossing
{
	double distance = 0, margin = 0;
};

inline std::optional<Crossing> crossing(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                        const Corners& corners)
{
	Eigen::Matrix3d edges;
	edges << corners[1] - corners[0], corners[2] - corners[0], -direction;
	if (std::abs(edges.determinant()) < 1e-9) return std::nullopt;
	const Eigen::Vector3d solution = edges.fullPivLu().solve(origin - corners[0]);
	const double margin = std::min({solution.x(), solution.y(), 1.0 - solution.x() - solution.y()});
	return Crossing{solution.z(), margin};
}
}  // namespace explore::simulation::test

#include <explore/simulation/polygon.h>
#include <explore/simulation/shapes.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace explore::simulation
{
namespace
{
constexpr double kPi = std::numbers::pi;

/** A closed body around z: `profile` holds (radius, z) from the lower pole to the upper one, both poles left out. */
TriangleMesh lathe(const std::vector<Eigen::Vector2d>& profile, double low_pole_m, double high_pole_m, int sides)
{
	TriangleMesh mesh;
	const auto add = [&mesh](double x, double y, double z)
	{ mesh.vertices.emplace_back(Eigen::Vector3d(x, y, z).cast<float>()); };
	add(0, 0, low_pole_m);
	for (const Eigen::Vector2d& ring : profile)
		for (int i = 0; i < sides; ++i)
		{
			const double angle_rad = 2 * kPi * i / sides;
			add(ring.x() * std::cos(angle_rad), ring.x() * std::sin(angle_rad), ring.y());
		}
	add(0, 0, high_pole_m);
	const auto rings = static_cast<std::uint32_t>(profile.size()), n = static_cast<std::uint32_t>(sides);
	const std::uint32_t low = 0, high = 1 + rings * n;
	for (std::uint32_t i = 0; i < n; ++i)
	{
		const auto at = [i, n](std::uint32_t ring, std::uint32_t step) { return 1 + ring * n + (i + step) % n; };
		mesh.triangles.push_back({low, at(0, 1), at(0, 0)});
		for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
		{
			mesh.triangles.push_back({at(ring, 0), at(ring, 1), at(ring + 1, 1)});
			mesh.triangles.push_back({at(ring, 0), at(ring + 1, 1), at(ring + 1, 0)});
		}
		mesh.triangles.push_back({at(rings - 1, 0), at(rings - 1, 1), high});
	}
	return mesh;
}

/** Adds rings of a sphere around (0, z_m), from the polar angle `from_rad` to `to_rad` (−π/2 = lower pole). */
void addArc(std::vector<Eigen::Vector2d>& profile, double radius_m, double z_m, double from_rad, double to_rad,
            int steps)
{
	for (int i = 0; i <= steps; ++i)
	{
		const double angle_rad = from_rad + (to_rad - from_rad) * i / steps;
		profile.emplace_back(radius_m * std::cos(angle_rad), z_m + radius_m * std::sin(angle_rad));
	}
}

Eigen::Isometry3d at(double x, double y, double z)
{
	return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/** The prism over `outer` less `holes`. Corners are shared, so that it is closed. */
TriangleMesh filledPrism(const std::vector<Eigen::Vector2d>& outer,
                         const std::vector<std::vector<Eigen::Vector2d>>& holes, double height_m)
{
	std::vector<std::vector<Eigen::Vector2d>> rings{outer};
	rings.insert(rings.end(), holes.begin(), holes.end());
	TriangleMesh mesh;
	std::map<std::pair<double, double>, std::uint32_t> number;
	for (std::size_t r = 0; r < rings.size(); ++r)
	{
		const auto first = static_cast<std::uint32_t>(number.size()), n = static_cast<std::uint32_t>(rings[r].size());
		for (const Eigen::Vector2d& corner : rings[r])
		{
			number.emplace(std::pair(corner.x(), corner.y()), static_cast<std::uint32_t>(number.size()));
			for (const double z_m : {0.0, height_m})
				mesh.vertices.emplace_back(Eigen::Vector3d(corner.x(), corner.y(), z_m).cast<float>());
		}
		for (std::uint32_t i = 0; i < n; ++i)
		{
			std::uint32_t a = 2 * (first + i), b = 2 * (first + (i + 1) % n);
			if (r > 0) std::swap(a, b);  // a hole's walls face inward
			mesh.triangles.push_back({a, b, b + 1});
			mesh.triangles.push_back({a, b + 1, a + 1});
		}
	}
	const std::vector<Eigen::Vector2d> cap = withHoles(outer, holes);
	const auto vertex = [&](std::uint32_t i) { return 2 * number.at(std::pair(cap[i].x(), cap[i].y())); };
	for (const auto& [a, b, c] : triangulate(cap))
	{
		mesh.triangles.push_back({vertex(a), vertex(c), vertex(b)});
		mesh.triangles.push_back({vertex(a) + 1, vertex(b) + 1, vertex(c) + 1});
	}
	return mesh;
}
}  // namespace

TriangleMesh boxMesh(const Eigen::Vector3d& size_m)
{
	TriangleMesh mesh;
	for (int corner = 0; corner < 8; ++corner)
	{
		const Eigen::Vector3d sign((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
		                           (corner & 4) != 0 ? 0.5 : -0.5);
		mesh.vertices.emplace_back(size_m.cwiseProduct(sign).cast<float>());
	}
	mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
	                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
	return mesh;
}

TriangleMesh cylinderMesh(double radius_m, double length_m, int sides)
{
	const double half_m = length_m / 2;
	return lathe({{radius_m, -half_m}, {radius_m, half_m}}, -half_m, half_m, sides);
}

TriangleMesh sphereMesh(double radius_m, int rings)
{
	std::vector<Eigen::Vector2d> profile;
	const double step_rad = kPi / rings;
	addArc(profile, radius_m, 0, step_rad - kPi / 2, kPi / 2 - step_rad, rings - 2);
	return lathe(profile, -radius_m, radius_m, 2 * rings);
}

TriangleMesh capsuleMesh(double radius_m, double length_m, int sides)
{
	const int steps = std::max(2, sides / 4);
	const double step_rad = kPi / 2 / steps, half_m = length_m / 2;
	std::vector<Eigen::Vector2d> profile;
	addArc(profile, radius_m, -half_m, step_rad - kPi / 2, 0, steps - 1);
	addArc(profile, radius_m, half_m, 0, kPi / 2 - step_rad, steps - 1);
	return lathe(profile, -half_m - radius_m, half_m + radius_m, sides);
}

TriangleMesh planeMesh(const Eigen::Vector3d& normal, const Eigen::Vector2d& size_m)
{
	// The rotation that turns z onto the normal, as Gazebo places its planes.
	const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
	TriangleMesh mesh;
	for (const Eigen::Vector2d& sign : {Eigen::Vector2d(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
	{
		const Eigen::Vector2d corner = size_m.cwiseProduct(sign) / 2;
		mesh.vertices.emplace_back((turn * Eigen::Vector3d(corner.x(), corner.y(), 0)).cast<float>());
	}
	mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
	return mesh;
}

TriangleMesh prismMesh(std::span<const Eigen::Vector2d> outline, double height_m)
{
	const std::vector<Eigen::Vector2d> corners = tidyOutline(outline);
	return filledPrism(corners, {}, height_m);
}

TriangleMesh prismMesh(std::span<const std::vector<Eigen::Vector2d>> rings, double height_m)
{
	std::vector<std::vector<Eigen::Vector2d>> tidy;
	for (const auto& ring : rings)
		if (auto outline = tidyOutline(ring); !outline.empty()) tidy.push_back(std::move(outline));
	const auto depth_of = [&tidy](const auto& ring)
	{
		return std::count_if(tidy.begin(), tidy.end(),
		                     [&ring](const auto& other) { return &other != &ring && contains(other, ring.front()); });
	};
	TriangleMesh mesh;
	for (const auto& outer : tidy)
	{
		const auto depth = depth_of(outer);
		if (depth % 2 == 1) continue;
		std::vector<std::vector<Eigen::Vector2d>> holes;
		for (const auto& ring : tidy)
			if (depth_of(ring) == depth + 1 && contains(outer, ring.front())) holes.push_back(ring);
		append(mesh, filledPrism(outer, holes, height_m), at(0, 0, 0));
	}
	return mesh;
}

TriangleMesh personMesh(double height_m, double radius_m)
{
	const double leg_top_m = 0.48 * height_m, neck_m = 0.84 * height_m;
	const double leg_radius_m = 0.36 * radius_m, head_radius_m = (height_m - neck_m) / 2;
	TriangleMesh person;
	for (const double side : {-1.0, 1.0})
		append(person, cylinderMesh(leg_radius_m, leg_top_m, 12), at(0, side * 0.5 * radius_m, leg_top_m / 2));
	// Shoulders are wider than the chest is deep.
	TriangleMesh trunk = cylinderMesh(radius_m, neck_m - leg_top_m, 16);
	for (Eigen::Vector3f& vertex : trunk.vertices) vertex.x() *= 0.6F;
	append(person, trunk, at(0, 0, (leg_top_m + neck_m) / 2));
	append(person, sphereMesh(head_radius_m, 8), at(0, 0, neck_m + head_radius_m));
	return person;
}
}  // namespace explore::simulation

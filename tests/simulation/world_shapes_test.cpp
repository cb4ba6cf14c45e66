#include <explore/simulation/polygon.h>
#include <explore/simulation/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace explore::simulation
{
namespace
{
constexpr double kPi = std::numbers::pi;

/** By the divergence theorem: positive and right only where every triangle faces outward. */
double volumeOf(const TriangleMesh& mesh)
{
	double six_volumes = 0;
	for (const auto& [a, b, c] : mesh.triangles)
	{
		const Eigen::Vector3d p = mesh.vertices[a].cast<double>(), q = mesh.vertices[b].cast<double>(),
		                      r = mesh.vertices[c].cast<double>();
		six_volumes += p.dot(q.cross(r));
	}
	return six_volumes / 6;
}

double areaOf(const TriangleMesh& mesh)
{
	double area = 0;
	for (const auto& [a, b, c] : mesh.triangles)
	{
		const Eigen::Vector3d u = (mesh.vertices[b] - mesh.vertices[a]).cast<double>();
		area += u.cross((mesh.vertices[c] - mesh.vertices[a]).cast<double>()).norm() / 2;
	}
	return area;
}

/** Every edge is used once in each sense: no hole, no triangle turned over. */
bool isClosed(const TriangleMesh& mesh)
{
	std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
	for (const auto& triangle : mesh.triangles)
		for (std::size_t i = 0; i < 3; ++i) ++uses[{triangle[i], triangle[(i + 1) % 3]}];
	return std::all_of(uses.begin(), uses.end(),
	                   [&uses](const auto& use)
	                   {
		                   const auto back = uses.find({use.first.second, use.first.first});
		                   return use.second == 1 && back != uses.end() && back->second == 1;
	                   });
}

std::pair<Eigen::Vector3f, Eigen::Vector3f> boundsOf(const TriangleMesh& mesh)
{
	Eigen::Vector3f low = mesh.vertices.front(), high = low;
	for (const Eigen::Vector3f& vertex : mesh.vertices) low = low.cwiseMin(vertex), high = high.cwiseMax(vertex);
	return {low, high};
}

/** Area of the regular polygon that a circle is drawn as. */
double discArea(double radius, int sides)
{
	return 0.5 * sides * radius * radius * std::sin(2 * kPi / sides);
}

TEST(Shapes, BoxFillsItsSize)
{
	const TriangleMesh box = boxMesh({2, 3, 0.5});
	EXPECT_TRUE(isClosed(box));
	EXPECT_NEAR(volumeOf(box), 3.0, 1e-6);
	EXPECT_NEAR(areaOf(box), 2 * (6 + 1 + 1.5), 1e-5);
	EXPECT_TRUE(boundsOf(box).first.isApprox(Eigen::Vector3f(-1, -1.5, -0.25)));
	EXPECT_TRUE(boundsOf(box).second.isApprox(Eigen::Vector3f(1, 1.5, 0.25)));
}

TEST(Shapes, CylinderIsAPrismOfItsPolygon)
{
	for (const int sides : {3, 7, 24})
	{
		const TriangleMesh cylinder = cylinderMesh(0.4, 1.5, sides);
		EXPECT_TRUE(isClosed(cylinder));
		EXPECT_NEAR(volumeOf(cylinder), 1.5 * discArea(0.4, sides), 1e-5);
		EXPECT_FLOAT_EQ(boundsOf(cylinder).first.z(), -0.75F);
		EXPECT_FLOAT_EQ(boundsOf(cylinder).second.z(), 0.75F);
	}
}

TEST(Shapes, SphereNearsItsVolumeFromWithin)
{
	const double ball = 4.0 / 3 * kPi * 0.5 * 0.5 * 0.5;
	const TriangleMesh coarse = sphereMesh(0.5), fine = sphereMesh(0.5, 64);
	for (const TriangleMesh& sphere : {coarse, fine})
	{
		EXPECT_TRUE(isClosed(sphere));
		for (const Eigen::Vector3f& vertex : sphere.vertices) EXPECT_NEAR(vertex.norm(), 0.5, 1e-6);
	}
	EXPECT_LT(volumeOf(coarse), ball);
	EXPECT_GT(volumeOf(coarse), 0.95 * ball);
	EXPECT_NEAR(volumeOf(fine), ball, 0.003 * ball);
}

TEST(Shapes, CapsuleIsACylinderBetweenHalfSpheres)
{
	const double expected = kPi * 0.3 * 0.3 * 1.2 + 4.0 / 3 * kPi * 0.3 * 0.3 * 0.3;
	const TriangleMesh capsule = capsuleMesh(0.3, 1.2, 64);
	EXPECT_TRUE(isClosed(capsule));
	EXPECT_NEAR(volumeOf(capsule), expected, 0.005 * expected);
	EXPECT_TRUE(isClosed(capsuleMesh(0.3, 1.2)));
	EXPECT_TRUE(isClosed(capsuleMesh(0.3, 0.1, 4)));
	EXPECT_FLOAT_EQ(boundsOf(capsule).second.z(), 0.9F);
	for (const Eigen::Vector3f& vertex : capsule.vertices)
	{
		const float beyond = std::max(0.0F, std::abs(vertex.z()) - 0.6F);
		EXPECT_NEAR(std::hypot(vertex.head<2>().norm(), beyond), 0.3, 1e-5);
	}
}

TEST(Shapes, PlaneHasItsAreaAndNormal)
{
	const Eigen::Vector3d normal = Eigen::Vector3d(1, -2, 3).normalized();
	const TriangleMesh plane = planeMesh(7 * normal, {4, 2.5});
	EXPECT_NEAR(areaOf(plane), 10, 1e-5);
	for (const Eigen::Vector3f& vertex : plane.vertices) EXPECT_NEAR(vertex.cast<double>().dot(normal), 0, 1e-6);
	for (const auto& [a, b, c] : plane.triangles)
	{
		const Eigen::Vector3d u = (plane.vertices[b] - plane.vertices[a]).cast<double>();
		EXPECT_GT(u.cross((plane.vertices[c] - plane.vertices[a]).cast<double>()).dot(normal), 0);
	}
	EXPECT_NEAR(planeMesh(Eigen::Vector3d::UnitZ(), {4, 2.5}).vertices[0].x(), -2, 1e-6);
}

TEST(Shapes, PrismOfAnLShapeInEitherSense)
{
	std::vector<Eigen::Vector2d> outline{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
	for (int sense = 0; sense < 2; ++sense)
	{
		const TriangleMesh prism = prismMesh(outline, 2.5);
		EXPECT_TRUE(isClosed(prism));
		EXPECT_NEAR(volumeOf(prism), 2.5 * 6, 1e-5);
		EXPECT_FLOAT_EQ(boundsOf(prism).first.z(), 0);
		EXPECT_FLOAT_EQ(boundsOf(prism).second.z(), 2.5F);
		std::reverse(outline.begin(), outline.end());
	}
}

TEST(Shapes, PrismIgnoresRepeatedAndCollinearCorners)
{
	const std::vector<Eigen::Vector2d> outline{{0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0}};
	const TriangleMesh prism = prismMesh(outline, 1);
	EXPECT_TRUE(isClosed(prism));
	EXPECT_EQ(prism.vertices.size(), 8U);
	EXPECT_NEAR(volumeOf(prism), 4, 1e-6);
}

TEST(Shapes, PrismWithoutAreaIsEmpty)
{
	const std::vector<Eigen::Vector2d> none, two{{0, 0}, {1, 1}}, line{{0, 0}, {1, 1}, {2, 2}, {3, 3}},
	    same{{1, 1}, {1, 1}, {1, 1}};
	for (const auto& outline : {none, two, line, same}) EXPECT_TRUE(prismMesh(outline, 1).triangles.empty());
}

TEST(Shapes, PrismOfRandomStarsHasTheShoelaceArea)
{
	std::mt19937_64 random(7);
	const auto uniform = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
	for (int round = 0; round < 200; ++round)
	{
		std::vector<Eigen::Vector2d> outline;
		const int corners = 3 + static_cast<int>(random() % 40);
		for (int i = 0; i < corners; ++i)
		{
			const double angle = 2 * kPi * (i + 0.5 * uniform()) / corners, radius = 0.2 + 3 * uniform();
			outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
		}
		double twice_area = 0;
		for (std::size_t i = 0; i < outline.size(); ++i)
		{
			const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
			twice_area += a.x() * b.y() - a.y() * b.x();
		}
		const TriangleMesh prism = prismMesh(outline, 2);
		EXPECT_TRUE(isClosed(prism)) << round;
		EXPECT_NEAR(volumeOf(prism), std::abs(twice_area), 1e-4) << round;
	}
}

TEST(Shapes, TriangulationCoversAComb)
{
	// Many reflex corners at equal height: ears with other corners on their edges must wait.
	std::vector<Eigen::Vector2d> comb;
	for (int tooth = 0; tooth < 20; ++tooth)
	{
		comb.emplace_back(2 * tooth, 0), comb.emplace_back(2 * tooth, 5);
		comb.emplace_back(2 * tooth + 1, 5), comb.emplace_back(2 * tooth + 1, 0);
	}
	comb.emplace_back(39, -1), comb.emplace_back(0, -1);
	const TriangleMesh prism = prismMesh(comb, 1);
	EXPECT_TRUE(isClosed(prism));
	EXPECT_NEAR(volumeOf(prism), 20 * 5 + 39, 1e-3);
}

TEST(Shapes, PrismsOfRingsLeaveTheirHolesOpen)
{
	const auto square = [](double x, double y, double side) {
		return std::vector<Eigen::Vector2d>{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
	};
	std::vector<std::vector<Eigen::Vector2d>> rings{square(0, 0, 10), square(1, 1, 3), square(5, 5, 4), square(6, 6, 2),
	                                                square(20, 0, 2)};
	std::reverse(rings[1].begin(), rings[1].end());
	const TriangleMesh prism = prismMesh(rings, 2);
	EXPECT_TRUE(isClosed(prism));
	EXPECT_NEAR(volumeOf(prism), 2 * (100 - 9 - 16 + 4 + 4), 1e-3);
	EXPECT_NEAR(areaOf(prism), 2 * (100 - 9 - 16 + 4 + 4) + 2 * 4 * (10 + 3 + 4 + 2 + 2), 1e-3);
}

TEST(Shapes, PrismsWithManyHolesKeepTheirVolume)
{
	std::mt19937_64 random(13);
	const auto uniform = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
	for (int round = 0; round < 40; ++round)
	{
		std::vector<std::vector<Eigen::Vector2d>> rings{{{0, 0}, {5, 0}, {5, 5}, {0, 5}}};
		double area = 25;
		for (int cell = 0; cell < 25; ++cell)
		{
			if (random() % 2 == 0) continue;
			std::vector<Eigen::Vector2d> hole;
			const int corners = 3 + static_cast<int>(random() % 6);
			for (int i = 0; i < corners; ++i)
			{
				const double angle = 2 * kPi * (i + 0.5 * uniform()) / corners, radius = 0.1 + 0.38 * uniform();
				hole.emplace_back(cell % 5 + 0.5 + radius * std::cos(angle), cell / 5 + 0.5 + radius * std::sin(angle));
			}
			for (std::size_t i = 0; i < hole.size(); ++i)
			{
				const Eigen::Vector2d &a = hole[i], &b = hole[(i + 1) % hole.size()];
				area -= (a.x() * b.y() - a.y() * b.x()) / 2;
			}
			rings.push_back(hole);
		}
		const TriangleMesh prism = prismMesh(rings, 1);
		EXPECT_TRUE(isClosed(prism)) << round;
		EXPECT_NEAR(volumeOf(prism), area, 1e-3) << round;
	}
}

TEST(Shapes, PersonStandsOnTheFloorAndHasItsSize)
{
	const TriangleMesh person = personMesh(1.8, 0.25);
	EXPECT_TRUE(isClosed(person));
	EXPECT_GT(volumeOf(person), 0.04);
	EXPECT_LT(volumeOf(person), 0.25);
	EXPECT_NEAR(boundsOf(person).first.z(), 0, 1e-6);
	EXPECT_NEAR(boundsOf(person).second.z(), 1.8, 1e-6);
	for (const Eigen::Vector3f& vertex : person.vertices) EXPECT_LE(vertex.head<2>().norm(), 0.2501);
	EXPECT_NEAR(boundsOf(person).second.y() - boundsOf(person).first.y(), 0.5, 1e-6);
}
}  // namespace
}  // namespace explore::simulation

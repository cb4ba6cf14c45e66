#include <explore/simulation/ray_scene.h>
#include <explore/simulation/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "soup_worlds.h"

namespace explore::simulation::test
{
namespace
{
World boxAndSphere()
{
	World world;
	TriangleMesh box;
	Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
	at.pretranslate(Eigen::Vector3d(3.0, 0.0, 0.0));
	append(box, boxMesh({1.0, 2.0, 2.0}), at);
	world.add("box", box, world.materialNamed("wall"));
	TriangleMesh sphere;
	at.pretranslate(Eigen::Vector3d(-7.0, 0.0, 0.0));
	append(sphere, sphereMesh(1.0, 64), at);
	world.add("sphere", sphere, world.materialNamed("black rubber"));
	return world;
}

TEST(RayScene, BoxIsHitWhereItsFaceIs)
{
	const World world = boxAndSphere();
	const RayScene scene(world);
	const auto hit = scene.cast({0.0, 0.3, 0.2}, {2.0, 0.0, 0.0}, 10.0);
	ASSERT_TRUE(hit);
	EXPECT_NEAR(hit->distance, 1.25, 1e-9);  // in multiples of a direction 2 long
	EXPECT_TRUE(hit->normal.isApprox(Eigen::Vector3f(-1.0F, 0.0F, 0.0F)));
	EXPECT_EQ(hit->body, 0U);
	EXPECT_EQ(world.materials[hit->material].name, "wall");
	EXPECT_EQ(hit->moving, -1);
}

TEST(RayScene, SurfacesCountFromBothSides)
{
	const World world = boxAndSphere();
	const RayScene scene(world);
	const auto hit = scene.cast({3.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 10.0);  // from within the box
	ASSERT_TRUE(hit);
	EXPECT_NEAR(hit->distance, 0.5, 1e-9);
	EXPECT_LT(hit->normal.x(), 0.0F) << "the normal points toward the origin of the ray";
}

TEST(RayScene, SphereIsHitWithinWhatItsFacetsLeaveOut)
{
	const World world = boxAndSphere();
	const RayScene scene(world);
	std::mt19937 random(5);
	for (int i = 0; i < 200; ++i)
	{
		const Eigen::Vector3d outward = randomDirection(random), center(-4.0, 0.0, 0.0);
		const auto hit = scene.cast(center + 2.0 * outward, -outward, 10.0);
		ASSERT_TRUE(hit);
		EXPECT_NEAR(hit->distance, 1.0, 0.003);
		EXPECT_EQ(hit->body, 1U);
	}
}

TEST(RayScene, NothingBeyondTheGreatestDistanceOrInAnEmptyWorld)
{
	const World world = boxAndSphere();
	const RayScene scene(world);
	EXPECT_FALSE(scene.cast({0, 0, 0}, {1, 0, 0}, 2.4));
	EXPECT_FALSE(scene.cast({0, 0, 0}, {0, 1, 0}, 100.0));
	const World nothing;
	const RayScene empty(nothing);
	EXPECT_FALSE(empty.cast({0, 0, 0}, {1, 0, 0}, 100.0));
	EXPECT_FALSE(empty.occluded({0, 0, 0}, {1, 0, 0}));
	EXPECT_EQ(empty.clearance({0, 0, 0}, 3.0), 3.0);
	EXPECT_FALSE(empty.touchesCylinder({0, 0, 0}, 1.0, 1.0));
}

TEST(RayScene, DistanceIsExactFarFromTheOrigin)
{
	World world;
	TriangleMesh wall;
	Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
	at.pretranslate(Eigen::Vector3d(1000.0, 0.0, 0.0));
	append(wall, planeMesh({-1.0, 0.0, 0.0}, {10.0, 10.0}), at);
	world.add("wall", wall, world.materialNamed("wall"));
	const RayScene scene(world);
	const auto hit = scene.cast({996.87654321, 0.1, 0.2}, {1.0, 0.0, 0.0}, 10.0);
	ASSERT_TRUE(hit);
	EXPECT_NEAR(hit->distance, 3.12345679, 1e-8);
}

/** The nearest crossing, unless it or a nearer one passes so close to an edge that either answer is right. */
struct Expected
{
	bool certain = true;
	double distance = std::numeric_limits<double>::infinity();
	const PlacedTriangle* triangle = nullptr;
};

Expected bruteForceCast(const std::vector<PlacedTriangle>& triangles, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction, double far, bool with_glass = true)
{
	Expected expected;
	for (const PlacedTriangle& triangle : triangles)
	{
		if (triangle.glass && !with_glass) continue;
		const auto found = crossing(origin, direction, triangle.corners);
		if (!found || found->distance <= 0.0 || found->distance >= std::min(far, expected.distance)) continue;
		if (std::abs(found->margin) < 1e-4) expected.certain = false;
		if (found->margin <= 0.0) continue;
		expected.distance = found->distance;
		expected.triangle = &triangle;
	}
	return expected;
}

class RandomWorld : public testing::TestWithParam<unsigned>
{
protected:
	RandomWorld() : m_random(GetParam()), m_world(soupWorld(m_random, 90, 5)), m_scene(m_world)
	{
		const auto places = randomPlaces(m_random, m_world.moving.size());
		m_scene.place(places);
		m_triangles = allTriangles(m_world, places);
	}

	Eigen::Vector3d randomPoint(double half_size)
	{
		return {uniform(m_random, -half_size, half_size), uniform(m_random, -half_size, half_size),
		        uniform(m_random, -half_size, half_size)};
	}
	/** The nearest distance from `point` to any triangle by trying each. */
	[[nodiscard]] double bruteForceClearance(const Eigen::Vector3d& point) const;

	std::mt19937 m_random;
	World m_world;
	RayScene m_scene;
	std::vector<PlacedTriangle> m_triangles;
};

TEST_P(RandomWorld, CastFindsWhatTryingEachTriangleFinds)
{
	int hits = 0, moving = 0;
	for (int i = 0; i < 1000; ++i)
	{
		const Eigen::Vector3d origin = randomPoint(4.0),
		                      direction = uniform(m_random, 0.3, 2.0) * randomDirection(m_random);
		const Expected expected = bruteForceCast(m_triangles, origin, direction, 8.0);
		if (!expected.certain) continue;
		const auto hit = m_scene.cast(origin, direction, 8.0);
		ASSERT_EQ(hit.has_value(), expected.triangle != nullptr);
		if (!hit) continue;
		EXPECT_NEAR(hit->distance, expected.distance, 1e-5);
		EXPECT_EQ(hit->material, expected.triangle->material);
		EXPECT_EQ(hit->moving, expected.triangle->moving);
		EXPECT_LE(hit->normal.cast<double>().dot(direction), 1e-6);
		EXPECT_NEAR(hit->normal.norm(), 1.0F, 1e-5F);
		++hits;
		moving += hit->moving >= 0 ? 1 : 0;
	}
	EXPECT_GT(hits, 80);
	EXPECT_GT(moving, 5);
}

TEST_P(RandomWorld, ImagesHoldWhatSingleRaysFind)
{
	constexpr int kWidth = 45, kHeight = 30;  // no multiples of the tile
	const Eigen::Vector3d origin = randomPoint(1.0);
	std::vector<Eigen::Vector3f> directions;
	for (int i = 0; i < kWidth * kHeight; ++i)
		directions.emplace_back(1.0F, 1.0F - 2.0F * static_cast<float>(i % kWidth) / kWidth,
		                        1.0F - 2.0F * static_cast<float>(i / kWidth) / kHeight);
	std::vector<RayHit> hits(directions.size()), on_three(directions.size());
	m_scene.castImage(origin, directions, kWidth, kHeight, 10.0, hits);
	m_scene.castImage(origin, directions, kWidth, kHeight, 10.0, on_three, 3);
	int differences = 0;
	for (std::size_t i = 0; i < directions.size(); ++i)
	{
		const auto single = m_scene.cast(origin, directions[i].cast<double>(), 10.0);
		const bool same =
		    single ? hits[i].material == single->material && std::abs(hits[i].distance - single->distance) < 1e-6
		           : hits[i].material == RayScene::kNoHit;
		differences += same ? 0 : 1;
		EXPECT_EQ(hits[i].material, on_three[i].material);
		EXPECT_EQ(single ? hits[i].distance : 0.0, single ? on_three[i].distance : 0.0);
	}
	EXPECT_LE(differences, 2) << "only rays along an edge may differ";
}

TEST_P(RandomWorld, OccludedAgreesWithTryingEachTriangle)
{
	constexpr int kCount = 240;
	const Eigen::Vector3d from = randomPoint(3.0);
	std::vector<Eigen::Vector3f> to;
	for (int i = 0; i < kCount; ++i) to.push_back(randomPoint(3.5).cast<float>());
	to[7].setConstant(std::numeric_limits<float>::quiet_NaN());
	std::vector<std::uint8_t> blocked(kCount), through_glass(kCount);
	m_scene.occludedImage(from, to, 20, 12, 0.005, blocked);
	m_scene.occludedImage(from, to, 20, 12, 0.005, through_glass, 2, Panes::pass);
	EXPECT_EQ(blocked[7], 0);
	int glass_only = 0;
	for (std::size_t i = 0; i < kCount; ++i)
	{
		if (i == 7) continue;
		const Eigen::Vector3d target = to[i].cast<double>(), along = target - from;
		const double margin = 0.005 / along.norm();
		const Expected all = bruteForceCast(m_triangles, from + margin * along, along, 1.0 - 2.0 * margin);
		const Expected opaque = bruteForceCast(m_triangles, from + margin * along, along, 1.0 - 2.0 * margin, false);
		if (!all.certain || !opaque.certain) continue;
		EXPECT_EQ(blocked[i] != 0, all.triangle != nullptr);
		EXPECT_EQ(through_glass[i] != 0, opaque.triangle != nullptr);
		EXPECT_EQ(m_scene.occluded(from, target), all.triangle != nullptr);
		EXPECT_EQ(m_scene.occluded(from, target, 0.005, Panes::pass), opaque.triangle != nullptr);
		glass_only += blocked[i] != 0 && through_glass[i] == 0 ? 1 : 0;
	}
	EXPECT_GT(glass_only, 0);
}

constexpr double kAccuracy = 1e-3;

/** The least `distance` of a point on the triangle, or `best` if that is less, by cutting the triangle in four over and
 *  over, and on with the pieces that may hold a nearer point. */
double slowDistance(const Corners& triangle, const std::function<double(const Eigen::Vector3d&)>& distance, double best)
{
	std::vector<Corners> pieces{triangle};
	while (!pieces.empty())
	{
		const Corners corners = pieces.back();
		pieces.pop_back();
		const auto& [a, b, c] = corners;
		const double size = std::max({(a - b).norm(), (b - c).norm(), (c - a).norm()});
		const double nearest_corner = std::min({distance(a), distance(b), distance(c)});
		best = std::min(best, nearest_corner);
		if (nearest_corner - size >= best || size < kAccuracy) continue;
		const Eigen::Vector3d ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
		pieces.insert(pieces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
	}
	return best;
}

double distanceToCylinder(const Eigen::Vector3d& point, const Eigen::Vector3d& base, double radius, double height)
{
	const double beside = std::max(0.0, (point - base).head<2>().norm() - radius);
	const double above = std::max({0.0, base.z() - point.z(), point.z() - base.z() - height});
	return std::hypot(beside, above);
}

double distanceToSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
	const Eigen::Vector3d along = high - low;
	const double s = std::clamp((point - low).dot(along) / along.squaredNorm(), 0.0, 1.0);
	return (low + s * along - point).norm();
}

double RandomWorld::bruteForceClearance(const Eigen::Vector3d& point) const
{
	double nearest = std::numeric_limits<double>::infinity();
	for (const PlacedTriangle& triangle : m_triangles)
		nearest = slowDistance(
		    triangle.corners, [&](const Eigen::Vector3d& on) { return (on - point).norm(); }, nearest);
	return nearest;
}

TEST_P(RandomWorld, ClearanceIsTheDistanceToTheNearestTriangle)
{
	for (int i = 0; i < 25; ++i)
	{
		const Eigen::Vector3d point = randomPoint(4.5);
		EXPECT_NEAR(m_scene.clearance(point, 2.0), std::min(2.0, bruteForceClearance(point)), kAccuracy);
	}
}

TEST_P(RandomWorld, CylindersTouchWhatIsWithinThem)
{
	int touching = 0, tried = 0;
	for (int i = 0; i < 60; ++i)
	{
		const Eigen::Vector3d base = randomPoint(4.0);
		const double radius = uniform(m_random, 0.05, 0.5), height = uniform(m_random, 0.05, 1.5);
		double nearest = std::numeric_limits<double>::infinity();
		for (const PlacedTriangle& triangle : m_triangles)
			nearest = slowDistance(
			    triangle.corners,
			    [&](const Eigen::Vector3d& on) { return distanceToCylinder(on, base, radius, height); }, nearest);
		if (nearest > 0.0 && nearest < kAccuracy) continue;  // a touch that the slow way cannot tell
		EXPECT_EQ(m_scene.touchesCylinder(base, radius, height), nearest == 0.0);
		touching += nearest == 0.0 ? 1 : 0;
		++tried;
	}
	EXPECT_GT(touching, 5);
	EXPECT_GT(tried - touching, 5);
}

TEST_P(RandomWorld, CapsulesTouchWhatIsWithinThem)
{
	int touching = 0, tried = 0;
	for (int i = 0; i < 60; ++i)
	{
		const Eigen::Vector3d low = randomPoint(4.0),
		                      high = low + Eigen::Vector3d(0.0, 0.0, uniform(m_random, 0.1, 1.5));
		const double radius = uniform(m_random, 0.05, 0.5);
		double nearest = std::numeric_limits<double>::infinity();
		for (const PlacedTriangle& triangle : m_triangles)
			nearest = slowDistance(
			    triangle.corners, [&](const Eigen::Vector3d& on) { return distanceToSegment(on, low, high); }, nearest);
		if (std::abs(nearest - radius) < kAccuracy) continue;
		EXPECT_EQ(m_scene.touchesCapsule(low, high, radius), nearest < radius);
		touching += nearest < radius ? 1 : 0;
		++tried;
	}
	EXPECT_GT(touching, 5);
	EXPECT_GT(tried - touching, 5);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomWorld, testing::Values(1U, 2U, 3U, 4U));

TEST(RayScene, MovingBodiesBeginWhereTheirTrackBegins)
{
	World world;
	MovingBody person;
	person.mesh = boxMesh({0.4, 2.0, 3.4});
	person.material = world.materialNamed("cloth");
	person.track = {{0.0, {4.0, 0.0}, 0.0, std::acos(-1.0) / 2}, {5.0, {9.0, 0.0}, 0.0, 0.0}};
	world.moving.push_back(person);
	RayScene scene(world);
	const auto at_start = scene.cast({0, 0, 1}, {1, 0, 0}, 20.0);
	ASSERT_TRUE(at_start);
	EXPECT_NEAR(at_start->distance, 3.0, 1e-6);  // turned by 90°, its 2 m lie along x
	EXPECT_EQ(at_start->moving, 0);

	Eigen::Isometry3d farther = Eigen::Isometry3d::Identity();
	farther.pretranslate(Eigen::Vector3d(7.0, 0.0, 0.0));
	scene.place(std::vector{farther});
	EXPECT_NEAR(scene.cast({0, 0, 1}, {1, 0, 0}, 20.0)->distance, 6.8, 1e-6);
	EXPECT_NEAR(scene.clearance({6.0, 0.0, 1.0}, 5.0), 0.8, 1e-6);
	EXPECT_TRUE(scene.touchesCylinder({6.5, 0.0, 0.5}, 0.31, 0.5));
	EXPECT_FALSE(scene.touchesCylinder({6.5, 0.0, 0.5}, 0.29, 0.5));
	EXPECT_TRUE(scene.touchesCapsule({7.0, 1.5, 0.0}, {7.0, 1.5, 1.0}, 0.51));
	EXPECT_FALSE(scene.touchesCapsule({7.0, 1.5, 0.0}, {7.0, 1.5, 1.0}, 0.49));
	EXPECT_THROW(scene.place({}), std::invalid_argument);
}

TEST(RayScene, LongTrianglesAreTouchedFarFromTheirCorners)
{
	World world;
	TriangleMesh floor = planeMesh({0.0, 0.0, 1.0}, {2000.0, 2000.0});
	world.add("floor", floor, world.materialNamed("floor"));
	const RayScene scene(world);
	EXPECT_FALSE(scene.touchesCylinder({400.0, 300.0, 0.001}, 0.2, 0.6));
	EXPECT_TRUE(scene.touchesCylinder({400.0, 300.0, -0.001}, 0.2, 0.6));
	EXPECT_NEAR(scene.clearance({400.0, 300.0, 0.37}, 1.0), 0.37, 1e-6);
}

TEST(RayScene, ProcessorsDifferInRaysAlongEdgesOnly)
{
	std::mt19937 random(9);
	const World world = soupWorld(random, 300, 2);
	const RayScene everywhere(world), here(world, SameRays::on_this_processor);
	std::vector<Eigen::Vector3f> directions;
	for (int i = 0; i < 200 * 200; ++i)
		directions.emplace_back(1.0F, 1.0F - static_cast<float>(i % 200) / 100.0F,
		                        1.0F - static_cast<float>(i / 200) / 100.0F);
	std::vector<RayHit> first(directions.size()), second(directions.size());
	everywhere.castImage({-4, 0, 0}, directions, 200, 200, 10.0, first);
	here.castImage({-4, 0, 0}, directions, 200, 200, 10.0, second);
	int differences = 0;
	for (std::size_t i = 0; i < first.size(); ++i)
		differences += first[i].material != second[i].material ||
		                       (first[i].material != RayScene::kNoHit && first[i].distance != second[i].distance)
		                   ? 1
		                   : 0;
	EXPECT_LE(differences, 4);
}

TEST(RayScene, RaysThatAreNotFiniteHitNothing)
{
	const World world = boxAndSphere();
	const RayScene scene(world);
	constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kFar = std::numeric_limits<float>::infinity();
	const std::vector<Eigen::Vector3f> directions{{1, 0, 0}, {kNan, 0, 0}, {1, kFar, 0}, {-1, 0, 0}};
	std::vector<RayHit> hits(4);
	scene.castImage({0, 0, 0}, directions, 4, 1, 10.0, hits);
	EXPECT_NEAR(hits[0].distance, 2.5, 1e-9);
	EXPECT_EQ(hits[1].material, RayScene::kNoHit);
	EXPECT_EQ(hits[2].material, RayScene::kNoHit);
	EXPECT_NE(hits[3].material, RayScene::kNoHit);
	EXPECT_FALSE(scene.cast({0, 0, 0}, {static_cast<double>(kNan), 0, 0}, 10.0));
	EXPECT_FALSE(scene.cast({static_cast<double>(kNan), 0, 0}, {1, 0, 0}, 10.0));
	EXPECT_THROW(scene.castImage({static_cast<double>(kNan), 0, 0}, directions, 4, 1, 10.0, hits),
	             std::invalid_argument);
	std::vector<std::uint8_t> occluded(4);
	scene.occludedImage({0, 0, 0}, directions, 4, 1, 0.005, occluded);
	EXPECT_EQ(occluded, std::vector<std::uint8_t>(4, 0));
}

TEST(RayScene, BrokenWorldsAreRefusedAndBrokenCornersLeftOut)
{
	World world = boxAndSphere();
	world.mesh.triangles[3][1] = 99999;
	EXPECT_THROW(RayScene{world}, std::invalid_argument);
	world = boxAndSphere();
	world.body_of_triangle.pop_back();
	EXPECT_THROW(RayScene{world}, std::invalid_argument);
	world = boxAndSphere();
	world.bodies[0].material = 77;
	EXPECT_THROW(RayScene{world}, std::invalid_argument);

	world = boxAndSphere();
	TriangleMesh broken;
	broken.vertices = {{1.0F, -1.0F, -1.0F}, {1.0F, 1.0F, -1.0F}, {1.0F, 0.0F, std::numeric_limits<float>::infinity()}};
	broken.triangles = {{0, 1, 2}};
	world.add("broken", broken, 0);
	const RayScene scene(world);
	EXPECT_NEAR(scene.cast({0, 0, 0}, {1, 0, 0}, 10.0)->distance, 2.5, 1e-9);
	EXPECT_NEAR(scene.clearance({1.0, 0.0, 0.0}, 3.0), 1.5, 1e-9);
}
}  // namespace
}  // namespace explore::simulation::test

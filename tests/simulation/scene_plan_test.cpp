// Floor-plan geometry against slow obvious references.
#include <explore/simulation/random.h>
#include <explore/simulation/scenes/scene_plan.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

using namespace explore::simulation;
using Eigen::Vector2d;

namespace
{
Outline randomRectangle(Random& random)
{
	const WallFrame frame{{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(-4, 4)};
	return rectangleOutline(frame, {0, random.uniform(0.1, 1.5)}, {0, random.uniform(0.1, 1.5)});
}

/** Points all over the rectangle, its edges included. */
std::vector<Vector2d> pointsOf(const Outline& rectangle)
{
	constexpr int kSteps = 60;
	std::vector<Vector2d> points;
	for (int i = 0; i <= kSteps; ++i)
		for (int j = 0; j <= kSteps; ++j)
			points.emplace_back(rectangle[0] + static_cast<double>(i) / kSteps * (rectangle[1] - rectangle[0]) +
			                    static_cast<double>(j) / kSteps * (rectangle[3] - rectangle[0]));
	return points;
}

/** Smallest distance between the points of two rectangles: at most a grid's diagonal too large. */
double sampledDistance(const Outline& a, const Outline& b)
{
	double best = 1e9;
	const auto points = pointsOf(b);
	for (const Vector2d& p : pointsOf(a))
		for (const Vector2d& q : points) best = std::min(best, (p - q).squaredNorm());
	return std::sqrt(best);
}
}  // namespace

TEST(ScenePlan, DistanceAndOverlapAreThoseOfPointsAllOverTheShapes)
{
	constexpr double kGrid_m = 0.04;
	Random random(11);
	int overlaps = 0;
	for (int i = 0; i < 25; ++i)
	{
		const Outline a = randomRectangle(random), b = randomRectangle(random);
		const double sampled_m = sampledDistance(a, b), distance_m = distanceBetween(a, b);
		EXPECT_LE(distance_m, sampled_m + 1e-9);
		EXPECT_GE(distance_m, sampled_m - kGrid_m);
		EXPECT_EQ(overlap(a, b), distance_m == 0);
		overlaps += overlap(a, b) ? 1 : 0;
	}
	EXPECT_GT(overlaps, 3);
	EXPECT_LT(overlaps, 22);
}

TEST(ScenePlan, AWallFrameCountsAlongToTheRightAndBehindAway)
{
	const WallFrame left{{0, 0}, std::numbers::pi / 2};  // the face that somebody sees who looks along −x
	EXPECT_NEAR((left.at(2, 0) - Vector2d(0, 2)).norm(), 0, 1e-12);
	EXPECT_NEAR((left.at(0, 1) - Vector2d(-1, 0)).norm(), 0, 1e-12);
	EXPECT_NEAR((left.outward() - Vector2d(1, 0)).norm(), 0, 1e-12);
	Random random(3);
	for (int i = 0; i < 100; ++i)
	{
		const WallFrame frame{{random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(-9, 9)};
		const Vector2d place(random.uniform(-3, 3), random.uniform(-3, 3));
		EXPECT_NEAR((frame.coordinatesOf(frame.at(place.x(), place.y())) - place).norm(), 0, 1e-9);
	}
}

TEST(ScenePlan, TakenFloorIsNotFreeAndSightlinesLetLowThingsStand)
{
	FloorUse use;
	const WallFrame frame;
	use.take(rectangleOutline(frame, {0, 1}, {0, 1}));
	use.keepLow(rectangleOutline(frame, {2, 3}, {0, 1}), 0.5);
	const auto at = [](double x) { return discOutline({x, 0.5}, 0.1); };
	EXPECT_FALSE(use.isFree(at(0.5), 0.1));
	EXPECT_TRUE(use.isFree(at(1.5), 2.0));
	EXPECT_TRUE(use.isFree(at(2.5), 0.4));
	EXPECT_FALSE(use.isFree(at(2.5), 0.6));
}

TEST(SceneRandom, IsUniformAndGaussianAsItSays)
{
	constexpr int kDraws = 40000;
	Random random(1);
	double sum = 0, squares = 0;
	std::array<int, 5> counts{};
	for (int i = 0; i < kDraws; ++i)
	{
		const double x = random.gaussian(2.0);
		sum += x, squares += x * x;
		++counts.at(static_cast<std::size_t>(random.integer(0, 4)));
	}
	EXPECT_NEAR(sum / kDraws, 0, 0.05);
	EXPECT_NEAR(std::sqrt(squares / kDraws), 2.0, 0.04);
	EXPECT_THAT(counts, testing::Each(testing::AllOf(testing::Gt(kDraws / 5 - 500), testing::Lt(kDraws / 5 + 500))));
	EXPECT_NE(mixed({1, 2}), mixed({2, 1}));
	EXPECT_EQ(hashOf(""), 0xcbf29ce484222325ULL);
	EXPECT_EQ(hashOf("a"), 0xaf63dc4c8601ec8cULL);  // FNV-1a's published test value
}

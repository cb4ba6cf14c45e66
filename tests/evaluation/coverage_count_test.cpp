// Coverage that is counted on, against coverage of the whole map.
#include <explore/evaluation/coverage_count.h>
#include <explore/perception/perceive.h>
#include <gtest/gtest.h>

#include <chrono>

#include "support/analytic_scene.h"

using namespace explore;
using namespace explore::evaluation;
using mrpt::poses::CPose3D;

namespace
{
/** All cells around the corridor, also those in its walls. */
TruthReach aroundTheCorridor(double cell_m, const std::vector<std::pair<double, double>>& levels)
{
	TruthReach reach;
	reach.cell_m = cell_m;
	reach.first_column = static_cast<int>(-1.0 / cell_m);
	reach.first_row = static_cast<int>(-2.0 / cell_m);
	reach.columns = static_cast<int>(11.0 / cell_m);
	reach.rows = static_cast<int>(4.0 / cell_m);
	for (const auto& [low_m, high_m] : levels)
		reach.levels.push_back(
		    {low_m, high_m,
		     std::vector<std::uint8_t>(static_cast<std::size_t>(reach.columns) * static_cast<std::size_t>(reach.rows),
		                               1)});
	return reach;
}

/** A robot that drives along a corridor with a box that is there in every other frame. */
class Drive
{
public:
	void go()
	{
		test::Scene scene = test::corridorScene(9.0, {3.0}, {});
		if (m_count % 2 == 0) scene.box({4.0, 0.3, 0.25}, {0.4, 0.4, 0.5});
		DepthFrame frame =
		    test::renderFrame(scene, CPose3D(0.1 * m_count, 0, 0, 0.05 * m_count, 0, 0), CPose3D(0.1, 0, 0.5, 0, 0, 0),
		                      test::xtionIntrinsics(160, 120), {.axial_scale = 1.0});
		frame.timestamp += m_count++ * std::chrono::milliseconds(250);
		frame.pose_origin = PoseOrigin::odometry;
		Percepts percepts = perceive(frame, {}, {}, m_perception);
		remember(memory, frame, percepts, {}, {});
	}
	FrontierMemory memory{MemoryConfig{}, RobotConfig{}};

private:
	PerceptionMemory m_perception;
	int m_count = 0;
};

void expectSame(const CoverageCount& count, FrontierMemory& memory)
{
	const Coverage whole = coverageOf(count.reach(), memory.map.tree());
	EXPECT_EQ(count.coverage().covered, whole.covered);
	EXPECT_EQ(count.coverage().reachable, whole.reachable);
}
}  // namespace

TEST(CoverageCount, IsThatOfTheWholeMapAfterEveryFrame)
{
	for (const double cell_m : {0.05, 0.15})
	{
		Drive drive;
		CoverageCount ground(aroundTheCorridor(cell_m, {{0.1, 0.6}}));
		CoverageCount flying(aroundTheCorridor(cell_m, {{0.5, 0.55}, {0.6, 0.65}, {1.0, 1.05}}));
		for (int frame = 0; frame < 12; ++frame)
		{
			drive.go();
			ground.follow(drive.memory);
			flying.follow(drive.memory);
			expectSame(ground, drive.memory);
			expectSame(flying, drive.memory);
		}
		EXPECT_GT(ground.coverage().share(), 0.1);
		EXPECT_LT(ground.coverage().share(), 0.9);
	}
}

TEST(CoverageCount, BeginsAgainWhereFramesWereMissed)
{
	Drive drive;
	CoverageCount count(aroundTheCorridor(0.05, {{0.1, 0.6}}));
	EXPECT_EQ(count.coverage().covered, 0U);
	for (const int missed : {2, 0, 3, 1})
	{
		for (int frame = 0; frame <= missed; ++frame) drive.go();
		count.follow(drive.memory);
		expectSame(count, drive.memory);
		count.follow(drive.memory);  // nothing new: nothing is counted twice
		expectSame(count, drive.memory);
	}
}

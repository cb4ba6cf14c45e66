// Scripted runs whose path and goal flips are known.
#include <explore/evaluation/run_watch.h>

#include <gtest/gtest.h>

#include <string_view>

using namespace explore;
using namespace explore::evaluation;

namespace
{
const Eigen::Vector3d kA(10, 0, 0), kB(0, 10, 0), kC(-10, 0, 0), kHere(0, 0, 0);

/** Frames of one second each; the robot stands where it is put. */
class Script
{
public:
	Script& goal(const Eigen::Vector3d& place, int frames = 3, GoalKind kind = GoalKind::frontier)
	{
		for (int i = 0; i < frames; ++i) add(kind, place);
		return *this;
	}
	Script& without(int frames)
	{
		for (int i = 0; i < frames; ++i) add(GoalKind::none, {});
		return *this;
	}
	Script& robotAt(const Eigen::Vector3d& place)
	{
		m_robot = place;
		return *this;
	}
	/** The next frame says that the goal before it was lost. */
	Script& lost()
	{
		m_lost = true;
		return *this;
	}
	[[nodiscard]] const RunWatch& watch() const { return m_watch; }

private:
	void add(GoalKind kind, const std::optional<Eigen::Vector3d>& place)
	{
		WatchedFrame frame;
		frame.t_s = m_t_s++;
		frame.map_from_robot = mrpt::poses::CPose3D(m_robot.x(), m_robot.y(), m_robot.z(), 0, 0, 0);
		frame.goal = kind;
		frame.goal_in_map = place;
		frame.goal_lost = m_lost;
		m_lost = false;
		m_watch.add(frame);
	}

	RunWatch m_watch;
	double m_t_s = 0;
	Eigen::Vector3d m_robot = kHere;
	bool m_lost = false;
};
}  // namespace

TEST(RunWatch, PathIsMeasuredAlongEveryCornerAndHomeStraight)
{
	Script script;
	for (const auto& place : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(3, 4, 0)})
		script.robotAt(place).without(2);
	EXPECT_DOUBLE_EQ(script.watch().path_m(), 7.0);
	EXPECT_DOUBLE_EQ(script.watch().fromStart_m(), 5.0);
	EXPECT_EQ(RunWatch().path_m(), 0.0);
	EXPECT_EQ(RunWatch().fromStart_m(), 0.0);
}

TEST(RunWatch, BackToAGoalJustLeftIsAFlip)
{
	EXPECT_EQ(Script().goal(kA).goal(kB).goal(kA).watch().flips(), 1U);
	EXPECT_EQ(Script().goal(kA).goal(kB).goal(kA).goal(kB).watch().flips(), 2U);
	EXPECT_EQ(Script().goal(kA).goal(kB).goal(kA + Eigen::Vector3d(0.3, 0.3, 0)).watch().flips(), 1U);
	EXPECT_EQ(Script().goal(kA).goal(kB).goal(kC).goal(kA).watch().flips(), 1U) << "by way of a third";
}

TEST(RunWatch, AGoalElsewhereIsNone)
{
	EXPECT_EQ(Script().goal(kA).goal(kB).goal(kC).watch().flips(), 0U);
	EXPECT_EQ(Script().goal(kA).goal(kB).goal(kA + Eigen::Vector3d(0.6, 0, 0)).watch().flips(), 0U);
}

TEST(RunWatch, After20SecondsItIsNone)
{
	EXPECT_EQ(Script().goal(kA).goal(kB, 19).goal(kA).watch().flips(), 1U);
	EXPECT_EQ(Script().goal(kA).goal(kB, 20).goal(kA).watch().flips(), 0U);
}

TEST(RunWatch, WhatWasReachedOrLostMayBeLeft)
{
	EXPECT_EQ(Script().goal(kA).goal(kB).robotAt({0.3, 9.8, 0}).goal(kA).watch().flips(), 0U);
	EXPECT_EQ(Script().goal(kA).goal(kB).robotAt({0.0, 9.4, 0}).goal(kA).watch().flips(), 1U);
	EXPECT_EQ(Script().goal(kA).goal(kB).lost().goal(kA).watch().flips(), 0U);
}

TEST(RunWatch, PausesAndRecoveriesAreNoGoals)
{
	EXPECT_EQ(Script().goal(kA).without(5).goal(kA).watch().flips(), 0U);
	EXPECT_EQ(Script().goal(kA).goal(kHere, 3, GoalKind::recover).goal(kA).watch().flips(), 0U);
	EXPECT_EQ(Script().goal(kA).without(2).goal(kB).without(2).goal(kA).watch().flips(), 1U);
}

TEST(RunWatch, AGoalThatIsSeenEverBetterStaysTheSame)
{
	Script script;
	for (int i = 0; i < 20; ++i) script.goal(kA + Eigen::Vector3d(0.1 * i, 0, 0), 1);
	for (int i = 20; i > 0; --i) script.goal(kA + Eigen::Vector3d(0.1 * i, 0, 0), 1);
	EXPECT_EQ(script.watch().flips(), 0U);
	EXPECT_EQ(Script().goal(kA).goal(kA, 3, GoalKind::look).goal(kA).watch().flips(), 0U);
}

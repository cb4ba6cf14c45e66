#include <explore/navigation/heading.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace explore
{
namespace
{
Avoidance way(double heading_rad, double open_path_m)
{
	Avoidance avoidance;
	avoidance.heading_rad = heading_rad;
	avoidance.open_path_m = open_path_m;
	avoidance.turning_path_m = open_path_m;
	return avoidance;
}

Decision drive(double open_path_m, double current_speed_mps, const HeadingConfig& config = {})
{
	return decide(GoalChoice(), way(0.0, open_path_m), StopReason::none, current_speed_mps, RobotConfig(), config);
}

TEST(StoppingDistance, OfTheDefaultRobot)
{
	EXPECT_DOUBLE_EQ(stoppingDistance(0.0, RobotConfig(), HeadingConfig()), 0.10);
	EXPECT_DOUBLE_EQ(stoppingDistance(0.5, RobotConfig(), HeadingConfig()), 0.25 + 0.15 + 0.10);
}

TEST(SafeSpeed, InvertsStoppingDistance)
{
	std::mt19937 random(5);
	std::uniform_real_distribution<double> speed(1e-4, 3.0), acceleration(0.05, 5.0), reaction(0.0, 1.0),
	    margin(0.0, 0.5);
	for (int trial = 0; trial < 1000; ++trial)
	{
		RobotConfig robot;
		robot.max_speed_mps = 10.0;
		robot.max_acceleration_mps2 = acceleration(random);
		HeadingConfig config;
		config.reaction_time_s = trial % 10 == 0 ? 0.0 : reaction(random);
		config.stop_margin_m = margin(random);
		const double v = speed(random);
		ASSERT_NEAR(safeSpeed(stoppingDistance(v, robot, config), robot, config), v, 1e-9 * (1.0 + 1.0 / v));
	}
}

TEST(SafeSpeed, IsZeroWithinTheMarginAndNeverAboveTheRobots)
{
	EXPECT_EQ(safeSpeed(0.10, RobotConfig(), HeadingConfig()), 0.0);
	EXPECT_EQ(safeSpeed(0.0, RobotConfig(), HeadingConfig()), 0.0);
	EXPECT_GT(safeSpeed(0.11, RobotConfig(), HeadingConfig()), 0.0);
	EXPECT_DOUBLE_EQ(safeSpeed(5.0, RobotConfig(), HeadingConfig()), 0.5);
}

TEST(Decide, DrivesOnInTheOpen)
{
	GoalChoice choice;
	choice.goal.kind = GoalKind::door;
	choice.door_rad = 0.2;
	choice.vanishing_point_rad = -0.1;
	choice.desired_rad = 0.2;
	const Decision decision = decide(choice, way(0.2, 4.0), StopReason::none, 0.5, RobotConfig(), HeadingConfig());
	EXPECT_FALSE(decision.stop);
	EXPECT_EQ(decision.stop_reason, StopReason::none);
	EXPECT_EQ(decision.goal.kind, GoalKind::door);
	EXPECT_EQ(decision.headings.door_rad, 0.2);
	EXPECT_EQ(decision.headings.vanishing_point_rad, -0.1);
	EXPECT_EQ(decision.headings.desired_rad, 0.2);
	EXPECT_EQ(decision.headings.chosen_rad, 0.2);
	EXPECT_FALSE(decision.headings.avoid_rad) << "nothing forces a deviation";
	EXPECT_EQ(decision.open_path_m, 4.0);
	EXPECT_GT(decision.command.velocity_mps.x(), 0.3);
	EXPECT_LT(decision.command.velocity_mps.x(), 0.5);
	EXPECT_EQ(decision.command.velocity_mps.y(), 0.0);
	EXPECT_EQ(decision.command.velocity_mps.z(), 0.0);
	EXPECT_NEAR(decision.command.yaw_rate_radps, 0.4, 1e-12);
}

TEST(Decide, TheSharperTheTurnTheSlowerButNotForEver)
{
	const auto speed = [](double turn_rad)
	{
		const Decision decision =
		    decide(GoalChoice(), way(turn_rad, 4.0), StopReason::none, 0.5, RobotConfig(), HeadingConfig());
		return decision.command.velocity_mps.x();
	};
	EXPECT_DOUBLE_EQ(speed(0.0), 0.5);
	EXPECT_GT(speed(0.1), 0.49) << "the noise of a heading costs nothing";
	for (double turn_rad = 0.1; turn_rad < 1.5; turn_rad += 0.05)
	{
		EXPECT_LT(speed(turn_rad + 0.05), speed(turn_rad));
		EXPECT_DOUBLE_EQ(speed(turn_rad), speed(-turn_rad));
	}
	// Half a radian is the edge of the usual view: what comes there is met at walking pace at most, but the robot gets
	// on.
	EXPECT_LT(speed(0.5), 0.15);
	EXPECT_GT(speed(0.5), 0.05);
	EXPECT_EQ(speed(2.0), 0.0);
}

TEST(Decide, DeviationIsReportedEvenWhenStopped)
{
	Avoidance avoidance = way(-0.5, 3.0);
	avoidance.deviates = true;
	const RobotConfig robot;
	EXPECT_EQ(decide(GoalChoice(), avoidance, StopReason::none, 0.2, robot, HeadingConfig()).headings.avoid_rad, -0.5);
	const Decision stopped = decide(GoalChoice(), avoidance, StopReason::stale_frame, 0.2, robot, HeadingConfig());
	EXPECT_EQ(stopped.headings.avoid_rad, -0.5);
	EXPECT_FALSE(stopped.headings.chosen_rad);
}

TEST(Decide, EveryForbiddingReasonStopsAtOnce)
{
	for (const StopReason reason : {StopReason::empty_frame, StopReason::stale_frame, StopReason::near_obstacle_lost})
	{
		const Decision decision = decide(GoalChoice(), way(0.3, 5.0), reason, 0.5, RobotConfig(), HeadingConfig());
		EXPECT_TRUE(decision.stop);
		EXPECT_EQ(decision.stop_reason, reason);
		EXPECT_FALSE(decision.headings.chosen_rad);
		EXPECT_TRUE(decision.command.velocity_mps.isZero());
		EXPECT_EQ(decision.command.yaw_rate_radps, 0.0);
	}
}

TEST(Decide, NoDirectionStops)
{
	Avoidance blocked;
	blocked.open_path_m = 0.2;
	const Decision decision = decide(GoalChoice(), blocked, StopReason::none, 0.5, RobotConfig(), HeadingConfig());
	EXPECT_EQ(decision.stop_reason, StopReason::no_direction);
	EXPECT_TRUE(decision.stop);
	EXPECT_EQ(decision.open_path_m, 0.2);
}

TEST(Decide, StopsWhenTheBrakesNeedTheWholeWay)
{
	// v²/2a + margin = 0.25 + 0.10 m at 0.5 m/s.
	EXPECT_EQ(drive(0.34, 0.5).stop_reason, StopReason::path_too_short);
	EXPECT_EQ(drive(0.36, 0.5).stop_reason, StopReason::none);
	EXPECT_EQ(drive(0.34, 0.3).stop_reason, StopReason::none) << "a slower robot may go on";
}

TEST(Decide, StandingRobotStartsOnlyWhenItIsWorthIt)
{
	// Noise of a centimetre about the place where a robot came to rest starts nothing.
	for (const double open : {0.100, 0.105, 0.110, 0.120, 0.130}) EXPECT_TRUE(drive(open, 0.0).stop) << open;
	EXPECT_FALSE(drive(0.16, 0.0).stop);
	EXPECT_FALSE(drive(0.13, 0.08).stop) << "a moving one need not stop there";
	EXPECT_TRUE(drive(0.11, 0.08).stop);
}

TEST(Decide, TurnsOnTheSpotWhenTheHullWouldMeetSomethingOnTheWay)
{
	Avoidance avoidance = way(0.6, 4.0);
	avoidance.turning_path_m = 0.05;
	const Decision decision = decide(GoalChoice(), avoidance, StopReason::none, 0.0, RobotConfig(), HeadingConfig());
	EXPECT_FALSE(decision.stop);
	EXPECT_TRUE(decision.command.velocity_mps.isZero());
	EXPECT_GT(decision.command.yaw_rate_radps, 0.0);
}

TEST(Decide, YawRateStaysWithinTheRobotsLimitAndASideHeadingMeansNoSpeed)
{
	const RobotConfig robot;
	const Decision right = decide(GoalChoice(), way(-2.0, 4.0), StopReason::none, 0.0, robot, HeadingConfig());
	EXPECT_EQ(right.command.yaw_rate_radps, -1.0);
	EXPECT_EQ(right.command.velocity_mps.x(), 0.0);
}

TEST(Decide, MavClimbsAlongTheChosenElevation)
{
	Avoidance avoidance = way(0.0, 4.0);
	avoidance.elevation_rad = 0.3;
	RobotConfig robot;
	robot.kind = RobotKind::mav;
	const Decision decision = decide(GoalChoice(), avoidance, StopReason::none, 0.5, robot, HeadingConfig());
	EXPECT_EQ(decision.headings.chosen_elevation_rad, 0.3);
	EXPECT_NEAR(decision.command.velocity_mps.norm(), 0.5, 1e-12);
	EXPECT_NEAR(decision.command.velocity_mps.z() / decision.command.velocity_mps.x(), std::tan(0.3), 1e-12);
}

/** What happened on a straight way to a wall. */
struct Approach
{
	std::vector<double> speeds_mps;
	double gap_m = 0;
	int starts = 0;
};

/** A robot with the default limits that obeys, `latency` frames late and with its own acceleration, for 30 s at 10 Hz;
 *  its open path is measured with noise. */
Approach approachWall(std::size_t latency, double sigma_m, const HeadingConfig& config)
{
	const RobotConfig robot;
	constexpr double kStep_s = 0.1;
	std::mt19937 random(13);
	std::normal_distribution<double> noise(0.0, 1.0);
	std::vector<double> commands(latency, 0.0);
	Approach approach;
	approach.gap_m = 3.0;
	double speed = 0.0, commanded = 0.0;
	for (int i = 0; i < 300; ++i)
	{
		const Decision decision = drive(std::max(0.0, approach.gap_m + sigma_m * noise(random)), commanded, config);
		if (commanded == 0.0 && !decision.stop) ++approach.starts;
		commanded = decision.command.velocity_mps.x();
		commands.push_back(commanded);
		const double wanted = commands[commands.size() - 1 - latency], change = robot.max_acceleration_mps2 * kStep_s;
		const double before = speed;
		speed = std::clamp(wanted, speed - change, speed + change);
		approach.gap_m -= 0.5 * (before + speed) * kStep_s;
		approach.speeds_mps.push_back(speed);
	}
	return approach;
}

TEST(ClosedLoop, BrakesOnceKeepsTheMarginAndStands)
{
	for (const std::size_t latency : {0U, 1U, 2U, 4U})
	{
		HeadingConfig config;
		config.reaction_time_s = 0.2 * static_cast<double>(latency) + 0.2;
		const Approach approach = approachWall(latency, 0.0, config);
		EXPECT_GE(approach.gap_m, 0.10) << latency;
		EXPECT_LE(approach.gap_m, 0.16) << latency;
		EXPECT_EQ(approach.speeds_mps.back(), 0.0) << latency;
		EXPECT_EQ(approach.starts, 1) << latency;
		const auto top = std::max_element(approach.speeds_mps.begin(), approach.speeds_mps.end());
		EXPECT_DOUBLE_EQ(*top, 0.5);
		EXPECT_TRUE(std::is_sorted(approach.speeds_mps.begin(), top));
		// From full speed on it only slows down.
		const auto after_full = std::find(approach.speeds_mps.rbegin(), approach.speeds_mps.rend(), *top).base();
		EXPECT_TRUE(std::is_sorted(after_full, approach.speeds_mps.end(), std::greater<>())) << latency;
	}
}

TEST(ClosedLoop, NoiseOfACentimetreDoesNotMakeItStopAndGo)
{
	const Approach approach = approachWall(1, 0.01, HeadingConfig());
	EXPECT_LE(approach.starts, 2);
	EXPECT_GE(approach.gap_m, 0.08);
	EXPECT_EQ(approach.speeds_mps.back(), 0.0);
}

TEST(SlowFor, StopsWithinTheRestOfTheWay)
{
	RobotConfig robot;
	robot.max_speed_mps = 2.0;
	const HeadingConfig config;
	for (const double rest_m : {0.05, 0.2, 0.5, 1.0})
	{
		Decision decision;
		decision.command.velocity_mps = Eigen::Vector3d(1.6, 0.0, 1.2);
		slowFor(decision, rest_m, robot, config);
		const double speed_mps = decision.command.velocity_mps.norm();
		EXPECT_LE(stoppingDistance(speed_mps, robot, config) - config.stop_margin_m, rest_m + 1e-9);
		EXPECT_GT(speed_mps, 0.0);
		EXPECT_NEAR(decision.command.velocity_mps.z() / decision.command.velocity_mps.x(), 0.75, 1e-9);
	}
	Decision slow;
	slow.command.velocity_mps.x() = 0.1;
	slowFor(slow, 1.0, robot, config);
	EXPECT_EQ(slow.command.velocity_mps.x(), 0.1);
}
}  // namespace
}  // namespace explore

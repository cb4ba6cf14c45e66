// The way home of a robot whose commands come late: where it stands still once nobody commands it any more.
#include <explore/pipeline/explorer.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <numbers>

#include "support/analytic_scene.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;

constexpr double kFrame_s = 0.1, kMaxYawAcceleration_radps2 = 3.5;

/** Wheels that follow each command `delay_s` after its frame, as fast as the robot's limits let them. */
class LateRobot
{
public:
	LateRobot(const RobotConfig& limits, double delay_s) : m_limits(limits), m_delay_s(delay_s) {}

	void obey(const Command& command) { m_coming.push_back({m_t_s + m_delay_s, command}); }
	void advance(double seconds)
	{
		constexpr double kStep_s = 0.005;
		for (const double until_s = m_t_s + seconds; m_t_s < until_s - 1e-9; m_t_s += kStep_s)
		{
			for (; !m_coming.empty() && m_coming.front().at_s <= m_t_s; m_coming.pop_front())
				m_command = m_coming.front().command;
			m_speed_mps = toward(m_speed_mps, m_command.velocity_mps.x(), m_limits.max_acceleration_mps2 * kStep_s);
			m_yaw_rate_radps = toward(m_yaw_rate_radps, m_command.yaw_rate_radps, kMaxYawAcceleration_radps2 * kStep_s);
			m_yaw_rad += m_yaw_rate_radps * kStep_s;
			m_at += m_speed_mps * kStep_s * Eigen::Vector2d(std::cos(m_yaw_rad), std::sin(m_yaw_rad));
		}
	}
	[[nodiscard]] double seconds() const { return m_t_s; }
	[[nodiscard]] double speed_mps() const { return m_speed_mps; }
	[[nodiscard]] const Eigen::Vector2d& at() const { return m_at; }
	[[nodiscard]] CPose3D pose() const { return {m_at.x(), m_at.y(), 0, m_yaw_rad, 0, 0}; }

private:
	struct Coming
	{
		double at_s;
		Command command;
	};
	static double toward(double value, double target, double most)
	{
		return value + std::clamp(target - value, -most, most);
	}

	RobotConfig m_limits;
	double m_delay_s, m_t_s = 0, m_speed_mps = 0, m_yaw_rate_radps = 0, m_yaw_rad = 0;
	Eigen::Vector2d m_at = Eigen::Vector2d::Zero();
	std::deque<Coming> m_coming;
	Command m_command;
};

class LateCommands : public testing::TestWithParam<double>
{
protected:
	/** Half a minute out into a corridor and back again, until the explorer has finished. */
	bool comesHome()
	{
		m_config.mission.budget.time_s = 40;
		const test::Scene corridor = test::corridorScene(9.0, {3.0}, {5.0});
		ExplorerState state;
		for (std::size_t index = 0; m_robot.seconds() < 90; ++index)
		{
			DepthFrame frame =
			    test::renderFrame(corridor, m_robot.pose(), {0.1, 0.0, 0.5, 0, 0, 0}, test::xtionIntrinsics(160, 120));
			frame.index = index;
			frame.timestamp +=
			    std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::duration<double>(m_robot.seconds()));
			frame.map_from_robot = m_robot.pose();
			frame.pose_origin = PoseOrigin::robot_pose;
			const StepResult result = step(frame, state, m_config);
			m_farthest_m = std::max(m_farthest_m, m_robot.at().norm());
			m_robot.obey(result.decision.command);
			if (result.finished) return state.mission.home_reached;
			m_robot.advance(kFrame_s);
		}
		return false;
	}

	ExplorerConfig m_config;
	LateRobot m_robot{m_config.robot, GetParam()};
	double m_farthest_m = 0;
};

TEST_P(LateCommands, LetTheRobotStandStillAtHome)
{
	ASSERT_TRUE(comesHome());
	EXPECT_GT(m_farthest_m, 1.5) << "it was away";
	EXPECT_LE(m_robot.at().norm(), 0.05);
	m_robot.advance(5.0);
	EXPECT_EQ(m_robot.speed_mps(), 0.0);
	EXPECT_LE(m_robot.at().norm(), 0.06) << "it has rolled on";
}
INSTANTIATE_TEST_SUITE_P(BySeconds, LateCommands, testing::Values(0.05, 0.15, 0.25));
}  // namespace
}  // namespace explore

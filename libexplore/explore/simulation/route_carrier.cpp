#include <explore/core/errors.h>
#include <explore/core/geometry.h>
#include <explore/simulation/carriers.h>

#include <cmath>
#include <sstream>

namespace explore::simulation
{
namespace
{
constexpr double kControl_s = 0.02, kPatience_s = 15.0;
constexpr double kSpare_m = 0.15, kProbe_m = 0.05;

std::vector<Eigen::Vector3d> differentPoints(const Route& route)
{
	constexpr double kSame_m = 1e-6;
	std::vector<Eigen::Vector3d> points;
	for (const Eigen::Vector3d& point : route.points_in_map)
		if (points.empty() || (point - points.back()).norm() > kSame_m) points.push_back(point);
	if (points.size() < 2)
		throw ConfigError("route '" + route.name + "' has " + std::to_string(route.points_in_map.size()) +
		                  " points: at least two that differ are needed");
	return points;
}

mrpt::poses::CPose3D startOf(const std::vector<Eigen::Vector3d>& points)
{
	const Eigen::Vector3d& start = points[0];
	return {start.x(), start.y(), start.z(), azimuthOf(points[1] - start), 0.0, 0.0};
}

class RouteCarrier : public Carrier
{
public:
	RouteCarrier(RayScene& scene, const RobotConfig& robot, const SimulatedRobotConfig& config,
	             const std::vector<Eigen::Vector3d>& points, std::uint64_t seed)
	    : m_robot(scene, robot, config, startOf(points), seed), m_follower(points, robot)
	{
	}

	void advanceTo(double t_s) override
	{
		while (t_s - state().t_s > 1e-9) advance(std::min(kControl_s, t_s - state().t_s));
	}

	[[nodiscard]] bool finished() const override { return m_follower.done() || gaveUp(); }
	[[nodiscard]] mrpt::poses::CPose3D truePose() const override { return state().mapFromRobot(); }
	[[nodiscard]] mrpt::poses::CPose3D estimate() const override { return m_robot.estimate(); }
	[[nodiscard]] ImuReading imu() const override { return m_robot.imu(); }
	[[nodiscard]] std::vector<std::string> warnings() const override
	{
		std::vector<std::string> warnings;
		for (const Contact& contact : m_robot.contacts())
			warnings.push_back(text("the robot touched something", contact.t_s, contact.position_in_map));
		if (gaveUp())
			warnings.push_back(text("the route ends early: something was in the robot's way for 15 s", state().t_s,
			                        state().position_in_map));
		return warnings;
	}

private:
	static std::string text(const std::string& what, double t_s, const Eigen::Vector3d& place)
	{
		std::ostringstream text;
		text << what << " after " << t_s << " s at (" << place.x() << ", " << place.y() << ", " << place.z() << ")";
		return text.str();
	}
	[[nodiscard]] const RobotState& state() const { return m_robot.trueState(); }
	[[nodiscard]] bool gaveUp() const { return m_waited_s >= kPatience_s; }

	void advance(double dt_s)
	{
		Command command = m_follower.steer(state());
		const bool waits = blocked(command);
		m_waited_s = waits ? m_waited_s + dt_s : 0.0;
		if (waits) command.velocity_mps.setZero();
		m_robot.advance(command, dt_s);
	}
	/** Whether the body would touch something on its way before it could stop. */
	[[nodiscard]] bool blocked(const Command& command) const
	{
		const Eigen::Vector3d way = Eigen::AngleAxisd(state().yaw_rad, Eigen::Vector3d::UnitZ()) * command.velocity_mps;
		if (way.isZero()) return false;
		const double speed = std::max(way.norm(), state().velocity_mps.norm());
		const double reach = 0.5 * speed * speed / m_robot.config().max_acceleration_mps2 + kSpare_m;
		for (double ahead = kProbe_m; ahead <= reach; ahead += kProbe_m)
			if (m_robot.touchesAt(state().position_in_map + ahead * way.normalized())) return true;
		return false;
	}

	SimulatedRobot m_robot;
	PathFollower m_follower;
	double m_waited_s = 0;
};
}  // namespace

std::unique_ptr<Carrier> carrierOnRoute(RayScene& scene, const RobotConfig& robot, const SimulatedRobotConfig& config,
                                        const Route& route, std::uint64_t seed)
{
	return std::make_unique<RouteCarrier>(scene, robot, config, differentPoints(route), seed);
}
}  // namespace explore::simulation

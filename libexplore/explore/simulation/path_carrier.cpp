#include <explore/core/errors.h>
#include <explore/core/geometry.h>
#include <explore/simulation/carriers.h>
#include <explore/simulation/robot_body.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace explore::simulation
{
namespace
{
/** Steps between which the body's contacts are looked for. */
constexpr double kStep_s = 0.02;

mrpt::poses::CPose3D between(const mrpt::poses::CPose3D& a, const mrpt::poses::CPose3D& b, double share)
{
	const Eigen::Isometry3d from = isometryOf(a), to = isometryOf(b);
	const Eigen::Quaterniond turned =
	    Eigen::Quaterniond(from.linear()).slerp(share, Eigen::Quaterniond(to.linear())).normalized();
	const Eigen::Vector3d place = from.translation() + share * (to.translation() - from.translation());
	const Eigen::Matrix3d rotation = turned.toRotationMatrix();
	mrpt::poses::CPose3D pose;
	mrpt::math::CMatrixDouble33 matrix;
	for (int row = 0; row < 3; ++row)
		for (int column = 0; column < 3; ++column) matrix(row, column) = rotation(row, column);
	pose.setRotationMatrix(matrix);
	pose.x(place.x());
	pose.y(place.y());
	pose.z(place.z());
	return pose;
}

struct Bounds
{
	Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::infinity()), high = -low;
};

Bounds boundsOf(const World& world)
{
	Bounds bounds;
	for (const Eigen::Vector3f& vertex : world.mesh.vertices)
	{
		bounds.low = bounds.low.cwiseMin(vertex.head<2>());
		bounds.high = bounds.high.cwiseMax(vertex.head<2>());
	}
	return bounds;
}

class PathCarrier : public Carrier
{
public:
	PathCarrier(RayScene& scene, const RobotConfig& robot, const SimulatedRobotConfig& config,
	            std::vector<PathPose> path, std::uint64_t seed)
	    : m_scene(scene),
	      m_robot(robot),
	      m_path(std::move(path)),
	      m_bounds(boundsOf(scene.world())),
	      m_movers(scene.world()),
	      m_pose(m_path.front().map_from_robot),
	      m_odometry(config.odometry, robot.kind, m_pose, mixed({seed, hashOf("odometry")})),
	      m_imu(config.imu, mixed({seed, hashOf("imu")}))
	{
		if (!m_movers.empty()) m_scene.place(m_movers.placement());
		look();
		m_reading = m_imu.read(m_pose, m_pose, Eigen::Vector3d::Zero(), kStep_s);
	}

	void advanceTo(double t_s) override
	{
		const double from = m_t_s;
		if (!(t_s > from)) return;
		const mrpt::poses::CPose3D before = m_pose;
		const int steps = std::max(1, static_cast<int>(std::ceil((t_s - from) / kStep_s - 1e-9)));
		for (int i = 1; i <= steps; ++i) step(i == steps ? t_s : from + (t_s - from) * i / steps);
		m_reading = m_imu.read(before, m_pose, Eigen::Vector3d::Zero(), t_s - from);
	}

	[[nodiscard]] bool finished() const override { return m_t_s >= m_path.back().t_s; }
	[[nodiscard]] mrpt::poses::CPose3D truePose() const override { return m_pose; }
	[[nodiscard]] mrpt::poses::CPose3D estimate() const override { return m_odometry.estimate(); }
	[[nodiscard]] ImuReading imu() const override { return m_reading; }
	[[nodiscard]] std::vector<std::string> warnings() const override
	{
		std::vector<std::string> warnings;
		if (m_touching.steps > 0) warnings.push_back(m_touching.text("the robot's body touches something on the path"));
		if (m_outside.steps > 0) warnings.push_back(m_outside.text("the path leaves the world's bounds"));
		return warnings;
	}

private:
	/** Something that is wrong with places of the path. */
	struct Remark
	{
		int steps = 0;
		double first_s = 0;
		Eigen::Vector3d first_in_map = Eigen::Vector3d::Zero();

		[[nodiscard]] std::string text(const std::string& what) const
		{
			std::ostringstream text;
			text << what << ": first after " << first_s << " s at (" << first_in_map.x() << ", " << first_in_map.y()
			     << ", " << first_in_map.z() << "), for " << steps * kStep_s << " s in all";
			return text.str();
		}
	};

	void step(double t_s)
	{
		m_movers.advance(t_s - m_t_s, {position().head<2>(), m_robot.radius_m});
		if (!m_movers.empty()) m_scene.place(m_movers.placement());
		m_pose = poseAt(t_s);
		m_odometry.moveTo(m_pose, t_s - m_t_s);
		m_t_s = t_s;
		look();
	}
	[[nodiscard]] mrpt::poses::CPose3D poseAt(double t_s) const
	{
		const auto after =
		    std::find_if(m_path.begin(), m_path.end(), [&](const PathPose& pose) { return pose.t_s > t_s; });
		if (after == m_path.begin()) return m_path.front().map_from_robot;
		if (after == m_path.end()) return m_path.back().map_from_robot;
		const PathPose &a = *(after - 1), &b = *after;
		return between(a.map_from_robot, b.map_from_robot, (t_s - a.t_s) / (b.t_s - a.t_s));
	}
	[[nodiscard]] Eigen::Vector3d position() const { return {m_pose.x(), m_pose.y(), m_pose.z()}; }
	void look()
	{
		const VerticalCylinder body = bodyAt(m_robot, position());
		const Eigen::Vector2f place = position().head<2>().cast<float>();
		const auto note = [&](Remark& remark, bool wrong)
		{
			if (wrong && remark.steps++ == 0) remark = {1, m_t_s, position()};
		};
		note(m_touching, m_scene.touchesCylinder(body.base, body.radius_m, body.height_m));
		note(m_outside, (place.array() < m_bounds.low.array()).any() || (place.array() > m_bounds.high.array()).any());
	}

	RayScene& m_scene;
	RobotConfig m_robot;
	std::vector<PathPose> m_path;
	Bounds m_bounds;
	Movers m_movers;
	double m_t_s = 0;
	mrpt::poses::CPose3D m_pose;
	Odometry m_odometry;
	Imu m_imu;
	ImuReading m_reading;
	Remark m_touching, m_outside;
};
}  // namespace

std::unique_ptr<Carrier> carrierOnPath(RayScene& scene, const RobotConfig& robot, const SimulatedRobotConfig& config,
                                       std::vector<PathPose> path, std::uint64_t seed)
{
	if (path.empty()) throw ConfigError("a path without poses leads nowhere: at least one is needed");
	for (std::size_t i = 1; i < path.size(); ++i)
		if (!(path[i].t_s > path[i - 1].t_s))
			throw ConfigError("the times of the path's poses must increase: pose " + std::to_string(i + 1) + " is " +
			                  std::to_string(path[i].t_s) + " s after the start, the one before it " +
			                  std::to_string(path[i - 1].t_s) + " s");
	return std::make_unique<PathCarrier>(scene, robot, config, std::move(path), seed);
}
}  // namespace explore::simulation

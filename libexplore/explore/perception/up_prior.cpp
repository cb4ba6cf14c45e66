#include <explore/core/geometry.h>
#include <explore/perception/up_prior.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace explore
{
namespace
{
std::size_t unsignedOf(int index)
{
	return static_cast<std::size_t>(index);
}

std::size_t placeOf(int row, int column, const SampleGrid& grid)
{
	return unsignedOf(row) * unsignedOf(grid.columns) + unsignedOf(column);
}

constexpr double kLyingDown = 0.5;           // cosine: more than 60° off the robot's z axis is no attitude to fly at
constexpr double kNormalSigma = 0.15;        // of one sample's normal, rad
constexpr double kCorrelatedNormals = 10.0;  // so many neighbouring normals count as one: they share depths and steps
constexpr std::size_t kMinNormals = 200;     // fewer say nothing
constexpr int kThinning = 3;
constexpr double kSteady_rad = 0.1;  // noise of a normal that is of use
constexpr int kMinReach = 2, kMaxReach = 10;
constexpr double kWellPrior = 1.2 * kDegree_rad;  // this good a prior is only checked, in few steps

using Normals = std::vector<Eigen::Vector3f>;

/** How many grid steps to either side a normal at this depth needs, so that noise does not decide it: over short
 *  distances disparity steps make all far walls face the camera. */
int reachAt(double depth_m, double step_per_depth, const SensorNoiseConfig& noise)
{
	const double steps =
	    std::numbers::sqrt2 * depthSigma(depth_m, noise) / (2.0 * kSteady_rad * step_per_depth * depth_m);
	return std::clamp(static_cast<int>(std::ceil(steps)), kMinReach, kMaxReach);
}

/** The samples to either side of one, where one plane goes through all five: inverse depth is linear on a plane. */
class Neighbours
{
public:
	Neighbours(const SampleGrid& grid, int row, int column, int reach)
	    : m_grid(grid), m_row(row), m_column(column), m_reach(reach)
	{
	}

	[[nodiscard]] bool onePlane(const SensorNoiseConfig& noise) const
	{
		const float here = depth(0, 0);
		const double allowed = 10.0 * depthSigma(static_cast<double>(here), noise) / static_cast<double>(here * here);
		const auto bend = [&](float a, float b)
		{ return a > 0.0F && b > 0.0F ? std::abs(1.0F / a + 1.0F / b - 2.0F / here) : 1e9F; };
		return static_cast<double>(bend(depth(-m_reach, 0), depth(m_reach, 0))) < allowed &&
		       static_cast<double>(bend(depth(0, -m_reach), depth(0, m_reach))) < allowed;
	}
	[[nodiscard]] Eigen::Vector3f normal() const
	{
		const Eigen::Vector3f up = point(-m_reach, 0) - point(m_reach, 0);
		const Eigen::Vector3f left = point(0, -m_reach) - point(0, m_reach);
		return up.cross(left).normalized();
	}

private:
	[[nodiscard]] float depth(int down, int right) const
	{
		return m_grid.depth_m[placeOf(m_row + down, m_column + right, m_grid)];
	}
	[[nodiscard]] Eigen::Vector3f point(int down, int right) const
	{
		return depth(down, right) * Eigen::Vector3f(1.0F, m_grid.ray_y[unsignedOf(m_column + right)],
		                                            m_grid.ray_z[unsignedOf(m_row + down)]);
	}

	const SampleGrid& m_grid;
	int m_row, m_column, m_reach;
};

/** Normals of every third row's and column's samples, where they can be told. */
Normals steadyNormals(const SampleGrid& grid, const SensorNoiseConfig& noise)
{
	Normals normals;
	if (grid.rows < 2 * kMinReach + 1 || grid.columns < 2 * kMinReach + 1) return normals;
	normals.reserve(grid.size() / (kThinning * kThinning) + 1);
	const auto step_per_depth = static_cast<double>(grid.ray_z[0] - grid.ray_z[1]);
	for (int row = kMinReach; row < grid.rows - kMinReach; row += kThinning)
		for (int column = kMinReach; column < grid.columns - kMinReach; column += kThinning)
		{
			const float depth = grid.depth_m[placeOf(row, column, grid)];
			if (!(depth > 0.0F)) continue;
			const int reach = reachAt(static_cast<double>(depth), step_per_depth, noise);
			if (std::min({row, column, grid.rows - 1 - row, grid.columns - 1 - column}) < reach) continue;
			const Neighbours neighbours(grid, row, column, reach);
			if (neighbours.onePlane(noise)) normals.push_back(neighbours.normal());
		}
	return normals;
}

/** Two unit vectors at right angles to `up` and to each other. */
std::array<Eigen::Vector3f, 2> tangentsOf(const Eigen::Vector3f& up)
{
	const Eigen::Vector3f helper = std::abs(up.x()) < 0.7F ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitY();
	const Eigen::Vector3f first = up.cross(helper).normalized();
	return {first, up.cross(first)};
}

/** Sums over the normals that are nearly level or nearly upright for `up`: a Gauss-Newton step and its support. */
struct Consensus
{
	Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
	Eigen::Vector2d pull = Eigen::Vector2d::Zero();
	double support = 0;
};

Consensus consensusAt(const Normals& normals, const Eigen::Vector3f& up, double reach_rad)
{
	Consensus sum;
	const auto [e1, e2] = tangentsOf(up);
	const auto reach = static_cast<float>(std::sin(reach_rad));
	const auto inverse = 1.0F / (reach * reach);
	for (const Eigen::Vector3f& n : normals)
	{
		const float along = n.dot(up), a = n.dot(e1), b = n.dot(e2);
		const float level = a * a + b * b;  // sin² of the angle to up or down
		const float upright = along * along;
		const bool is_level = level < upright;
		const float weight = std::max(0.0F, 1.0F - (is_level ? level : upright) * inverse);
		if (weight == 0.0F) continue;
		sum.support += weight;
		// level: n = ±up(δ), δ·e = ±n·e; upright: n·up(δ) = 0, a δ₁ + b δ₂ = −along
		const double w = weight * weight;
		if (is_level)
		{
			sum.information.diagonal().array() += w;
			sum.pull += w * (along > 0.0F ? 1.0 : -1.0) * Eigen::Vector2d(a, b);
		}
		else
		{
			const Eigen::Vector2d direction(a, b);
			sum.information += w * direction * direction.transpose();
			sum.pull -= w * static_cast<double>(along) * direction;
		}
	}
	return sum;
}

Eigen::Vector3f turned(const Eigen::Vector3f& up, const Eigen::Vector2d& delta)
{
	const auto [e1, e2] = tangentsOf(up);
	const Eigen::Vector2f d = delta.cast<float>();
	return (up + d.x() * e1 + d.y() * e2).normalized();
}

/** Where the surfaces pull `start`; `prior_weight` (in normals) holds it back. */
Eigen::Vector3f converge(const Normals& normals, const Eigen::Vector3f& start, double prior_weight,
                         std::initializer_list<double> reaches_deg)
{
	Eigen::Vector3f up = start;
	for (const double reach_deg : reaches_deg)
	{
		const Consensus sum = consensusAt(normals, up, reach_deg * kDegree_rad);
		const auto [e1, e2] = tangentsOf(up);
		const Eigen::Vector2d back(start.dot(e1), start.dot(e2));
		const Eigen::Matrix2d information = sum.information + (prior_weight + 1e-3) * Eigen::Matrix2d::Identity();
		up = turned(up, information.ldlt().solve(sum.pull + prior_weight * back));
	}
	return up;
}

/** Weaker of the two directions in which `up` can be off. */
double weakestInformation(const Normals& normals, const Eigen::Vector3f& up)
{
	const Consensus sum = consensusAt(normals, up, 15 * kDegree_rad);
	return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(sum.information).eigenvalues()(0);
}

/** Do the surfaces contradict the prior so clearly that it must be wrong? */
std::optional<UpPrior> contradiction(const UpPrior& prior, const Normals& normals)
{
	const Eigen::Vector3f start = prior.up.cast<float>();
	const Eigen::Vector3f free = converge(normals, start, 0.0, {30, 25, 20, 15, 12, 12});
	const double off = angleBetweenAxes(free.cast<double>(), prior.up);
	if (off < std::max(5 * kDegree_rad, 3 * prior.sigma_rad)) return std::nullopt;
	const double there = consensusAt(normals, free, 10 * kDegree_rad).support;
	const double here = consensusAt(normals, start, 10 * kDegree_rad).support;
	const auto all = static_cast<double>(normals.size());
	const bool clear = there > 0.4 * all && there > 1.5 * here && weakestInformation(normals, free) > 0.1 * all;
	if (!clear) return std::nullopt;
	return UpPrior{free.cast<double>(), 1.5 * kDegree_rad, UpOrigin::surfaces};
}
}  // namespace

void describe(FieldVisitor& fields, UpPriorConfig& config)
{
	fields.degrees("gravity_imu_deg", config.imu_sigma_rad, {0.05, 30},
	               "Standard deviation of the vertical from an IMU.");
	fields.degrees("gravity_pose_deg", config.pose_sigma_rad, {0.05, 30},
	               "Standard deviation of the vertical from roll and pitch of a recorded robot pose.");
	fields.degrees("gravity_mount_deg", config.mount_sigma_rad, {0.05, 30},
	               "Standard deviation of the vertical of a ground robot of which nothing else is known.");
	fields.degrees("gravity_flying_deg", config.flying_mount_sigma_rad, {0.05, 30},
	               "Standard deviation of the vertical of a MAV of which nothing else is known.");
}

UpPrior recordedUp(const DepthFrame& frame, const RobotConfig& robot, const std::optional<UncertainGround>& remembered,
                   const UpPriorConfig& config)
{
	if (frame.up_in_robot && frame.up_in_robot->z() > kLyingDown && frame.up_in_robot->allFinite())
		return {frame.up_in_robot->normalized(), config.imu_sigma_rad, UpOrigin::imu};

	const Eigen::Vector3d up_of_pose = isometryOf(frame.map_from_robot).linear().transpose() * Eigen::Vector3d::UnitZ();
	const bool has_attitude = frame.map_from_robot.roll() != 0.0 || frame.map_from_robot.pitch() != 0.0;
	if (isPoseInSpace(frame.pose_origin) && has_attitude && up_of_pose.z() > kLyingDown)
		return {up_of_pose, config.pose_sigma_rad, UpOrigin::pose};

	// an identity mount says nothing about how the camera looks
	const bool level = robot.kind == RobotKind::ground && frame.robot_from_camera != mrpt::poses::CPose3D();
	const double mount_sigma = level ? config.mount_sigma_rad : config.flying_mount_sigma_rad;
	if (remembered && remembered->tilt_sigma_rad < mount_sigma)
		return {remembered->plane.normal, remembered->tilt_sigma_rad, UpOrigin::memory};
	return {Eigen::Vector3d::UnitZ(), mount_sigma, UpOrigin::mount};
}

UpPrior refineUp(const UpPrior& prior, const SampleGrid& grid, const SensorNoiseConfig& noise)
{
	const Normals normals = steadyNormals(grid, noise);
	if (normals.size() < kMinNormals) return prior;
	if (prior.sigma_rad < 6 * kDegree_rad)
		if (const auto wrong = contradiction(prior, normals)) return *wrong;

	const double prior_weight = kCorrelatedNormals * kNormalSigma * kNormalSigma / (prior.sigma_rad * prior.sigma_rad);
	const Eigen::Vector3f start = prior.up.cast<float>();
	const Eigen::Vector3f up = prior.sigma_rad > kWellPrior
	                               ? converge(normals, start, prior_weight, {30, 25, 20, 15, 15, 15})
	                               : converge(normals, start, prior_weight, {15, 15});
	const double information = weakestInformation(normals, up) + prior_weight;
	const double sigma = std::sqrt(kCorrelatedNormals / information) * kNormalSigma;
	return {up.cast<double>(), std::min(prior.sigma_rad, std::max(sigma, 0.3 * kDegree_rad)), prior.origin};
}
}  // namespace explore

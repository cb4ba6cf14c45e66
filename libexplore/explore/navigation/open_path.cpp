#include <explore/navigation/level_frame.h>
#include <explore/navigation/open_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace explore
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kRings = 128;
constexpr float kPi = std::numbers::pi_v<float>;

/** atan2 within 2e-5 rad, several times faster (polynomial of Abramowitz & Stegun 4.4.49). */
float fastAzimuth(float y, float x)
{
	const float near = std::min(std::abs(x), std::abs(y)), far = std::max(std::abs(x), std::abs(y));
	if (!(far > 0.0F)) return 0.0F;
	const float q = near / far, q2 = q * q;
	float angle = q * (0.9998660F + q2 * (-0.3302995F + q2 * (0.1801410F + q2 * (-0.0851330F + q2 * 0.0208351F))));
	if (std::abs(y) > std::abs(x)) angle = 0.5F * kPi - angle;
	if (x < 0.0F) angle = kPi - angle;
	return y < 0.0F ? -angle : angle;
}

/** Upper bound of asin(ratio) for a ratio in [0, 1]; exact at both ends. */
double asinBound(double ratio)
{
	return ratio + (0.5 * std::numbers::pi - 1.0) * ratio * ratio * ratio;
}

/** cos and sin of a direction's azimuth, and the cosine of its elevation. */
struct Heading
{
	double cos_azimuth, sin_azimuth, cos_elevation;
};

/** Travel until the hull reaches the sample, infinite when it passes by or moves away. `at_height` is
 * the stretch on which the sample is at the hull's height; `rise` is its share in the way to the sample. */
double contact(const ObstacleSample& sample, const Heading& heading, const TravelSpan& at_height, double rise)
{
	const double ahead = sample.x * heading.cos_azimuth + sample.y * heading.sin_azimuth;
	const double aside = sample.y * heading.cos_azimuth - sample.x * heading.sin_azimuth;
	const double half_chord2 = static_cast<double>(sample.radius_m) * sample.radius_m - aside * aside;
	if (!(half_chord2 > 0.0)) return kInfinity;
	const double half_chord = std::sqrt(half_chord2);
	const double enter = std::max((ahead - half_chord) / heading.cos_elevation, at_height.enter_m);
	const double leave = std::min((ahead + half_chord) / heading.cos_elevation, at_height.leave_m);
	if (leave <= std::max(enter, 0.0)) return kInfinity;
	if (enter > 0.0) return enter;
	// Inside the hull from the start: only moving toward the point is forbidden.
	return ahead * heading.cos_elevation + rise > 0.0 ? 0.0 : kInfinity;
}

/** Half the angle [rad] that the hull's disc takes up as seen from the sample, rounded up: directions further from the
 *  sample's azimuth pass it by. */
double halfWidth(const ObstacleSample& sample)
{
	// More than the error of fastAzimuth.
	constexpr double kSlack_rad = 1e-4;
	const double distance_m = Eigen::Vector2d(sample.x, sample.y).norm();
	return distance_m > sample.radius_m ? asinBound(sample.radius_m / distance_m) + kSlack_rad : std::numbers::pi;
}

/** Where the ray from the sensor to a point below the floor passes through the floor (level frame). */
Eigen::Vector3d piercedFloor(const Eigen::Vector3d& sensor, const Eigen::Vector3d& point, double altitude_m)
{
	const double sensor_height = sensor.z() + altitude_m, depth = -(point.z() + altitude_m);
	return sensor_height > 0.0 ? Eigen::Vector3d(sensor + sensor_height / (sensor_height + depth) * (point - sensor))
	                           : point;
}
}  // namespace

OpenPath::OpenPath(const AvoiderInput& input, const RobotConfig& robot, const AvoiderConfig& config)
    : m_radius_m(robot.radius_m),
      m_clearance_m(config.clearance_m),
      m_clearance_range_m(config.clearance_range_m),
      m_half_height_m(robot.kind == RobotKind::mav ? 0.5 * robot.height_m : kInfinity),
      m_range_m(config.max_range_m)
{
	m_samples.reserve(input.obstacles_in_robot->size());
	if (robot.kind == RobotKind::mav)
		addFlightObstacles(input);
	else
		addGroundObstacles(input, robot, config);
	sortByDistance();
	if (robot.kind == RobotKind::ground || !input.ground) return;
	m_climb_m = std::max(0.0, robot.max_altitude_m - input.ground->d_m);
	m_descent_m = std::max(0.0, input.ground->d_m - robot.min_altitude_m);
}

void OpenPath::sortByDistance()
{
	// Counting sort; one ring more than the range has, for distances that rounding lifts to its end.
	std::array<std::size_t, kRings + 2> start{};
	const double per_m = kRings / m_range_m;
	const auto ring = [&](const ObstacleSample& sample) { return static_cast<std::size_t>(sample.nearest_m * per_m); };
	for (const ObstacleSample& sample : m_samples) ++start[ring(sample) + 1];
	std::partial_sum(start.begin(), start.end(), start.begin());
	std::vector<ObstacleSample> sorted(m_samples.size());
	for (const ObstacleSample& sample : m_samples) sorted[start[ring(sample)]++] = sample;
	m_samples.swap(sorted);
}

void OpenPath::addGroundObstacles(const AvoiderInput& input, const RobotConfig& robot, const AvoiderConfig& config)
{
	const LevelFrame level = levelFrame(input.ground, input.up_in_robot);
	const PointCloud& points = *input.obstacles_in_robot;
	const double top_m = robot.height_m + config.clearance_m;
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		Eigen::Vector3d point = level.level_from_robot * points[i].cast<double>();
		const double height_m = point.z() + level.altitude_m;
		if (!(height_m < top_m)) continue;
		if (input.ground && std::abs(height_m) <= config.step_height_m) continue;
		if (input.ground && height_m < 0.0 && input.sensor_in_robot)
			point = piercedFloor(level.level_from_robot * *input.sensor_in_robot, point, level.altitude_m);
		add({point.x(), point.y(), 0.0});
	}
}

void OpenPath::addFlightObstacles(const AvoiderInput& input)
{
	const LevelFrame level = levelFrame(input.ground, input.up_in_robot);
	const PointCloud& points = *input.obstacles_in_robot;
	for (std::size_t i = 0; i < points.size(); ++i) add(level.level_from_robot * points[i].cast<double>());
}

void OpenPath::add(const Eigen::Vector3d& point_in_level)
{
	// Of the clearance, for what is far: silhouettes are off by a pixel or two.
	constexpr double kFarShare = 0.2;
	// What rounding to float may add to a distance.
	constexpr double kSlack_m = 1e-5;
	const double gap_m = point_in_level.head<2>().norm() - m_radius_m;
	const double nearness = std::clamp(1.0 - gap_m / m_clearance_range_m, kFarShare, 1.0);
	const double radius_m = m_radius_m + m_clearance_m * nearness;
	const double nearest_m = gap_m + m_radius_m - radius_m - kSlack_m;
	if (!(nearest_m < m_range_m)) return;
	const Eigen::Vector3f point = point_in_level.cast<float>();
	m_samples.push_back(
	    {point.x(), point.y(), point.z(), static_cast<float>(radius_m), static_cast<float>(std::max(0.0, nearest_m))});
}

double OpenPath::altitudeLimit(double elevation_rad) const
{
	const double sine = std::sin(elevation_rad);
	if (!std::isfinite(m_half_height_m) || sine == 0.0) return m_range_m;
	return std::min(m_range_m, sine > 0.0 ? m_climb_m / sine : m_descent_m / -sine);
}

TravelSpan OpenPath::heightSpan(const ObstacleSample& sample, double sin_elevation) const
{
	const double half_height_m = m_half_height_m + (sample.radius_m - m_radius_m);
	const double low = sample.z - half_height_m, high = sample.z + half_height_m;
	if (sin_elevation > 0.0) return {low / sin_elevation, high / sin_elevation};
	if (sin_elevation < 0.0) return {high / sin_elevation, low / sin_elevation};
	return low < 0.0 && high > 0.0 ? TravelSpan{-kInfinity, kInfinity} : TravelSpan{kInfinity, kInfinity};
}

double OpenPath::along(const Direction& direction) const
{
	return along(DirectionFan{direction.azimuth_rad, 1.0, 1, direction.elevation_rad}).front();
}

std::vector<double> OpenPath::along(const DirectionFan& fan) const
{
	DirectionFan turned = fan;
	turned.first_rad = wrapToPi(fan.first_rad);
	if (!std::isfinite(m_half_height_m)) turned.elevation_rad = 0.0;
	return sweep(turned);
}

std::vector<double> OpenPath::sweep(const DirectionFan& fan) const
{
	const double sin_elevation = std::sin(fan.elevation_rad), cos_elevation = std::cos(fan.elevation_rad);
	const double limit_m = altitudeLimit(fan.elevation_rad);
	std::vector<double> open_m(fan.count, limit_m);
	std::vector<Heading> headings(fan.count);
	for (std::size_t k = 0; k < fan.count; ++k)
		headings[k] = {std::cos(fan.at(k).azimuth_rad), std::sin(fan.at(k).azimuth_rad), cos_elevation};

	const double ring_m = m_range_m / kRings;
	double furthest_m = limit_m;
	for (std::size_t i = 0; i < m_samples.size(); ++i)
	{
		const ObstacleSample& sample = m_samples[i];
		if (i % 64 == 0) furthest_m = *std::max_element(open_m.begin(), open_m.end());
		if (sample.nearest_m - ring_m > furthest_m) break;
		const TravelSpan at_height = heightSpan(sample, sin_elevation);
		if (at_height.enter_m >= limit_m || at_height.leave_m <= 0.0) continue;
		const double rise = sample.z * sin_elevation;
		forEachNear(fan, fastAzimuth(sample.y, sample.x), halfWidth(sample),
		            [&](std::size_t k)
		            {
			            if (sample.nearest_m < open_m[k])
				            open_m[k] = std::min(open_m[k], contact(sample, headings[k], at_height, rise));
		            });
	}
	return open_m;
}
}  // namespace explore

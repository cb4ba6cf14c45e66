#include <explore/navigation/ways.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
bool crops(const AvoiderConfig& config)
{
	const bool as_printed =
	    config.method == AvoiderMethod::open_path && config.leave_out == AvoiderRemedy::swept_corridor;
	return as_printed || config.method == AvoiderMethod::paper;
}

/** The obstacles within ± sector of the desired direction, whatever their height (paper §3.2). */
PointCloud croppedTo(const AvoiderInput& input, const LevelFrame& level, double sector_rad)
{
	PointCloud kept;
	const PointCloud& points = *input.obstacles_in_robot;
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const double azimuth = azimuthOf(level.level_from_robot * points[i].cast<double>());
		if (std::abs(wrapToPi(azimuth - input.desired_rad)) <= sector_rad) kept.push_back(points[i]);
	}
	return kept;
}

PointCloud cropOf(const AvoiderInput& input, const AvoiderConfig& config)
{
	return crops(config) ? croppedTo(input, levelFrame(input.ground, input.up_in_robot), config.sector_rad)
	                     : PointCloud();
}

AvoiderInput withObstacles(AvoiderInput input, const PointCloud& obstacles, const AvoiderConfig& config)
{
	if (crops(config)) input.obstacles_in_robot = &obstacles;
	return input;
}
}  // namespace

Ways::Ways(const AvoiderInput& input, const RobotConfig& robot, const AvoiderConfig& config)
    : m_level(levelFrame(input.ground, input.up_in_robot)),
      m_robot(robot),
      m_config(config),
      m_as_printed(config.method == AvoiderMethod::open_path && config.leave_out == AvoiderRemedy::swept_corridor),
      m_cropped_in_robot(cropOf(input, config)),
      m_open_path(withObstacles(input, m_cropped_in_robot, config), robot, config)
{
	const bool free_when_unseen =
	    config.method == AvoiderMethod::paper || config.leave_out == AvoiderRemedy::unseen_blocks;
	if (input.sight != nullptr && !input.sight->empty() && !free_when_unseen)
		m_sight = sightInLevel(*input.sight, m_level);
}

MovingBody Ways::bodyAt(double elevation_rad) const
{
	if (m_robot.kind == RobotKind::mav)
		return {m_robot.radius_m, -0.5 * m_robot.height_m, 0.5 * m_robot.height_m, std::tan(elevation_rad)};
	return {m_robot.radius_m, m_config.step_height_m - m_level.altitude_m, m_robot.height_m - m_level.altitude_m, 0.0};
}

WayFan Ways::along(const DirectionFan& fan) const
{
	WayFan ways;
	if (!m_sight)
	{
		ways.open_m = openAlong(fan);
		ways.worth_m = ways.open_m;
		ways.seen_start.assign(fan.count, true);
		return ways;
	}
	const auto in_view = [&](std::size_t k) { return m_sight->sees(fan.at(k).azimuth_rad, fan.elevation_rad); };
	std::size_t first = 0, end = fan.count;
	while (first < end && !in_view(first)) ++first;
	while (end > first && !in_view(end - 1)) --end;
	ways = {std::vector<double>(fan.count), std::vector<double>(fan.count), std::vector<bool>(fan.count)};
	if (first == end) return ways;
	const DirectionFan seen{fan.at(first).azimuth_rad, fan.step_rad, end - first, fan.elevation_rad};
	const UnseenSpace unseen(*m_sight, bodyAt(fan.elevation_rad), m_config.max_range_m);
	const WayLengths lengths = unseen.along(seen, openAlong(seen));
	for (std::size_t k = first; k < end; ++k)
	{
		if (!in_view(k)) continue;
		ways.open_m[k] = lengths.known_m[k - first];
		ways.worth_m[k] = lengths.expected_m[k - first];
		ways.seen_start[k] = lengths.seen_start[k - first];
	}
	return ways;
}

std::vector<double> Ways::openAlong(const DirectionFan& fan) const
{
	return m_as_printed ? printedLengths(fan) : m_open_path.along(fan);
}

WayFan Ways::along(const Direction& direction) const
{
	return along(DirectionFan{direction.azimuth_rad, 1.0, 1, direction.elevation_rad});
}

std::vector<double> Ways::printedLengths(const DirectionFan& fan) const
{
	std::vector<double> open_m(fan.count, m_config.max_range_m);
	for (const ObstacleSample& sample : m_open_path.samples())
	{
		for (std::size_t k = 0; k < fan.count; ++k)
		{
			const Direction direction = fan.at(k);
			const double ahead =
			    sample.x * std::cos(direction.azimuth_rad) + sample.y * std::sin(direction.azimuth_rad);
			const double along =
			    ahead * std::cos(direction.elevation_rad) + sample.z * std::sin(direction.elevation_rad);
			open_m[k] = std::min(open_m[k], std::max(0.0, std::abs(along) - m_robot.radius_m));
		}
	}
	return open_m;
}
}  // namespace explore

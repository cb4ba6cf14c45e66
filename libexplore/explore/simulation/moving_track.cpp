#include <explore/core/geometry.h>
#include <explore/simulation/moving_track.h>

#include <algorithm>

namespace explore::simulation
{
namespace
{
constexpr double kTurning_s = 0.4, kStanding_m = 1e-6;

Waypoint waypointAt(double t_s, const Eigen::Vector3d& position_in_map, double yaw_rad)
{
	return {t_s, position_in_map.head<2>(), position_in_map.z(), yaw_rad};
}

/** The heading of each leg; one without length keeps the heading before. */
std::vector<double> legYaws(const std::vector<TrackPoint>& points)
{
	std::vector<double> yaws;
	for (std::size_t i = 0; i + 1 < points.size(); ++i)
	{
		const Eigen::Vector3d leg = points[i + 1].position_in_map - points[i].position_in_map;
		const double before_rad = yaws.empty() ? 0.0 : yaws.back();
		yaws.push_back(leg.head<2>().norm() > kStanding_m ? azimuthOf(leg) : before_rad);
	}
	return yaws;
}
}  // namespace

std::vector<Waypoint> trackThrough(const std::vector<TrackPoint>& points)
{
	const std::vector<double> yaws = legYaws(points);
	std::vector<Waypoint> track;
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const TrackPoint& point = points[i];
		const double leaving_rad = yaws.empty() ? 0.0 : yaws[std::min(i, yaws.size() - 1)];
		if (i > 0 && !point.yaw_rad && !points[i - 1].yaw_rad)
		{
			const double leg_s = point.t_s - points[i - 1].t_s, turning_s = std::min(kTurning_s, leg_s / 2);
			const Eigen::Vector3d back = points[i - 1].position_in_map - point.position_in_map;
			track.push_back(
			    waypointAt(point.t_s - turning_s, point.position_in_map + turning_s / leg_s * back, yaws[i - 1]));
		}
		track.push_back(waypointAt(point.t_s, point.position_in_map, point.yaw_rad.value_or(leaving_rad)));
	}
	for (std::size_t i = 1; i < track.size(); ++i)
		track[i].yaw_rad = track[i - 1].yaw_rad + wrapToPi(track[i].yaw_rad - track[i - 1].yaw_rad);
	return track;
}
}  // namespace explore::simulation

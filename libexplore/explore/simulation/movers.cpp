#include <explore/core/geometry.h>
#include <explore/simulation/movers.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore::simulation
{
namespace
{
constexpr double kPatience_s = 5.0;

double distanceTo(const RobotFootprint& robot, const MovingBody& body, double t_s)
{
	return (placeAt(body.track, t_s).position_in_map - robot.position_in_map).norm() - robot.radius_m - body.radius_m;
}
}  // namespace

Waypoint placeAt(const std::vector<Waypoint>& track, double t_s)
{
	const auto after = std::find_if(track.begin(), track.end(), [&](const Waypoint& point) { return point.t_s > t_s; });
	if (after == track.begin()) return track.front();
	if (after == track.end()) return track.back();
	const Waypoint &a = *(after - 1), &b = *after;
	const double share = (t_s - a.t_s) / (b.t_s - a.t_s);
	return {t_s, a.position_in_map + share * (b.position_in_map - a.position_in_map), a.z_m + share * (b.z_m - a.z_m),
	        wrapToPi(a.yaw_rad + share * wrapToPi(b.yaw_rad - a.yaw_rad))};
}

Movers::Movers(const World& world)
{
	for (const MovingBody& body : world.moving) m_movers.push_back({&body});
}

double Movers::laterOn(const Mover& mover, double dt_s)
{
	const std::vector<Waypoint>& track = mover.body->track;
	const double first = track.front().t_s, last = track.back().t_s, length = last - first;
	const double t_s = mover.t_s + mover.direction * dt_s;
	if (mover.direction < 0.0) return std::max(t_s, first);
	if (t_s <= last || !mover.body->loop || length <= 0.0) return std::min(t_s, std::max(last, mover.t_s));
	return first + std::fmod(t_s - first, length);
}

void Movers::advance(double dt_s, const RobotFootprint& robot)
{
	for (Mover& mover : m_movers)
	{
		const MovingBody& body = *mover.body;
		if (body.track.empty()) continue;
		const double t_s = laterOn(mover, dt_s);
		const double now = distanceTo(robot, body, mover.t_s), then = distanceTo(robot, body, t_s);
		if (then < body.gap_m && then < now)
		{
			mover.waited_s += dt_s;
			if (mover.waited_s < kPatience_s) continue;
			mover.direction = -mover.direction;
			mover.waited_s = 0.0;
			continue;
		}
		mover.waited_s = 0.0;
		mover.t_s = t_s;
		if (mover.direction < 0.0 && t_s <= body.track.front().t_s) mover.direction = 1.0;
	}
}

std::vector<Eigen::Isometry3d> Movers::placement() const
{
	std::vector<Eigen::Isometry3d> map_from_body;
	for (const Mover& mover : m_movers)
	{
		Eigen::Isometry3d& placed = map_from_body.emplace_back(Eigen::Isometry3d::Identity());
		if (mover.body->track.empty()) continue;
		const Waypoint place = placeAt(mover.body->track, mover.t_s);
		const double yaw_rad = place.yaw_rad + (mover.direction < 0.0 ? std::numbers::pi : 0.0);
		placed.translate(Eigen::Vector3d(place.position_in_map.x(), place.position_in_map.y(), place.z_m));
		placed.rotate(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
	}
	return map_from_body;
}
}  // namespace explore::simulation

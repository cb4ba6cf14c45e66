#include <explore/navigation/way_ahead.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace explore
{
namespace
{
/** Of a point on the way: its distance from `at`, and how far along the way it lies. */
struct OnWay
{
	std::size_t leg = 0;
	double share = 0;
	double away_m = std::numeric_limits<double>::infinity();
};

OnWay nearestOn(const std::vector<Eigen::Vector3d>& way, const Eigen::Vector3d& at)
{
	OnWay nearest;
	for (std::size_t leg = 0; leg + 1 < way.size(); ++leg)
	{
		const Eigen::Vector3d along = way[leg + 1] - way[leg];
		const double squared = along.squaredNorm();
		const double share = squared > 0.0 ? std::clamp(along.dot(at - way[leg]) / squared, 0.0, 1.0) : 0.0;
		const double away_m = (way[leg] + share * along - at).norm();
		if (away_m < nearest.away_m) nearest = {leg, share, away_m};
	}
	return nearest;
}
}  // namespace

Aim aimOn(const std::vector<Eigen::Vector3d>& way, const Eigen::Vector3d& at, double ahead_m)
{
	if (way.size() < 2) return {way.empty() ? at : way.back(), way.empty() ? 0.0 : (way.back() - at).norm()};
	const OnWay here = nearestOn(way, at);
	Eigen::Vector3d from = way[here.leg] + here.share * (way[here.leg + 1] - way[here.leg]);
	Aim aim{way.back(), 0.0};
	bool found = false;
	for (std::size_t leg = here.leg; leg + 1 < way.size(); ++leg)
	{
		const double length_m = (way[leg + 1] - from).norm();
		if (!found && aim.rest_m + length_m >= ahead_m)
		{
			aim.point_in_map = from + (way[leg + 1] - from) * ((ahead_m - aim.rest_m) / length_m);
			found = true;
		}
		aim.rest_m += length_m;
		from = way[leg + 1];
	}
	return aim;
}
}  // namespace explore

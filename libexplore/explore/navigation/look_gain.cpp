#include <explore/core/geometry.h>
#include <explore/navigation/look_gain.h>

#include <cmath>

namespace explore
{
namespace
{
constexpr double kRayStep_rad = 0.052;  // 3°: 21 cm apart at 4 m
/** What is nearer lies below the image. */
constexpr double kNearest_m = 0.25;

/** Of one ray, its area a radian of width [m²]. */
double gainAlong(const PlanMap& map, const Look& look, double azimuth_rad, const PlanConfig& config)
{
	const Eigen::Array3i from = map.placeOf(look.cell);
	const Eigen::Array2d direction(std::cos(azimuth_rad), std::sin(azimuth_rad));
	const double step_m = map.frame.resolution_m;  // no wall of one cell is stepped over
	double gain = 0.0, passed_m = 0.0;
	for (double at_m = kNearest_m; at_m < config.view_range_m && passed_m < config.view_depth_m; at_m += step_m)
	{
		const Eigen::Array2i to =
		    (from.head<2>().cast<double>() + direction * (at_m / step_m) + 0.5).floor().cast<int>();
		const Eigen::Array3i place(to.x(), to.y(), from.z());
		if (!map.contains(place)) break;
		const CellIndex cell = map.cellAt(place);
		if (map.cells[cell] == CellState::occupied) break;
		if (map.cells[cell] != CellState::unknown) continue;
		if (map.wanted[cell] != 0) gain += at_m * step_m;
		passed_m += step_m;
	}
	return gain;
}
}  // namespace

double lookGain(const PlanMap& map, const Look& look, const PlanConfig& config)
{
	const int rays = std::max(1, static_cast<int>(std::lround(config.view_angle_rad / kRayStep_rad)));
	const double apart_rad = config.view_angle_rad / rays;
	double gain = 0.0;
	for (int i = 0; i < rays; ++i)
	{
		const double azimuth_rad = look.yaw_rad + (i + 0.5) * apart_rad - 0.5 * config.view_angle_rad;
		gain += gainAlong(map, look, azimuth_rad, config) * apart_rad;
	}
	return gain;
}

bool sees(const PlanMap& map, const Look& look, const Eigen::Vector3d& point_in_map, const PlanConfig& config)
{
	const Eigen::Vector2d way = (point_in_map - map.middleOf(look.cell)).head<2>();
	const double away_m = way.norm(), azimuth_rad = std::atan2(way.y(), way.x());
	if (away_m > config.view_range_m || std::abs(wrapToPi(azimuth_rad - look.yaw_rad)) > 0.5 * config.view_angle_rad)
		return false;
	const Eigen::Array3i from = map.placeOf(look.cell);
	const int steps = static_cast<int>(away_m / map.frame.resolution_m);
	for (int i = 0; i < steps; ++i)
	{
		const Eigen::Array2d off = way.array() * (static_cast<double>(i) / (steps * map.frame.resolution_m));
		const Eigen::Array2i at = (from.head<2>().cast<double>() + off + 0.5).floor().cast<int>();
		const Eigen::Array3i place(at.x(), at.y(), from.z());
		if (!map.contains(place) || map.cells[map.cellAt(place)] != CellState::free) return false;
	}
	return true;
}
}  // namespace explore

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

/** The nearest whole number, for more than -kFar; std::floor is a call into a library on most machines. */
int rounded(double cells)
{
	constexpr int kFar = 1 << 16;
	return static_cast<int>(cells + (kFar + 0.5)) - kFar;
}

/** Of one ray, its area a radian of width [m²]. */
double gainAlong(const PlanMap& map, const Look& look, double azimuth_rad, const PlanConfig& config)
{
	const Eigen::Array3i from = map.placeOf(look.cell);
	const Eigen::Array2d direction(std::cos(azimuth_rad), std::sin(azimuth_rad));
	const double step_m = map.frame.resolution_m;  // no wall of one cell is stepped over
	double gain = 0.0, passed_m = 0.0;
	for (double at_m = kNearest_m; at_m < config.view_range_m && passed_m < config.view_depth_m; at_m += step_m)
	{
		const int column = rounded(from.x() + direction.x() * (at_m / step_m));
		const int row = rounded(from.y() + direction.y() * (at_m / step_m));
		if (column < 0 || row < 0 || column >= map.frame.columns || row >= map.frame.rows) break;
		const CellIndex cell = map.cellAt({column, row, from.z()});
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
	const Eigen::Vector3d from = map.middleOf(look.cell), way = point_in_map - from;
	const double away_m = way.head<2>().norm();
	const double azimuth_rad = azimuthOf(way), elevation_rad = std::atan2(way.z(), away_m);
	if (away_m > config.view_range_m || std::abs(wrapToPi(azimuth_rad - look.yaw_rad)) > 0.5 * config.view_angle_rad ||
	    std::abs(elevation_rad) > 0.5 * config.view_height_rad)
		return false;
	const int steps = static_cast<int>(away_m / map.frame.resolution_m);
	for (int i = 0; i < steps; ++i)
	{
		const CellIndex cell = map.cellOf(from + way * (static_cast<double>(i) / steps));
		if (cell == kNoCell || map.cells[cell] != CellState::free) return false;
	}
	return true;
}
}  // namespace explore

#include <explore/navigation/look_gain.h>

#include <cmath>

namespace explore
{
namespace
{
constexpr double kRayStep_rad = 0.052;  // 3°: 21 cm apart at 4 m
/** Along a ray; what is as wide as the robot is not missed. */
constexpr double kStep_cells = 2.0;
/** What is nearer lies below the image. */
constexpr double kNearest_m = 0.25;

/** Of one ray, its area a radian of width [m²]. */
double gainAlong(const PlanMap& map, const Look& look, double azimuth_rad, const PlanConfig& config)
{
	const Eigen::Array3i from = map.placeOf(look.cell);
	const Eigen::Array2d direction(std::cos(azimuth_rad), std::sin(azimuth_rad));
	const double cell_m = map.frame.resolution_m, step_m = kStep_cells * cell_m;
	double gain = 0.0, passed_m = 0.0;
	for (double at_m = kNearest_m; at_m < config.view_range_m && passed_m < config.view_depth_m; at_m += step_m)
	{
		const Eigen::Array2i to =
		    (from.head<2>().cast<double>() + direction * (at_m / cell_m) + 0.5).floor().cast<int>();
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
}  // namespace explore

// The samples of a view that may stand on walls, and those of the floor, in the plan view, to be held against many
// lines.
#pragma once

#include <explore/perception/level_view.h>
#include <explore/perception/upright_walls.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

namespace explore
{
/** Samples seen from above; all arrays have the same length, in the order of LevelSamples. */
struct PlanPoints
{
	std::vector<float> x, y;            ///< level frame [m]
	std::vector<float> sigma_per_m;     ///< σ_z / depth: times the distance from a plane it is the noise across it
	std::vector<std::uint32_t> sample;  ///< place in LevelSamples
	std::vector<std::int16_t> row;      ///< of the image

	[[nodiscard]] std::size_t size() const { return x.size(); }
};

/** Those that are not floor, below the height of ceilings. */
PlanPoints uprightPoints(const LevelView& view, const SensorNoiseConfig& noise);

/** The samples of the floor. */
PlanPoints floorPoints(const LevelView& view, const SensorNoiseConfig& noise);

/** How far [m] a point may lie from a plane it belongs to, as wallTolerance has it; `across_m` is the point's distance
 *  from the camera at right angles to the plane. */
[[nodiscard]] inline double toleranceAcross(double across_m, double sigma_per_m, const UprightWallConfig& config)
{
	return config.tolerance_m + config.tolerance_sigmas * sigma_per_m * std::abs(across_m);
}

/** The same points seen along a corridor: `along` its direction and `across` it, positive to the left [m]. */
struct TurnedPoints
{
	std::vector<float> along, across;
};

TurnedPoints turnedTo(const Eigen::Vector2d& direction, const PlanPoints& points);
}  // namespace explore

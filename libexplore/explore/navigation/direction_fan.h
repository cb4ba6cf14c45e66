// Directions of travel, one and many: what open paths are asked for.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

namespace explore
{
/** A direction of travel in the level frame. */
struct Direction
{
	double azimuth_rad = 0;    ///< positive left
	double elevation_rad = 0;  ///< positive up
};

/** The directions first_rad + k · step_rad, k = 0 … count − 1, at one elevation; they span less than a full turn. */
struct DirectionFan
{
	double first_rad = 0, step_rad = 0;
	std::size_t count = 0;
	double elevation_rad = 0;

	[[nodiscard]] Direction at(std::size_t k) const
	{
		return {first_rad + static_cast<double>(k) * step_rad, elevation_rad};
	}
};

/** Calls `visit(k)` for the directions of the fan within ± half_width_rad of an azimuth (and perhaps one more). */
template <class Visit>
void forEachNear(const DirectionFan& fan, double azimuth_rad, double half_width_rad, const Visit& visit)
{
	constexpr double kTurn = 2.0 * std::numbers::pi;
	const double per_rad = 1.0 / fan.step_rad, last = static_cast<double>(fan.count) - 1.0;
	double offset = azimuth_rad - fan.first_rad;
	if (offset < 0.0) offset += kTurn;
	// The fan covers [0, last · step]: the azimuth matters to it as it is, or a turn less or more. Truncation stands
	// for floor, which this instruction set has no fast form of.
	for (const double center : std::array<double, 3>{offset - kTurn, offset, offset + kTurn})
	{
		const double to = std::min(last, (center + half_width_rad) * per_rad);
		const double from = std::max(0.0, (center - half_width_rad) * per_rad);
		if (to < 0.0 || from > last) continue;
		for (auto k = static_cast<std::size_t>(from); k <= static_cast<std::size_t>(to); ++k) visit(k);
	}
}
}  // namespace explore

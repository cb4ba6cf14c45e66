// Depths as rawlogs store them: whole millimetres in 16 bits.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace explore
{
inline constexpr double kDepthCountsPerMetre = 1000.0;

/** 0 (no return) for what is not above 0, or farther away than the numbers reach: 65.535 m. */
[[nodiscard]] inline std::uint16_t depthCountsOf(float depth_m)
{
	const double counts = std::round(kDepthCountsPerMetre * static_cast<double>(depth_m));
	return counts > 0.0 && counts <= std::numeric_limits<std::uint16_t>::max() ? static_cast<std::uint16_t>(counts)
	                                                                           : std::uint16_t{0};
}
}  // namespace explore

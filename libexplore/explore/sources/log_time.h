// Times as rawlogs carry them: which are usable, and differences in seconds.
#pragma once

#include <mrpt/core/Clock.h>

#include <chrono>
#include <cstdint>

namespace explore
{
using LogTime = mrpt::Clock::time_point;

/** False for MRPT's INVALID_TIMESTAMP and for times so far off that differences would overflow. */
[[nodiscard]] inline bool isUsable(LogTime time)
{
	const std::int64_t ticks = time.time_since_epoch().count();
	return ticks > 0 && ticks < (std::int64_t{1} << 61);
}

[[nodiscard]] inline double secondsBetween(LogTime from, LogTime to)
{
	return std::chrono::duration<double>(to - from).count();
}

[[nodiscard]] inline LogTime later(LogTime time, double seconds)
{
	return time + std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::duration<double>(seconds));
}
}  // namespace explore

// Keeps the pace at which frames were taken, for who wants to watch.
#pragma once

#include <mrpt/core/Clock.h>

#include <chrono>
#include <optional>

namespace explore::app
{
/** The first frame sets the clock. */
class Pace
{
public:
	/** Sleeps until as much time has passed since the first call as lies between the frames' time stamps. */
	void waitFor(mrpt::Clock::time_point frame);

private:
	struct Start
	{
		mrpt::Clock::time_point frame;
		std::chrono::steady_clock::time_point now;
	};
	std::optional<Start> m_start;
};
}  // namespace explore::app

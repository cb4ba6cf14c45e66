#include <explore-mrpt/pace.h>

#include <thread>

namespace explore::app
{
void Pace::waitFor(mrpt::Clock::time_point frame)
{
	if (!m_start) m_start = Start{frame, std::chrono::steady_clock::now()};
	std::this_thread::sleep_until(m_start->now + (frame - m_start->frame));
}
}  // namespace explore::app

#include <explore/sinks/robot_link/robot_link.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <utility>

namespace explore
{
namespace
{
/** So often the last word is said: datagrams get lost. */
constexpr int kLastStops = 5;
constexpr std::chrono::milliseconds kBetweenLastStops{10};

/** Writing to a pipe whose reader is gone is an error of the write, and no signal. */
void ignoreBrokenPipes()
{
	sigset_t signals;
	::sigemptyset(&signals);
	::sigaddset(&signals, SIGPIPE);
	// Those that end the program are for its main thread, which may be waiting for a frame.
	::sigaddset(&signals, SIGINT);
	::sigaddset(&signals, SIGTERM);
	::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

std::chrono::steady_clock::duration durationOf(double seconds)
{
	return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
}

std::string watchdogRemark(double watchdog_s)
{
	std::array<char, 100> text{};
	std::snprintf(text.data(), text.size(), "robot link: no new decision for %g s: the robot was told to stop",
	              watchdog_s);
	return text.data();
}
}  // namespace

RobotLink::RobotLink(std::unique_ptr<CommandSink> sink, const RobotLinkTiming& timing, LinkRemarks& remarks,
                     std::function<bool()> halted)
    : m_sink(std::move(sink)),
      m_timing(timing),
      m_remarks(remarks),
      m_halted(std::move(halted)),
      m_thread([this] { run(); })
{
}

RobotLink::~RobotLink()
{
	stop();
}

void RobotLink::decided(const Decision& decision, double t_s)
{
	const std::scoped_lock lock(m_mutex);
	if (m_failure) std::rethrow_exception(std::exchange(m_failure, nullptr));
	m_hurries = m_hurries || (decision.stop && !m_order.stop);
	m_order = {{t_s, decision.command}, decision.stop, Clock::now()};
	m_decided = true;
	if (m_hurries) m_wake.notify_all();
}

void RobotLink::stop() noexcept
{
	{
		const std::scoped_lock lock(m_mutex);
		m_ends = true;
	}
	m_wake.notify_all();
	if (m_thread.joinable()) m_thread.join();
}

void RobotLink::sendOne()
{
	std::unique_lock lock(m_mutex);
	const Order order = m_order;
	const bool late = Clock::now() - order.since > durationOf(m_timing.watchdog_s);
	if (m_decided && late) m_remarks.say("watchdog", watchdogRemark(m_timing.watchdog_s));
	const bool may_move = m_decided && !late && !order.stop;
	lock.unlock();  // a slow receiver must not keep the explorer waiting
	if (may_move && !(m_halted && m_halted()))
		m_sink->send(order.command);
	else
		m_sink->stop(order.command.t_s);
}

void RobotLink::sendLast()
{
	std::unique_lock lock(m_mutex);
	const std::optional<double> t_s = m_order.command.t_s;
	lock.unlock();
	for (int i = 0; i < kLastStops; ++i)
	{
		if (i > 0) std::this_thread::sleep_for(kBetweenLastStops);
		m_sink->stop(t_s);
	}
}

void RobotLink::sendUntilTheEnd()
{
	const auto period = durationOf(1.0 / m_timing.rate_hz);
	auto next = Clock::now();
	while (true)
	{
		sendOne();
		// What was missed in a stall is not made up for: the robot wants the newest command, not many.
		next = std::max(next + period, Clock::now());
		std::unique_lock lock(m_mutex);
		// An order that runs out before then is taken back when it does.
		const auto runs_out = m_order.since + durationOf(m_timing.watchdog_s) + std::chrono::milliseconds(1);
		if (m_decided && !m_order.stop && runs_out > Clock::now()) next = std::min(next, runs_out);
		m_wake.wait_until(lock, next, [this] { return m_ends || m_hurries; });
		m_hurries = false;
		if (m_ends) return;
	}
}

void RobotLink::run()
{
	ignoreBrokenPipes();
	const auto failed = [this]
	{
		const std::scoped_lock lock(m_mutex);
		if (!m_failure) m_failure = std::current_exception();
	};
	try
	{
		sendUntilTheEnd();
	}
	catch (...)
	{
		failed();
	}
	try
	{
		sendLast();  // after a failure as well: it may have been the command's
	}
	catch (...)
	{
		failed();
	}
}
}  // namespace explore

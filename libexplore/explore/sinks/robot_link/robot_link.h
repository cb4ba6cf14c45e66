// Sends the explorer's decisions to the robot at a fixed rate, and stops it when decisions fail to come.
#pragma once

#include <explore/sinks/robot_link/command_sink.h>
#include <explore/sinks/robot_link/link_remarks.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace explore
{
struct RobotLinkTiming
{
	double rate_hz = 20.0;
	double watchdog_s = 0.2;
};

/** A thread of its own repeats the last decision, so that neither the camera's rate nor a stall of the explorer reaches
 *  the robot. Before the first decision, when none came for `watchdog_s`, when `halted()` says so and at the end it
 *  tells the robot to stop. */
class RobotLink
{
public:
	using Clock = std::chrono::steady_clock;
	/** `halted` is asked before every command, on the thread of the link; empty = never. `remarks` outlives the link.
	 */
	RobotLink(std::unique_ptr<CommandSink> sink, const RobotLinkTiming& timing, LinkRemarks& remarks,
	          std::function<bool()> halted = {});
	RobotLink(const RobotLink&) = delete;
	RobotLink& operator=(const RobotLink&) = delete;
	~RobotLink();

	/** What the robot is to do from now on; `t_s` is the frame's time, as in TimedCommand. Throws what the sink threw
	 *  since the last call. */
	void decided(const Decision& decision, double t_s);
	/** Sends stop several times and ends; later decisions are not sent. May be called again. Does not throw. */
	void stop() noexcept;

private:
	struct Order
	{
		TimedCommand command;
		bool stop = true;
		Clock::time_point since;
	};
	void run();
	/** These three throw what the sink throws. */
	void sendUntilTheEnd();
	void sendOne();
	void sendLast();

	std::unique_ptr<CommandSink> m_sink;
	RobotLinkTiming m_timing;
	LinkRemarks& m_remarks;
	std::function<bool()> m_halted;

	std::mutex m_mutex;
	std::condition_variable m_wake;
	Order m_order;           ///< guarded by m_mutex, as all below
	bool m_decided = false;  ///< at least once
	bool m_hurries = false;  ///< a stop does not wait for its turn
	bool m_ends = false;
	std::exception_ptr m_failure;  ///< of the sink
	std::thread m_thread;          ///< last: it uses all above
};
}  // namespace explore

// Messages of the robot on their way from the thread that receives them to the frames.
#pragma once

#include <explore/sinks/robot_link/link_remarks.h>
#include <explore/sinks/robot_link/robot_message.h>

#include <cstddef>
#include <deque>
#include <mutex>
#include <string_view>
#include <vector>

namespace explore
{
/** What touches the robot, or does not carry it. */
struct RobotAlarms
{
	bool bumper_pressed = false, cliff_seen = false;
	[[nodiscard]] bool any() const { return bumper_pressed || cliff_seen; }
};

/** May be used from every thread. */
class RobotInbox
{
public:
	/** So many messages wait to be drained; of more, the oldest are lost. */
	static constexpr std::size_t kMostWaiting = 4096;

	/** `remarks` outlives it. */
	explicit RobotInbox(LinkRemarks& remarks) : m_remarks(remarks) {}

	/** Takes one message that came at `received`. What is none is counted, and the first one remarked. */
	void take(std::string_view text, mrpt::Clock::time_point received);
	/** Counts something that came and is no message; `what` names it in the remark. */
	void refuse(std::string_view what);

	/** Those that came since the last call, in their order. */
	[[nodiscard]] std::vector<RobotMessage> drain();
	/** As the last messages said, drained or not. */
	[[nodiscard]] RobotAlarms alarms() const;
	/** Messages so far that were none. */
	[[nodiscard]] std::size_t malformed() const;

private:
	LinkRemarks& m_remarks;
	mutable std::mutex m_mutex;
	std::deque<RobotMessage> m_waiting;
	RobotAlarms m_alarms;
	std::size_t m_malformed = 0;
};
}  // namespace explore

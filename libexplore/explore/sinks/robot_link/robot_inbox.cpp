#include <explore/sinks/robot_link/robot_inbox.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace explore
{
namespace
{
/** The beginning of a message, fit to be shown. */
std::string shown(std::string_view text)
{
	constexpr std::size_t kMost = 60;
	std::string result(text.substr(0, kMost));
	std::ranges::replace_if(
	    result, [](char c) { return c < ' ' || c > '~'; }, '?');
	return result + (text.size() > kMost ? "..." : "");
}
}  // namespace

void RobotInbox::take(std::string_view text, mrpt::Clock::time_point received)
{
	auto message = parseRobotMessage(text, received);
	if (!message) return refuse(text);
	const std::scoped_lock lock(m_mutex);
	if (message->bumper_pressed) m_alarms.bumper_pressed = message->bumper_pressed->value;
	if (message->cliff_seen) m_alarms.cliff_seen = message->cliff_seen->value;
	if (m_waiting.size() == kMostWaiting) m_waiting.pop_front();
	m_waiting.push_back(*std::move(message));
}

void RobotInbox::refuse(std::string_view what)
{
	m_remarks.say("malformed", "robot link: not a message of doc/robot-link.md, passed over: " + shown(what));
	const std::scoped_lock lock(m_mutex);
	++m_malformed;
}

std::vector<RobotMessage> RobotInbox::drain()
{
	const std::scoped_lock lock(m_mutex);
	std::vector<RobotMessage> messages(std::make_move_iterator(m_waiting.begin()),
	                                   std::make_move_iterator(m_waiting.end()));
	m_waiting.clear();
	return messages;
}

RobotAlarms RobotInbox::alarms() const
{
	const std::scoped_lock lock(m_mutex);
	return m_alarms;
}

std::size_t RobotInbox::malformed() const
{
	const std::scoped_lock lock(m_mutex);
	return m_malformed;
}
}  // namespace explore

// What the threads of the robot link have to say, kept until the run says it: its logger is for one thread.
#pragma once

#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace explore
{
/** May be used from every thread. */
class LinkRemarks
{
public:
	/** Keeps `text` unless something of this `kind` was said before. */
	void say(const std::string& kind, std::string text)
	{
		const std::scoped_lock lock(m_mutex);
		if (m_kinds.insert(kind).second) m_texts.push_back(std::move(text));
	}
	/** What was said since the last call. */
	[[nodiscard]] std::vector<std::string> take()
	{
		const std::scoped_lock lock(m_mutex);
		return std::exchange(m_texts, {});
	}

private:
	std::mutex m_mutex;
	std::set<std::string> m_kinds;
	std::vector<std::string> m_texts;
};
}  // namespace explore

// Says each kind of warning a single time, however many frames show it.
#pragma once

#include <mrpt/system/COutputLogger.h>

#include <set>
#include <string>
#include <vector>

namespace explore
{
class WarnOnce
{
public:
	explicit WarnOnce(mrpt::system::COutputLogger& logger) : m_logger(&logger) {}

	/** Logs `text` unless `kind` was warned of before. */
	void operator()(const std::string& kind, const std::string& text)
	{
		if (m_said.insert(kind).second) m_logger->logStr(mrpt::system::LVL_WARN, text);
	}
	/** Writes or reads what was warned of. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		std::vector<std::string> said(m_said.begin(), m_said.end());
		archive(said);
		m_said = {said.begin(), said.end()};
	}
	void info(const std::string& text) { m_logger->logStr(mrpt::system::LVL_INFO, text); }

private:
	mrpt::system::COutputLogger* m_logger;
	std::set<std::string> m_said;
};
}  // namespace explore

#include <explore/simulation/sdf/warnings.h>

#include <algorithm>

namespace explore::simulation
{
void Warnings::add(const std::string& message)
{
	constexpr std::size_t kMost = 50;
	const auto same = [&message](const Entry& entry) { return entry.message == message; };
	const auto found = std::find_if(m_entries.begin(), m_entries.end(), same);
	if (found != m_entries.end())
		++found->count;
	else if (m_entries.size() < kMost)
		m_entries.push_back({message});
	else
		++m_left_out;
}

std::vector<std::string> Warnings::list() const
{
	std::vector<std::string> messages;
	for (const Entry& entry : m_entries)
	{
		messages.push_back(entry.message);
		if (entry.count > 1) messages.back().append(" (").append(std::to_string(entry.count)).append(" times)");
	}
	if (m_left_out > 0) messages.push_back(std::to_string(m_left_out).append(" further warnings are not listed"));
	return messages;
}
}  // namespace explore::simulation

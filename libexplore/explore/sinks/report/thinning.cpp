#include <explore/sinks/report/thinning.h>

namespace explore
{
void Thinning::add(std::size_t frame, std::size_t bytes)
{
	if (!wants(frame)) return;
	m_kept.emplace_back(frame, bytes);
	m_bytes += bytes;
	while (m_kept.size() > 1 && (m_bytes > m_limits.bytes || m_kept.size() > m_limits.count)) halve();
}

void Thinning::halve()
{
	m_stride *= 2;
	std::erase_if(m_kept, [&](const auto& kept) { return !wants(kept.first); });
	m_bytes = 0;
	for (const auto& kept : m_kept) m_bytes += kept.second;
}
}  // namespace explore

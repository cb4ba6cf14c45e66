#include "allocation_limit.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>

namespace explore
{
namespace
{
/** What RLIMIT_DATA counts: private writable pages, asked for or used. */
std::optional<std::uint64_t> dataBytes()
{
#ifdef __SANITIZE_ADDRESS__
	return std::nullopt;
#else
	std::ifstream file("/proc/self/statm");
	std::uint64_t size = 0, resident = 0, shared = 0, text = 0, lib = 0, data = 0;
	if (!(file >> size >> resident >> shared >> text >> lib >> data)) return std::nullopt;
	return data * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
#endif
}
}  // namespace

AllocationLimit::AllocationLimit(std::uint64_t headroom_bytes)
{
	const std::optional<std::uint64_t> used_bytes = dataBytes();
	if (!used_bytes || getrlimit(RLIMIT_DATA, &m_before) != 0) return;
	rlimit limited = m_before;
	limited.rlim_cur = std::min<rlim_t>(m_before.rlim_cur, *used_bytes + headroom_bytes);
	m_active = setrlimit(RLIMIT_DATA, &limited) == 0;
}

AllocationLimit::~AllocationLimit()
{
	if (m_active) setrlimit(RLIMIT_DATA, &m_before);
}
}  // namespace explore

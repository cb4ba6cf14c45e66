// Keeps a damaged size field from taking all the machine's memory while an object is deserialised.
#pragma once

#include <sys/resource.h>

#include <cstdint>

namespace explore
{
/** While it lives, allocations that take the process `headroom_bytes` above its present size fail with std::bad_alloc.
 *  MRPT's deserialisers resize to whatever count they read; one flipped bit asks for 16 GB, which Linux grants and then
 *  kills for. The limit is that of the whole process, so it is held for one object at a time and leaves ample headroom
 *  to other threads. Without effect where the platform does not tell the process size, or under AddressSanitizer, which
 *  aborts where an allocation is refused. */
class AllocationLimit
{
public:
	explicit AllocationLimit(std::uint64_t headroom_bytes);
	~AllocationLimit();
	AllocationLimit(const AllocationLimit&) = delete;
	AllocationLimit& operator=(const AllocationLimit&) = delete;

private:
	bool m_active = false;
	rlimit m_before{};
};
}  // namespace explore

#include <explore/core/heap.h>

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace explore
{
void keepFreedMemory()
{
#ifdef __GLIBC__
	constexpr int kThreshold_bytes = 64 << 20;
	mallopt(M_MMAP_THRESHOLD, kThreshold_bytes);
	mallopt(M_TRIM_THRESHOLD, 4 * kThreshold_bytes);
#endif
}
}  // namespace explore

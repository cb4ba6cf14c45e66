#include <explore/memory/stations.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace explore
{
bool Stations::moveTo(const Eigen::Vector3d& camera_in_map)
{
	// Rounded up, so that as many stations pass as there are hops in the way.
	int hops = 1;
	if (m_current != 0)
	{
		const double moved_m = (camera_in_map - origin(m_current)).norm();
		if (moved_m < kHop_m) return false;
		hops = static_cast<int>(std::min(std::ceil(moved_m / kHop_m), static_cast<double>(kRecent)));
	}
	const bool full = m_current + hops > std::numeric_limits<std::uint16_t>::max();
	if (full) m_current = 0;
	for (int i = 0; i < hops; ++i)
	{
		++m_current;
		m_origins[m_current % kRecent] = camera_in_map;
	}
	return full;
}
}  // namespace explore

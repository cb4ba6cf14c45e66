#include <explore/perception/clear_width.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace explore
{
double clearWidth(double width_m, const std::vector<Eigen::Vector2d>& obstacles)
{
	// Prim's algorithm from the left jamb: the longest hop needed so far to reach each obstacle.
	std::vector<double> longest_hop_m(obstacles.size());
	for (std::size_t i = 0; i < obstacles.size(); ++i)
		longest_hop_m[i] = std::hypot(std::max(0.0, obstacles[i].x()), obstacles[i].y());
	std::vector<bool> reached(obstacles.size(), false);
	double clear_m = width_m;
	for (std::size_t round = 0; round < obstacles.size(); ++round)
	{
		std::size_t next = obstacles.size();
		for (std::size_t i = 0; i < obstacles.size(); ++i)
			if (!reached[i] && (next == obstacles.size() || longest_hop_m[i] < longest_hop_m[next])) next = i;
		if (longest_hop_m[next] >= clear_m) break;
		reached[next] = true;
		const double last_hop_m = std::hypot(std::max(0.0, width_m - obstacles[next].x()), obstacles[next].y());
		clear_m = std::min(clear_m, std::max(longest_hop_m[next], last_hop_m));
		for (std::size_t i = 0; i < obstacles.size(); ++i)
			longest_hop_m[i] =
			    std::min(longest_hop_m[i], std::max(longest_hop_m[next], (obstacles[i] - obstacles[next]).norm()));
	}
	return clear_m;
}
}  // namespace explore

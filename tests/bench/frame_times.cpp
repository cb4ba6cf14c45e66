#include "frame_times.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>

namespace explore::test
{
double threadTime_ms()
{
	timespec time{};
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
	return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double quantile(std::vector<double> values, double share)
{
	const double rank = std::max(1.0, std::ceil(share * static_cast<double>(values.size())));
	const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
	std::ranges::nth_element(values, place);
	return *place;
}
}  // namespace explore::test

// Splits a loop over rows among threads.
#pragma once

#include <algorithm>
#include <thread>
#include <vector>

namespace explore::simulation
{
/** Calls work(first, last) for slices of [0, rows) that are multiples of `grain` long (but the last), each on a thread
 * of its own. `work` may not throw, and its result may not depend on the slicing. */
template <class Work>
void parallelRows(int rows, int grain, int threads, const Work& work)
{
	const int grains = (rows + grain - 1) / grain;
	const int slices = std::clamp(threads, 1, std::max(grains, 1));
	const auto edge = [&](int slice) { return std::min(rows, grains * slice / slices * grain); };
	std::vector<std::jthread> helpers;
	for (int slice = 1; slice < slices; ++slice)
		helpers.emplace_back([&work, first = edge(slice), last = edge(slice + 1)] { work(first, last); });
	work(0, edge(1));
}
}  // namespace explore::simulation

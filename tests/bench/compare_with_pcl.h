// The last line of the benchmarks: how many times as long PCL takes for the same frames.
#pragma once

#include <explore/pipeline/explorer.h>

#include <vector>

namespace explore::test
{
/** Both pipelines on every frame in turn, several times over, so that whatever slows the machine slows both; prints the
 *  medians of their stages and the ratio of the two totals. */
void compareWithPcl(const std::vector<DepthFrame>& frames, const ExplorerConfig& config);
}  // namespace explore::test

// Processor time of single frames, for figures that a mean over all of them hides.
#pragma once

#include <vector>

namespace explore::test
{
/** Processor time of this thread [ms]: what other programs do on the machine does not count. */
double threadTime_ms();

/** The smallest of `values` that at least this share (0–1] of them does not exceed: nearest rank. Values must not be
 *  empty. */
double quantile(std::vector<double> values, double share);
}  // namespace explore::test

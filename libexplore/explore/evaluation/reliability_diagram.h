// A reliability diagram as a drawing that stands inside an HTML page.
#pragma once

#include <explore/evaluation/statistics.h>

#include <span>
#include <string>

namespace explore::evaluation
{
/** An svg element, 420 × 460 px: the share of right candidates over their mean confidence, a disc a bin whose area
 * grows with its count, beside the diagonal of perfect confidences. "" without bins. */
std::string reliabilitySvg(std::span<const ReliabilityBin> bins);
}  // namespace explore::evaluation

// frames.jsonl: one line of JSON per depth frame.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/pipeline/explorer.h>

#include <string>

namespace explore
{
/** The line of `frame`, ended by a newline; fields and units in doc/output-format.md. Depends on its arguments alone,
 * so that equal runs give equal bytes. Throws std::logic_error when a number in it is not finite. */
std::string frameLine(const DepthFrame& frame, const StepResult& result);
}  // namespace explore

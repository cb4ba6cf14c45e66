// One run of explore-mrpt: from the options to the exit code.
#pragma once

#include <explore-mrpt/options.h>

namespace explore::app
{
/** Returns 0, or 3 after damaged input, or 128 + the signal that ended the run; everything computed is on disk then.
 *  Throws the errors of core/errors.h. */
int run(const Options& options);
}  // namespace explore::app

// One run of explore-eval: from the options to the exit code.
#pragma once

#include <explore-eval/options.h>

namespace explore::app
{
/** Scores logs, or merges parts; prints the tables and writes the folder. Returns 0, 1 when a requirement is missed, or
 * 3 when a log was damaged or could not be read. Throws the errors of core/errors.h. */
int runEval(const EvalOptions& options);
}  // namespace explore::app

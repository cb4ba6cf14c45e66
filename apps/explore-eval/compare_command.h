// explore-eval compare: what other configurations change over the same logs.
#pragma once

#include <explore-eval/options.h>

namespace explore::app
{
/** Prints the tables and writes the folder. Returns 0, or 1 when a run costs more than it may. Throws the errors of
 *  core/errors.h. */
int compareEvaluations(const EvalOptions& options);
}  // namespace explore::app

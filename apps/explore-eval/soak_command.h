// explore-eval soak: explores simulated worlds again and again and tells how it went.
#pragma once

#include <explore-eval/options.h>

namespace explore::app
{
/** Runs explore-mrpt's exploration in each world with each seed, prints the tables and writes the folder. Returns 0, or
 * 3 when a run failed. Throws the errors of core/errors.h. */
int soak(const EvalOptions& options);
}  // namespace explore::app

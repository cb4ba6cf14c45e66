// The results of an evaluation as people read them, and as programs do.
#pragma once

#include <explore/evaluation/figures.h>

#include <string>

namespace explore::evaluation
{
/** The tables: the paper's Fig. 3(b) first, then families, errors, verdicts, causes, headings. */
std::string resultsText(const std::vector<LogScore>& logs, const Results& results);

/** All figures; doc/evaluation.md has the fields. */
Json resultsJson(const Results& results);
}  // namespace explore::evaluation

// Comparisons of runs as tables and as JSON, and what they may cost.
#pragma once

#include <explore/evaluation/compare_runs.h>

#include <string>
#include <vector>

namespace explore::evaluation
{
/** A table with a line a run and a column a figure, in points, and one of the families that changed most. */
std::string comparisonText(const std::string& base, const std::vector<RunComparison>& comparisons);

/** Everything; doc/evaluation.md has the fields. */
std::string comparisonJson(const std::string& base, const std::vector<RunComparison>& comparisons);

/** How many points a figure may get worse. */
struct CostLimit
{
	std::string name;       ///< as in comparedFigures()
	bool by_value = false;  ///< the measured difference itself, not the worse end of its interval
	double points = 0;      ///< 0–100
};
/** "precision=1,recall.value=1". Throws ConfigError that names the part and what is accepted. */
std::vector<CostLimit> parseCostLimits(const std::string& text);
/** The names, for --help and messages. */
std::string costLimitNames();
/** One line for each run and figure that costs more. What was not measured costs nothing. */
std::vector<std::string> exceededLimits(const std::vector<CostLimit>& limits,
                                        const std::vector<RunComparison>& comparisons);
}  // namespace explore::evaluation

// --require precision=0.99,recall=0.98: which figures a set of logs must reach.
#pragma once

#include <explore/evaluation/figures.h>

#include <string>
#include <vector>

namespace explore::evaluation
{
/** One figure and its bound. */
struct Requirement
{
	std::string name;       ///< as in requirementNames()
	std::string family;     ///< empty: over all logs; a family's name or "each": each of its groups by itself
	bool by_value = false;  ///< the measured value itself, not the end of its interval
	double bound = 0;       ///< 0–1

	/** "precision@each.value" */
	[[nodiscard]] std::string text() const;
};

/** precision, recall, … with how they are written, for --help and messages. */
std::string requirementNames();

/** "NAME[@FAMILY][.value]=NUMBER", separated by commas. Throws ConfigError that names the part and what is accepted. */
std::vector<Requirement> parseRequirements(const std::string& text);

/** One line for each requirement (and family) that is missed: "precision: measured 0.9731 (973 of 1000), 95 % interval
 *  0.9612 to 0.9841; required: at least 0.99 at the lower end of the interval". The end of the interval counts (lower
 *  for what must be large, upper for what must be small) unless the value is asked for. What was not measured is
 *  missed. */
std::vector<std::string> missedRequirements(const std::vector<Requirement>& requirements, const Results& results);
}  // namespace explore::evaluation

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
	std::string name;  ///< as in requirementNames(), with ".value" where the measured value itself is asked
	double bound = 0;  ///< 0–1
};

/** precision, recall, … with what they mean, for --help and messages. */
std::string requirementNames();

/** "NAME=NUMBER", separated by commas. Throws ConfigError that names the part and what is accepted. */
std::vector<Requirement> parseRequirements(const std::string& text);

/** One line for each requirement that is missed: "precision: measured 0.9731, 95 % interval 0.9612 … 0.9841; required:
 *  at least 0.99 at the lower end". The end of the interval counts (lower for what must be large, upper for what must
 *  be small), or the measured value for NAME.value. What was not measured is missed. */
std::vector<std::string> missedRequirements(const std::vector<Requirement>& requirements, const Results& results);
}  // namespace explore::evaluation

// Why one observation cannot become a depth frame, while the rest of the log can.
#pragma once

#include <stdexcept>
#include <string>

namespace explore
{
struct UnusableFrame : std::runtime_error
{
	/** `damaged`: something is missing or wrong that should be there, as opposed to an observation without depth. */
	UnusableFrame(const std::string& what, bool damaged) : std::runtime_error(what), is_damage(damaged) {}
	bool is_damage;
};
}  // namespace explore

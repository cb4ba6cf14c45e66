// Numbers with few digits, so that thousands of them stay small.
#pragma once

#include <explore/sinks/json_values.h>

#include <cmath>

namespace explore
{
/** Rounded to so many decimals, which is as many as its text has at most. Throws as jsonNumber() does. */
inline Json shortNumber(double value, int decimals)
{
	const double scale = std::pow(10.0, decimals);
	const double rounded = std::round(value * scale) / scale;
	if (decimals == 0) return static_cast<long long>(jsonNumber(rounded).get<double>());
	return jsonNumber(rounded);
}
}  // namespace explore

// Numbers as text, the same on every machine and locale: shortest form out, the same bits back in.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace explore
{
/** The finite number that the whole of `text` spells (decimal point, optional exponent); no value for anything else. */
std::optional<double> parseNumber(std::string_view text);

/** The shortest decimal that parseNumber reads back to the same bits. `number` must be finite. */
std::string formatNumber(double number);

/** Radians from a number in degrees. Up to 15 digits it is what mrpt::DEG2RAD gives for the double, as in every MRPT
 *  program; longer ones go through extended precision, because the doubles in degrees do not reach all in radians. */
std::optional<double> parseDegrees(std::string_view text);

/** The shortest decimal in degrees that parseDegrees reads back to the same bits. `angle_rad` must be finite. */
std::string formatDegrees(double angle_rad);
}  // namespace explore

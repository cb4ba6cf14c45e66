#include <explore/config/number_text.h>
#include <mrpt/core/bits_math.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <system_error>

namespace explore
{
namespace
{
/** Decimals of up to this many digits are told apart by a double. */
constexpr int kDoubleDigits = 15;
/** Enough to write any long double, be it of 64 or 113 bits. */
constexpr int kMostDigits = 36;
constexpr long double kRadPerDeg = std::numbers::pi_v<long double> / 180;

template <class Number>
std::optional<Number> parseAll(std::string_view text)
{
	if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
	Number number{};
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
	if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
	return number;
}

template <class Number, class... Format>
std::string format(Number number, Format... how)
{
	std::array<char, 128> text{};
	const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number, how...);
	return {text.data(), end};
}

int significantDigits(std::string_view text)
{
	int digits = 0;
	for (const char c : text)
	{
		if (c == 'e' || c == 'E') break;
		const bool is_digit = c >= '0' && c <= '9';
		if (is_digit && (digits > 0 || c != '0')) ++digits;
	}
	return digits;
}
}  // namespace

std::optional<double> parseNumber(std::string_view text)
{
	return parseAll<double>(text);
}

std::string formatNumber(double number)
{
	return format(number);
}

std::optional<double> parseDegrees(std::string_view text)
{
	const auto angle_deg = parseNumber(text);
	if (!angle_deg || significantDigits(text) <= kDoubleDigits)
		return angle_deg ? std::optional(mrpt::DEG2RAD(*angle_deg)) : std::nullopt;
	const auto precise_deg = parseAll<long double>(text);
	return precise_deg ? std::optional(static_cast<double>(*precise_deg * kRadPerDeg)) : std::nullopt;
}

std::string formatDegrees(double angle_rad)
{
	const long double angle_deg = angle_rad / kRadPerDeg;
	for (int digits = 1; digits < kMostDigits; ++digits)
	{
		const std::string rounded = format(angle_deg, std::chars_format::scientific, digits - 1);
		std::string text =
		    digits <= kDoubleDigits ? format(*parseNumber(rounded)) : format(*parseAll<long double>(rounded));
		if (const auto back_rad = parseDegrees(text); back_rad && *back_rad == angle_rad) return text;
	}
	return format(angle_deg);
}
}  // namespace explore

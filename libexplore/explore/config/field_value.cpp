#include <explore/config/field_value.h>
#include <explore/config/ini_text.h>
#include <explore/config/number_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace explore
{
namespace
{
constexpr std::array<std::string_view, 4> kTrue{"true", "yes", "on", "1"};
constexpr std::array<std::string_view, 4> kFalse{"false", "no", "off", "0"};
/** What MRPT's reader replaces wherever it stands. */
constexpr std::array<std::string_view, 4> kMacros{"@define", "${", "$env{", "$eval{"};

template <class Names>
int indexOf(const Names& names, std::string_view text)
{
	const auto same = [&](const auto& name) { return sameName(name, text); };
	const auto found = std::find_if(names.begin(), names.end(), same);
	return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

bool hasComment(std::string_view text, std::string_view mark)
{
	return findComment(text, mark) != std::string_view::npos;
}

/** Says why a text that looks like a value with a comment is none. */
std::string commentHint(std::string_view text)
{
	const bool has_comment = hasComment(text, "#") || hasComment(text, ";");
	return has_comment ? " (only // may trail a value; MRPT keeps # and ; as part of it)" : "";
}

[[noreturn]] void refuse(const std::string& what, std::string_view text)
{
	throw BadValue((text.empty() ? std::string("the value is missing") : what) + commentHint(text));
}

void checkBounds(const Field& field, double number)
{
	if (number < field.bounds.min) throw BadValue("too small");
	if (number > field.bounds.max) throw BadValue("too large");
}

double parseReal(const Field& field, std::string_view text)
{
	const auto number = parseNumber(text);
	if (!number) refuse("not a number", text);
	checkBounds(field, *number);
	return field.kind == FieldKind::angle ? *parseDegrees(text) : *number;
}

int parseInteger(const Field& field, std::string_view text)
{
	const auto number = parseNumber(text);  // not as an int, for $eval{} writes 6 as 6.000000e+00
	if (!number || *number != std::floor(*number)) refuse("not a whole number", text);
	checkBounds(field, *number);
	if (std::abs(*number) > std::numeric_limits<int>::max()) throw BadValue("too large");
	return static_cast<int>(*number);
}

bool parseFlag(std::string_view text)
{
	const bool is_true = indexOf(kTrue, text) >= 0;
	if (!is_true && indexOf(kFalse, text) < 0) refuse("neither true nor false", text);
	return is_true;
}

int parseChoice(const Field& field, std::string_view text)
{
	const int index = indexOf(field.names, text);
	if (index < 0) refuse("no such choice", text);
	return index;
}

/** A reason why no ini file can hold `text`, or "". */
std::string whyNotStorable(const std::string& text)
{
	if (std::any_of(text.begin(), text.end(), isControl)) return "holds a control character";
	for (const auto macro : kMacros)
		if (text.find(macro) != std::string::npos)
			return "holds " + std::string(macro) + ", which MRPT would replace on reading";
	return "";
}

/** Texts that mean something else unless they stand between double quotes. */
bool needsQuotes(const std::string& text)
{
	if (text.empty()) return false;
	const bool blank_at_an_end = isBlank(text.front()) || isBlank(text.back());
	return blank_at_an_end || text.front() == '"' || text.back() == '\\' || hasComment(text, "//") ||
	       !commentHint(text).empty();
}

std::string formatText(const std::string& text)
{
	if (const std::string reason = whyNotStorable(text); !reason.empty()) throw BadValue(reason);
	if (!needsQuotes(text)) return text;
	if (text.find('"') != std::string::npos) throw BadValue("holds a double quote in a text that has to be quoted");
	return '"' + text + '"';
}

std::string parseText(std::string_view raw)
{
	std::string text(raw);
	if (text.starts_with('"'))
	{
		if (text.size() < 2 || text.find('"', 1) != text.size() - 1)
			throw BadValue("the closing double quote is not at the end");
		text = text.substr(1, text.size() - 2);
	}
	else if (!commentHint(text).empty())
		throw BadValue("looks like a comment" + commentHint(text) + "; put a text with # or ; between double quotes");
	formatText(text);  // refuses what could not be saved again
	return text;
}

std::string joined(const std::vector<std::string>& names)
{
	std::string list;
	for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
	return list;
}

std::string boundsText(const Field& field)
{
	const std::string range = formatNumber(field.bounds.min) + " to " + formatNumber(field.bounds.max);
	return field.unit.empty() ? range : range + " " + field.unit;
}
}  // namespace

FieldValue parseValue(const Field& field, std::string_view text)
{
	const std::string_view value = withoutRemark(text);
	switch (field.kind)
	{
		case FieldKind::real:
		case FieldKind::angle:
			return parseReal(field, value);
		case FieldKind::integer:
			return parseInteger(field, value);
		case FieldKind::flag:
			return parseFlag(value);
		case FieldKind::choice:
			return parseChoice(field, value);
		case FieldKind::text:
			return parseText(text);
	}
	throw std::logic_error("unknown kind of config field");
}

std::string formatValue(const Field& field)
{
	switch (field.kind)
	{
		case FieldKind::real:
			return formatNumber(std::get<double>(field.value));
		case FieldKind::angle:
			return formatDegrees(std::get<double>(field.value));
		case FieldKind::integer:
			return std::to_string(std::get<int>(field.value));
		case FieldKind::flag:
			return std::get<bool>(field.value) ? "true" : "false";
		case FieldKind::choice:
			return field.names.at(static_cast<std::size_t>(std::get<int>(field.value)));
		case FieldKind::text:
			return formatText(std::get<std::string>(field.value));
	}
	throw std::logic_error("unknown kind of config field");
}

std::string acceptedValues(const Field& field)
{
	switch (field.kind)
	{
		case FieldKind::real:
		case FieldKind::angle:
			return "a number from " + boundsText(field);
		case FieldKind::integer:
			return "a whole number from " + boundsText(field);
		case FieldKind::flag:
			return "true or false";
		case FieldKind::choice:
			return "one of " + joined(field.names);
		case FieldKind::text:
			return "a text";
	}
	throw std::logic_error("unknown kind of config field");
}
}  // namespace explore

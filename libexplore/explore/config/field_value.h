// From the text of one ini value to the value of its field and back, with the reasons why a text is refused.
#pragma once

#include <explore/config/field_list.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace explore
{
/** Why a text is no value of a field; the message says it without naming file or key. */
struct BadValue : std::invalid_argument
{
	using std::invalid_argument::invalid_argument;
};

/** The value that `text` (trimmed, comments removed) spells. Throws BadValue for a wrong type or out of bounds. */
FieldValue parseValue(const Field& field, std::string_view text);

/** The text that parseValue reads back to field.value, bit for bit. Throws BadValue for a text that no ini can hold. */
std::string formatValue(const Field& field);

/** What parseValue accepts, as "a number from 0.05 to 2 m". */
std::string acceptedValues(const Field& field);
}  // namespace explore

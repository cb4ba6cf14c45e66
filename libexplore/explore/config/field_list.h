// The fields behind a describe() as plain data: what loading, dumping and the reference have in common.
#pragma once

#include <explore/config/ini.h>

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace explore
{
enum class FieldKind
{
	real,
	angle,
	integer,
	flag,
	text,
	choice
};

/** real: the number; angle: radians; integer; choice: place in the list of names; flag; text. */
using FieldValue = std::variant<double, int, bool, std::string>;

struct Field
{
	FieldKind kind = FieldKind::real;
	std::string section, key;
	FieldValue value;                ///< at the time of listing
	Bounds bounds{0, 0};             ///< of numbers, in the unit of the ini
	std::string unit;                ///< of numbers; "" for a pure number
	std::vector<std::string> names;  ///< of a choice
	std::string help;
};

struct Section
{
	std::string name, help;
	std::vector<Field> fields;
};

/** All fields in the order of their description, sections in the order of their first mention. Throws std::logic_error
 *  where a description names a key twice or a field before its section. */
std::vector<Section> listSections(const DescribeFields& describe_fields);

/** The entry called `name`, letter case ignored as MRPT does; null if there is none. */
const Section* findSection(const std::vector<Section>& sections, std::string_view name);
const Field* findField(const Section& section, std::string_view key);
}  // namespace explore

// Strict ini files on top of MRPT's config format (@define, $env{}, $eval{}; `//` may trail a value).
#pragma once

#include <explore/config/fields.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace explore
{
/** Visits all fields of a config object, section by section. */
using DescribeFields = std::function<void(FieldVisitor&)>;

/** Sets the described fields from the file at `path`, then from `overrides` ("section.key=value", taken literally).
 *  Keys that are absent keep their value. Throws ConfigError, and leaves all fields as they were, for: a file that is
 *  missing, unreadable or binary, an unknown section or key, a key given twice or outside every section, a line that is
 *  neither section nor key, a value of the wrong type or out of bounds. The message has one line a problem, with file,
 *  line, section, key, value, what is accepted and the nearest valid key.
 *  Stricter than MRPT's reader: an unset $env{} variable and a trailing `# …` are refused. More lenient: macros within
 *  comments have no effect, lines may begin with //, and a text between double quotes may hold blanks, # and //. */
void loadIni(const std::filesystem::path& path, const std::vector<std::string>& overrides,
             const DescribeFields& fields);

/** As loadIni, from text; `name` stands for the file in messages. */
void loadIniText(const std::string& name, const std::string& text, const std::vector<std::string>& overrides,
                 const DescribeFields& fields);

/** The complete commented ini with the present values; loads back to the same values, bit for bit. Throws ConfigError
 *  for a text that no ini can hold (line breaks, ${}). */
std::string dumpIni(const DescribeFields& fields);

/** The reference of all sections and keys as Markdown: key, default, unit, bounds, meaning. */
std::string iniReference(const DescribeFields& fields);

/** Finds `name` as a path, then in each of `folders`. Throws ConfigError that lists every place tried. */
std::filesystem::path findIni(const std::string& name, const std::vector<std::filesystem::path>& folders);
}  // namespace explore

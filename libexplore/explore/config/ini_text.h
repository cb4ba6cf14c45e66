// The smallest pieces of MRPT's ini syntax: blanks, comments, names; and how a text is shown in a message.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace explore
{
/** Space and tab. */
bool isBlank(char c);

/** Characters that no text file holds within a line. */
bool isControl(unsigned char c);

/** `text` without blanks at both ends. */
std::string_view trimmed(std::string_view text);

/** Whether MRPT takes both for the same section or key: it ignores letter case. */
bool sameName(std::string_view a, std::string_view b);

/** Where `mark` first stands so that it can begin a comment: at `start`, or later after a blank; npos if nowhere. */
std::size_t findComment(std::string_view text, std::string_view mark, std::size_t start = 0);

/** A value that is no text without the comment behind it. MRPT's programs read `0// metres` as 0, so // needs no blank
 *  in front of it here. */
std::string_view withoutRemark(std::string_view value);

/** "file:line: ", as messages begin. */
std::string placeOf(const std::string& file, int line);

/** `text` for a message: cut where it is long, control characters replaced by a dot. */
std::string shown(std::string_view text);
std::string inQuotes(std::string_view text);
}  // namespace explore

// What a page of the documentation tells its reader to type, in the page's order.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace explore::test
{
/** A line to type, or a file that the page shows: "`NAME`:" and a block of another language than the shell's. */
struct PageStep
{
	std::string page;  ///< relative to the project's folder
	int line = 0;      ///< of the page, from 1
	std::string text;  ///< the command on one line, or the file's content
	std::string file;  ///< the file's name; empty: a command
};

/** README.md, rawlogs/README.md and doc/\*.md, by name. */
std::vector<std::string> documentPages();

/** Commands and files of a page. A line of a block (indented by four, or fenced as sh or nothing) is a command when it
 * begins with a program of the project or a path of its scripts, or has an option. */
std::vector<PageStep> stepsOf(const std::string& page);

/** Not to be typed as it stands: with [optional parts], alternatives or "…...". */
bool isSynopsis(const std::string& command);

/** The "--options" in a command or help text, without their values. */
std::vector<std::string> longOptionsIn(const std::string& text);
}  // namespace explore::test

// The text of an ini file as lines that hold no comment and no @define, ${}, $env{} or $eval{} any more.
#pragma once

#include <string>
#include <vector>

namespace explore
{
/** Something wrong with one line of a file, counted from 1. */
struct IniProblem
{
	int line = 0;
	std::string what;
};

struct IniLines
{
	/** One a line of the file, so that line numbers stay true; lines continued by a backslash are joined into the first
	 *  and leave empty ones behind. */
	std::vector<std::string> lines;
	std::vector<IniProblem> problems;
};

/** Resolves `text` as mrpt::config::config_parser does, but with comments taken out before, so that a macro or a
 *  backslash in a comment has no effect. Throws ConfigError (`name` stands for the file) where the text is binary or a
 *  macro cannot be resolved. */
IniLines resolveIni(const std::string& name, const std::string& text);
}  // namespace explore

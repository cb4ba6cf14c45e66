// An ini file as the list of its sections and entries with their line numbers, before anybody asks what they mean.
#pragma once

#include <explore/config/ini_lines.h>

#include <string>
#include <vector>

namespace explore
{
struct IniEntry
{
	std::string section;  ///< "" in front of the first section
	std::string key, value;
	int line = 0;  ///< counted from 1
};

struct IniHeader
{
	std::string name;
	int line = 0;
};

struct IniDocument
{
	std::vector<IniHeader> sections;
	std::vector<IniEntry> entries;
	std::vector<IniProblem> problems;  ///< lines that MRPT would skip without a word, in their order
};

/** Reads MRPT's ini format. Throws ConfigError as resolveIni does. */
IniDocument parseIni(const std::string& name, const std::string& text);
}  // namespace explore

#include <explore/config/ini_lines.h>
#include <explore/config/ini_text.h>
#include <explore/core/errors.h>
#include <mrpt/config/config_parser.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>

namespace explore
{
namespace
{
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kDefine = "@define";
constexpr std::string_view kEnv = "$env{";

/** Splits at LF, CR LF and CR, each of which ends a line for MRPT. */
std::vector<std::string> splitLines(std::string_view text)
{
	std::vector<std::string> lines;
	while (!text.empty())
	{
		const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
		lines.emplace_back(text.substr(0, end));
		const bool is_crlf = text.substr(end).starts_with("\r\n");
		text.remove_prefix(std::min(end + (is_crlf ? 2 : 1), text.size()));
	}
	return lines;
}

void requireText(const std::string& name, const std::vector<std::string>& lines)
{
	for (std::size_t i = 0; i < lines.size(); ++i)
	{
		const auto control = std::find_if(lines[i].begin(), lines[i].end(), isControl);
		if (control == lines[i].end()) continue;
		throw ConfigError(placeOf(name, static_cast<int>(i) + 1) + "holds the byte " +
		                  std::to_string(static_cast<int>(*control)) +
		                  ", so this is not an ini file; plain text (ASCII or UTF-8) is expected");
	}
}

bool isCommentLine(std::string_view line)
{
	const auto text = trimmed(line);
	return text.starts_with('#') || text.starts_with(';') || text.starts_with("//");
}

/** The first place where // may begin a comment: behind a value in double quotes, where there is one. */
std::size_t commentSearchStart(std::string_view line)
{
	const std::size_t equals = line.find('=');
	if (equals == std::string_view::npos) return 0;
	const std::size_t value = line.find_first_not_of(" \t", equals + 1);
	if (value == std::string_view::npos || line[value] != '"') return equals + 1;
	const std::size_t closing = line.find('"', value + 1);
	return closing == std::string_view::npos ? value : closing + 1;
}

std::string_view withoutComment(std::string_view line)
{
	if (isCommentLine(line)) return {};
	return line.substr(0, findComment(line, "//", commentSearchStart(line)));
}

std::vector<std::string> joinContinued(const std::vector<std::string>& raw)
{
	std::vector<std::string> lines(raw.size());
	for (std::size_t i = 0; i < raw.size(); ++i)
	{
		std::string& line = lines[i];
		line = withoutComment(raw[i]);
		while (line.ends_with('\\'))
		{
			line.pop_back();
			if (i + 1 == raw.size()) break;
			line += withoutComment(raw[++i]);
		}
	}
	return lines;
}

/** config_parser drops what follows @define wherever it stands. */
void checkDefine(const std::string& line, int number, std::vector<IniProblem>& problems)
{
	const std::size_t define = trimmed(line).find(kDefine);
	if (define != std::string::npos && define > 0) problems.push_back({number, "@define must begin its line"});
}

/** An unset variable becomes an empty text for MRPT, and one that holds macros can keep it busy for ever. */
void checkEnvironment(const std::string& name, const std::string& line, int number, std::vector<IniProblem>& problems)
{
	for (std::size_t start = line.find(kEnv); start != std::string::npos; start = line.find(kEnv, start + 1))
	{
		const std::size_t begin = start + kEnv.size();
		const std::string variable = line.substr(begin, std::min(line.find('}', begin), line.size()) - begin);
		const char* const value = std::getenv(variable.c_str());
		const std::string_view content = value == nullptr ? "" : value;
		const bool usable = content.find_first_of("${}") == std::string_view::npos &&
		                    std::none_of(content.begin(), content.end(), isControl);
		if (value == nullptr)
			problems.push_back({number, "the environment variable " + inQuotes(variable) + " is not set"});
		else if (!usable)
			throw ConfigError(placeOf(name, number) + "the environment variable " + inQuotes(variable) + " holds " +
			                  inQuotes(content) + "; a text without $, {, } and control characters is expected");
	}
}

void eraseFirst(std::string& text, const std::string& part)
{
	if (const std::size_t start = text.find(part); start != std::string::npos) text.erase(start, part.size());
}

/** MRPT's message without its call stack; its "Line 3: " is turned into the place. */
std::string explain(const std::string& name, const std::string& message)
{
	constexpr std::string_view kMessage = "Message:";
	constexpr std::string_view kLine = "Line ";
	constexpr std::size_t kMost = 300;
	const std::size_t frame = message.find(kMessage);
	const std::size_t start = frame == std::string::npos ? 0 : frame + kMessage.size();
	std::string reason = message.substr(start, message.find('\n', start) - start);

	std::string place = name;
	if (const std::size_t label_start = reason.find(kLine); label_start != std::string::npos)
	{
		const std::size_t digits = label_start + kLine.size();
		const std::string number = reason.substr(digits, reason.find_first_not_of("0123456789", digits) - digits);
		const std::string label = std::string(kLine) + number + ": ";
		eraseFirst(reason, " (name=`" + label + "`)");
		eraseFirst(reason, label);
		place += ":" + number;
	}
	return place + ": " + std::string(trimmed(reason)).substr(0, kMost);
}

std::string runConfigParser(const std::string& name, const std::vector<std::string>& lines)
{
	std::string text;
	for (const auto& line : lines) text += line + '\n';
	try
	{
		return mrpt::config::config_parser(text);
	}
	catch (const std::exception& error)
	{
		throw ConfigError(explain(name, error.what()));
	}
}
}  // namespace

IniLines resolveIni(const std::string& name, const std::string& text)
{
	std::string_view content = text;
	if (content.starts_with(kByteOrderMark)) content.remove_prefix(kByteOrderMark.size());
	const auto raw = splitLines(content);
	requireText(name, raw);

	IniLines result;
	const auto lines = joinContinued(raw);
	for (std::size_t i = 0; i < lines.size(); ++i)
	{
		const int number = static_cast<int>(i) + 1;
		checkDefine(lines[i], number, result.problems);
		checkEnvironment(name, lines[i], number, result.problems);
	}
	result.lines = splitLines(runConfigParser(name, lines));
	return result;
}
}  // namespace explore

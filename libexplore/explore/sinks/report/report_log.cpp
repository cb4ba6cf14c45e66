#include <explore/core/errors.h>
#include <explore/sinks/output_folder.h>
#include <explore/sinks/report/report_log.h>

#include <charconv>
#include <fstream>

namespace explore
{
namespace
{
const std::filesystem::path& inFolder(const std::filesystem::path& path)
{
	makeFolder(path.parent_path());
	return path;
}

std::optional<ReportEntry> entryOf(std::string_view line)
{
	if (line.size() < 4 || line[1] != ' ') return std::nullopt;
	ReportEntry entry;
	entry.kind = static_cast<ReportLine>(line[0]);
	const char* const end = line.data() + line.size();
	const auto [after, error] = std::from_chars(line.data() + 2, end, entry.frame);
	if (error != std::errc() || after == end || *after != ' ') return std::nullopt;
	entry.text = {after + 1, end};
	return entry;
}
}  // namespace

ReportLog::ReportLog(const std::filesystem::path& path) : m_path(path), m_file(inFolder(path)) {}

ReportLog::ReportLog(const std::filesystem::path& path, std::uintmax_t bytes)
    : m_path(path), m_file(OutputFile::continued(path, bytes))
{
}

void ReportLog::write(std::initializer_list<ReportEntry> entries)
{
	std::string lines;
	for (const ReportEntry& entry : entries)
	{
		if (entry.text.empty()) continue;
		lines += static_cast<char>(entry.kind);
		lines.append(" ").append(std::to_string(entry.frame)).append(" ").append(entry.text).append("\n");
	}
	if (!lines.empty()) m_file.write(lines);
}

void ReportLog::read(const std::function<void(const ReportEntry&)>& take) const
{
	std::ifstream file(m_path, std::ios::binary);
	std::uintmax_t left = bytes();
	std::string why;
	try
	{
		for (std::string line; left > 0 && std::getline(file, line);)
		{
			const auto entry = entryOf(line);
			if (!entry || line.size() + 1 > left) break;
			take(*entry);
			left -= line.size() + 1;
		}
	}
	catch (const std::exception& error)  // of those who read the entries: JSON, plans
	{
		why = std::string(": ") + error.what();
	}
	if (left > 0) throw OutputError(m_path.string() + ": is not what was written to it" + why);
}
}  // namespace explore

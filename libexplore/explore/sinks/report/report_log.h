// state/report: what report.html is made of in the end, written frame by frame so that it never piles up in memory.
#pragma once

#include <explore/sinks/output_file.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace explore
{
/** What a line of the log is about. */
enum class ReportLine : char
{
	beginning = 'b',
	pose = 'p',
	goal = 'g',
	camera = 'c',
	plan = 'm'
};

/** One line: its kind, its frame and a text without line breaks. */
struct ReportEntry
{
	ReportLine kind = ReportLine::pose;
	std::size_t frame = 0;
	std::string_view text;
};

/** A file of such lines that only grows. */
class ReportLog
{
public:
	/** Creates the file, and its folder where it is missing. Throws OutputError. */
	explicit ReportLog(const std::filesystem::path& path);
	/** Goes on after the first `bytes` of one that is there; throws as OutputFile::continued() does. */
	ReportLog(const std::filesystem::path& path, std::uintmax_t bytes);

	/** All entries of one frame at once: none is ever cut. Throws OutputError. */
	void write(std::initializer_list<ReportEntry> entries);
	[[nodiscard]] std::uintmax_t bytes() const { return m_file.bytes(); }
	[[nodiscard]] const std::filesystem::path& path() const { return m_path; }
	/** Gives every entry so far, in order, to `take`. Throws OutputError where the file is not what was written,
	 *  or where `take` throws. */
	void read(const std::function<void(const ReportEntry&)>& take) const;

private:
	std::filesystem::path m_path;
	OutputFile m_file;
};
}  // namespace explore

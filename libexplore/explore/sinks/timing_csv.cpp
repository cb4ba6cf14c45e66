#include <explore/sinks/timing_csv.h>
#include <mrpt/core/format.h>

#include <utility>

namespace explore
{
TimingCsv::TimingCsv(const std::filesystem::path& path, std::vector<std::string> stages)
    : m_file(path), m_columns(std::move(stages))
{
	m_columns.emplace_back(kTotalStage);
	std::string header = "frame";
	for (const auto& column : m_columns) header += ',' + column;
	m_file.write(header + '\n');
}

TimingCsv::TimingCsv(const std::filesystem::path& path, std::vector<std::string> stages, std::uintmax_t bytes)
    : m_file(OutputFile::continued(path, bytes)), m_columns(std::move(stages))
{
	m_columns.emplace_back(kTotalStage);
}

void TimingCsv::write(std::size_t frame, const StageTimes& times_ms)
{
	std::string row = std::to_string(frame);
	for (const auto& column : m_columns)
	{
		const auto found = times_ms.find(column);
		row += mrpt::format(",%.3f", found == times_ms.end() ? 0.0 : found->second);
	}
	m_file.write(row + '\n');
}
}  // namespace explore

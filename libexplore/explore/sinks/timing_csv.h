// timing.csv: milliseconds per stage and frame.
#pragma once

#include <explore/sinks/output_file.h>
#include <explore/sinks/stage_clock.h>

#include <string>
#include <vector>

namespace explore
{
/** One row a frame: frame, then one column a stage, then the total. */
class TimingCsv
{
public:
	/** `stages` are the columns between `frame` and `total`, in order. Throws OutputError. */
	TimingCsv(const std::filesystem::path& path, std::vector<std::string> stages);

	/** Goes on in a file that an earlier run left, after its first `bytes`; throws as OutputFile::continued() does. */
	TimingCsv(const std::filesystem::path& path, std::vector<std::string> stages, std::uintmax_t bytes);

	/** A stage that did not run in this frame has 0. Throws OutputError. */
	void write(std::size_t frame, const StageTimes& times_ms);
	[[nodiscard]] std::uintmax_t bytes() const { return m_file.bytes(); }
	void close() { m_file.close(); }

private:
	OutputFile m_file;
	std::vector<std::string> m_columns;
};
}  // namespace explore

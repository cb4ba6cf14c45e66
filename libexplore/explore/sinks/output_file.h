// Files whose every write is checked, so that a full disk or a closed pipe never passes silently.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace explore
{
/** A text file opened for writing. Every failure throws OutputError with the file's name and the system's reason. */
class OutputFile
{
public:
	/** Creates the file, or empties it. */
	explicit OutputFile(const std::filesystem::path& path);
	/** Standard output under the name "standard output"; it stays open. */
	static OutputFile standardOutput();

	OutputFile(OutputFile&& other) noexcept;
	OutputFile& operator=(OutputFile&& other) noexcept;
	OutputFile(const OutputFile&) = delete;
	OutputFile& operator=(const OutputFile&) = delete;
	~OutputFile();

	/** Hands all of `text` to the system before it returns: what was written survives a crash of this program. When it
	 *  fails, the file is cut back to the texts that were written whole. */
	void write(std::string_view text);
	/** Closes the file; some file systems report a failed write only here. Nothing may be written afterwards. */
	void close();

private:
	OutputFile(std::string name, int descriptor, bool owned);
	void release() noexcept;
	[[noreturn]] void failWriting(int error);

	std::string m_name;
	int m_descriptor = -1;
	bool m_owned = true;
	std::uintmax_t m_whole_bytes = 0;
};

/** Puts `text` into the file at `path` in one step: whoever opens it sees the old content or the new, never a part. */
void writeFileAtomically(const std::filesystem::path& path, std::string_view text);
}  // namespace explore

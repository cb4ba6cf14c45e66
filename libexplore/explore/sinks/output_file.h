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
	/** Goes on in a file that an earlier run left, after its first `bytes`; what comes later is cut off. Throws
	 *  InputError where the file is not there or shorter. */
	static OutputFile continued(const std::filesystem::path& path, std::uintmax_t bytes);
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
	/** Of all texts so far. */
	[[nodiscard]] std::uintmax_t bytes() const { return m_whole_bytes; }
	/** Returns when all of it is where a power cut leaves it. */
	void sync() const;
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

/** Returns when all that was written to the file is where a power cut leaves it, whoever wrote it. */
void syncFile(const std::filesystem::path& path);

/** Puts `text` into the file at `path` in one step: whoever opens it sees the old content or the new, never a part,
 * also after a power cut. */
void writeFileAtomically(const std::filesystem::path& path, std::string_view text);
}  // namespace explore

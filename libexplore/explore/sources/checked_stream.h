// Reads a plain or gzipped file and notices everything that MRPT's own streams let pass: short reads, CRC, trailing
// junk.
#pragma once

#include <mrpt/io/CStream.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

struct z_stream_s;

namespace explore
{
/** The bytes at hand are not what was written: a short read, or a compressed stream that does not check out. */
struct StreamDamage : std::runtime_error
{
	using std::runtime_error::runtime_error;
};

/** A read-only stream. Whether the file is gzipped is told by its first two bytes. */
class CheckedStream : public mrpt::io::CStream
{
public:
	/** Throws InputError with the system's reason when `path` cannot be opened or is no regular file. */
	explicit CheckedStream(const std::filesystem::path& path);
	~CheckedStream() override;
	CheckedStream(const CheckedStream&) = delete;
	CheckedStream& operator=(const CheckedStream&) = delete;

	/** All `count` bytes, or StreamDamage: never less without a word. */
	size_t Read(void* buffer, size_t count) override;
	/** True when nothing is left. Throws StreamDamage where the compressed stream ends early, fails its CRC or is
	 * followed by something else. */
	bool atEnd();
	/** The bytes that are still to be read, at most `limit`, without consuming them. Damage ends them silently. */
	std::string peek(std::size_t limit);
	/** Up to `limit` more bytes; fewer, or none, at the end or at damage, which is not reported here. */
	std::string drain(std::size_t limit);

	/** Bytes delivered so far (after decompression). */
	[[nodiscard]] uint64_t getPosition() const override { return m_position; }
	/** Bytes of the file itself that what was delivered needed, within the decompressor's look-ahead. */
	[[nodiscard]] std::uint64_t filePosition() const;
	[[nodiscard]] std::uint64_t fileSize() const { return m_file_size; }
	[[nodiscard]] bool compressed() const { return m_inflate != nullptr; }
	/** The text of the last StreamDamage, for callers whose own layers in between replace exceptions; else empty. */
	[[nodiscard]] const std::string& failure() const { return m_failure; }
	[[nodiscard]] std::string getStreamDescription() const override { return m_path.string(); }

	/** Size of the file itself, as fileSize(). */
	[[nodiscard]] uint64_t getTotalBytesCount() const override { return m_file_size; }
	/** Not supported: throws std::logic_error. */
	size_t Write(const void* buffer, size_t count) override;
	/** Not supported: throws std::logic_error. */
	uint64_t Seek(int64_t offset, TSeekOrigin origin) override;

private:
	struct FileCloser
	{
		void operator()(std::FILE* file) const { std::fclose(file); }
	};
	struct InflateEnder
	{
		void operator()(z_stream_s* stream) const;
	};

	/** Appends more bytes to m_ready; false at a clean end. */
	bool fill();
	bool fillInflated();
	std::size_t readFile();
	[[noreturn]] void fail(const std::string& what);
	void startInflate();
	void memberEnded();

	std::filesystem::path m_path;
	std::unique_ptr<std::FILE, FileCloser> m_file;
	std::unique_ptr<z_stream_s, InflateEnder> m_inflate;
	std::uint64_t m_file_size = 0, m_file_read = 0, m_position = 0;
	std::vector<unsigned char> m_raw;    ///< as read from the file
	std::vector<unsigned char> m_ready;  ///< decompressed, from m_ready_begin on not yet delivered
	std::size_t m_raw_size = 0, m_ready_begin = 0;
	bool m_ended = false;
	std::string m_failure;
};
}  // namespace explore

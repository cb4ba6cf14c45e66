#include "rawlog_writer.h"

#include <explore/core/errors.h>
#include <mrpt/serialization/CArchive.h>
#include <zlib.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace explore
{
namespace
{
/** Level 1 takes a sixth of level 6's time for a quarter more bytes. */
constexpr const char* kMode = "wb1";
}  // namespace

/** MRPT wraps what a stream throws in exceptions of its own, so failures are kept here and thrown by the writer. */
class RawlogWriter::Stream : public mrpt::io::CStream
{
public:
	explicit Stream(const std::filesystem::path& path) : m_path(path)
	{
		errno = 0;
		m_file = gzopen(path.c_str(), kMode);
		if (m_file == nullptr) fail(errno);
	}
	~Stream() override
	{
		if (m_file == nullptr) return;
		gzclose(m_file);
		removeUnfinished();
	}
	Stream(const Stream&) = delete;
	Stream& operator=(const Stream&) = delete;

	size_t Write(const void* buffer, size_t count) override
	{
		errno = 0;
		const size_t written = gzfwrite(buffer, 1, count, m_file);
		if (written != count) m_error = errno != 0 ? errno : EIO;
		m_position += written;
		return written;
	}
	void close()
	{
		errno = 0;
		const int result = gzclose(std::exchange(m_file, nullptr));
		if (result == Z_OK) return;
		const int error = errno;
		removeUnfinished();
		fail(error);
	}
	void check() const
	{
		if (m_error != 0) fail(m_error);
	}
	[[noreturn]] void fail(int error) const
	{
		throw OutputError(m_path.string() +
		                  ": cannot be written: " + std::generic_category().message(error != 0 ? error : EIO));
	}

	size_t Read(void*, size_t) override { throw std::logic_error("a rawlog writer does not read"); }
	uint64_t Seek(int64_t, TSeekOrigin) override { throw std::logic_error("a rawlog writer does not seek"); }
	[[nodiscard]] uint64_t getTotalBytesCount() const override { return m_position; }
	[[nodiscard]] uint64_t getPosition() const override { return m_position; }

private:
	void removeUnfinished() const
	{
		std::error_code ignored;
		if (std::filesystem::is_regular_file(m_path, ignored)) std::filesystem::remove(m_path, ignored);
	}

	std::filesystem::path m_path;
	gzFile m_file = nullptr;
	int m_error = 0;
	uint64_t m_position = 0;
};

void RawlogWriter::StreamDeleter::operator()(Stream* stream) const
{
	delete stream;
}

RawlogWriter::RawlogWriter(const std::filesystem::path& path) : m_stream(new Stream(path)) {}

void RawlogWriter::write(const mrpt::serialization::CSerializable& object)
{
	try
	{
		mrpt::serialization::archiveFrom<mrpt::io::CStream>(*m_stream).WriteObject(object);
	}
	catch (const std::exception&)
	{
		m_stream->check();
		throw;
	}
	m_stream->check();
}

void RawlogWriter::close()
{
	m_stream->close();
}
}  // namespace explore

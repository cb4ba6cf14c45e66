#include "checked_stream.h"

#include <explore/core/errors.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace explore
{
namespace
{
constexpr std::size_t kRawBytes = 64 * 1024;
constexpr std::size_t kInflatedBytes = 256 * 1024;
constexpr int kGzipOnly = 15 + 16;  // zlib's largest window, gzip header and CRC expected

std::string reasonOf(int error)
{
	return std::generic_category().message(error);
}

std::uint64_t regularFileSize(const std::filesystem::path& path)
{
	std::error_code error;
	const auto status = std::filesystem::status(path, error);
	if (!std::filesystem::exists(status))
		throw InputError(path.string() + ": " + reasonOf(error ? error.value() : ENOENT) + "; a file is needed");
	if (std::filesystem::is_directory(status))
		throw InputError(path.string() + ": " + reasonOf(EISDIR) + "; a file is needed");
	const std::uintmax_t size = std::filesystem::file_size(path, error);
	if (error) throw InputError(path.string() + ": " + error.message() + "; a regular file is needed");
	return size;
}
}  // namespace

void CheckedStream::InflateEnder::operator()(z_stream_s* stream) const
{
	inflateEnd(stream);
	delete stream;
}

CheckedStream::CheckedStream(const std::filesystem::path& path) : m_path(path), m_file_size(regularFileSize(path))
{
	m_file.reset(std::fopen(path.c_str(), "rb"));
	if (!m_file) throw InputError(path.string() + ": " + reasonOf(errno) + "; a readable file is needed");
	m_raw.resize(kRawBytes);
	readFile();
	if (m_raw_size >= 2 && m_raw[0] == 0x1f && m_raw[1] == 0x8b)
		startInflate();
	else
		m_ready.assign(m_raw.begin(), m_raw.begin() + static_cast<std::ptrdiff_t>(m_raw_size));
}

CheckedStream::~CheckedStream() = default;

void CheckedStream::fail(const std::string& what)
{
	m_failure = what;
	throw StreamDamage(what);
}

std::size_t CheckedStream::readFile()
{
	m_raw_size = std::fread(m_raw.data(), 1, m_raw.size(), m_file.get());
	if (m_raw_size == 0 && std::ferror(m_file.get()) != 0)
		fail("cannot be read at file byte " + std::to_string(m_file_read) + ": " + reasonOf(errno));
	m_file_read += m_raw_size;
	return m_raw_size;
}

void CheckedStream::startInflate()
{
	auto stream = std::make_unique<z_stream>();
	if (inflateInit2(stream.get(), kGzipOnly) != Z_OK) throw std::bad_alloc();
	m_inflate.reset(stream.release());
	m_inflate->next_in = m_raw.data();
	m_inflate->avail_in = static_cast<uInt>(m_raw_size);
}

std::uint64_t CheckedStream::filePosition() const
{
	return m_inflate ? m_file_read - m_inflate->avail_in : m_position;
}

void CheckedStream::memberEnded()
{
	if (m_inflate->avail_in == 0)
	{
		m_inflate->avail_in = static_cast<uInt>(readFile());
		m_inflate->next_in = m_raw.data();
	}
	m_ended = m_inflate->avail_in == 0;
	// A gzip file may hold several members one after the other; anything else behind the last one is damage, which the
	// header check of the next inflate() call reports.
	if (!m_ended) inflateReset(m_inflate.get());
}

bool CheckedStream::fillInflated()
{
	if (m_ended) return false;
	if (m_inflate->avail_in == 0)
	{
		m_inflate->avail_in = static_cast<uInt>(readFile());
		m_inflate->next_in = m_raw.data();
		if (m_inflate->avail_in == 0)
			fail("the compressed stream ends early, at file byte " + std::to_string(m_file_read));
	}
	const std::size_t before = m_ready.size();
	m_ready.resize(before + kInflatedBytes);
	m_inflate->next_out = m_ready.data() + before;
	m_inflate->avail_out = kInflatedBytes;
	const int result = inflate(m_inflate.get(), Z_NO_FLUSH);
	m_ready.resize(m_ready.size() - m_inflate->avail_out);
	if (result == Z_STREAM_END)
		memberEnded();
	else if (result != Z_OK && result != Z_BUF_ERROR && m_ready.size() == before)
		fail("the compressed stream is damaged before file byte " + std::to_string(filePosition()) + ": " +
		     (m_inflate->msg != nullptr ? m_inflate->msg : "zlib error " + std::to_string(result)));
	// What was decompressed before an error is delivered first; zlib repeats the error with the next call.
	return true;
}

bool CheckedStream::fill()
{
	m_ready.erase(m_ready.begin(), m_ready.begin() + static_cast<std::ptrdiff_t>(m_ready_begin));
	m_ready_begin = 0;
	if (m_inflate) return fillInflated();
	if (readFile() == 0) return false;
	m_ready.insert(m_ready.end(), m_raw.begin(), m_raw.begin() + static_cast<std::ptrdiff_t>(m_raw_size));
	return true;
}

size_t CheckedStream::Read(void* buffer, size_t count)
{
	auto* to = static_cast<unsigned char*>(buffer);
	for (std::size_t done = 0; done < count;)
	{
		const std::size_t n = std::min(count - done, m_ready.size() - m_ready_begin);
		if (n > 0) std::memcpy(to + done, m_ready.data() + m_ready_begin, n);
		done += n;
		m_ready_begin += n;
		m_position += n;
		if (done < count && !fill())
			fail("ends " + std::to_string(count - done) + " bytes early, at byte " + std::to_string(m_position));
	}
	return count;
}

bool CheckedStream::atEnd()
{
	while (m_ready_begin == m_ready.size())
		if (!fill()) return true;
	return false;
}

std::string CheckedStream::peek(std::size_t limit)
{
	try
	{
		while (m_ready.size() - m_ready_begin < limit && fill())
		{
		}
	}
	catch (const StreamDamage&)
	{
		// What could be decompressed is still there to look at; reading on reports the damage.
	}
	const std::size_t n = std::min(limit, m_ready.size() - m_ready_begin);
	return {m_ready.begin() + static_cast<std::ptrdiff_t>(m_ready_begin),
	        m_ready.begin() + static_cast<std::ptrdiff_t>(m_ready_begin + n)};
}

std::string CheckedStream::drain(std::size_t limit)
{
	std::string bytes = peek(limit);
	m_ready_begin += bytes.size();
	m_position += bytes.size();
	return bytes;
}

size_t CheckedStream::Write(const void*, size_t)
{
	throw std::logic_error("CheckedStream is read-only");
}
uint64_t CheckedStream::Seek(int64_t, TSeekOrigin)
{
	throw std::logic_error("CheckedStream cannot seek");
}
}  // namespace explore

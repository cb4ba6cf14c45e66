#include <explore/core/errors.h>
#include <explore/sinks/output_file.h>
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace explore
{
namespace
{
[[noreturn]] void fail(const std::string& name, const char* action, int error)
{
	throw OutputError(name + ": cannot " + action + ": " + std::system_category().message(error));
}

int openForWriting(const std::filesystem::path& path)
{
	constexpr mode_t kReadableByAll = 0644;
	// NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the system's own interface
	const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kReadableByAll);
	if (descriptor < 0) fail(path.string(), "open for writing", errno);
	return descriptor;
}
}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path) : OutputFile(path.string(), openForWriting(path), true) {}

OutputFile::OutputFile(std::string name, int descriptor, bool owned)
    : m_name(std::move(name)), m_descriptor(descriptor), m_owned(owned)
{
}

OutputFile OutputFile::continued(const std::filesystem::path& path, std::uintmax_t bytes)
{
	// NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the system's own interface
	const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
	if (descriptor < 0)
		throw InputError(path.string() + ": cannot be continued: " + std::system_category().message(errno));
	OutputFile file(path.string(), descriptor, true);
	const off_t end = ::lseek(descriptor, 0, SEEK_END);
	if (end < 0 || static_cast<std::uintmax_t>(end) < bytes)
		throw InputError(path.string() + ": cannot be continued: at least " + std::to_string(bytes) +
		                 " bytes were there when the state of the run was kept");
	file.m_whole_bytes = bytes;
	if (::ftruncate(descriptor, static_cast<off_t>(bytes)) != 0) fail(path.string(), "cut", errno);
	if (::lseek(descriptor, 0, SEEK_END) < 0) fail(path.string(), "continue", errno);
	return file;
}

OutputFile OutputFile::standardOutput()
{
	return {"standard output", STDOUT_FILENO, false};
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : m_name(std::move(other.m_name)),
      m_descriptor(std::exchange(other.m_descriptor, -1)),
      m_owned(other.m_owned),
      m_whole_bytes(other.m_whole_bytes)
{
}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept
{
	if (this == &other) return *this;
	release();
	m_name = std::move(other.m_name);
	m_descriptor = std::exchange(other.m_descriptor, -1);
	m_owned = other.m_owned;
	m_whole_bytes = other.m_whole_bytes;
	return *this;
}

OutputFile::~OutputFile()
{
	release();
}

void OutputFile::release() noexcept
{
	if (m_owned && m_descriptor >= 0) ::close(m_descriptor);
	m_descriptor = -1;
}

void OutputFile::write(std::string_view text)
{
	const std::size_t size = text.size();
	while (!text.empty())
	{
		const ssize_t written = ::write(m_descriptor, text.data(), text.size());
		if (written < 0 && errno == EINTR) continue;
		if (written < 0) failWriting(errno);
		text.remove_prefix(static_cast<std::size_t>(written));
	}
	m_whole_bytes += size;
}

void OutputFile::failWriting(int error)
{
	// What cannot be cut (a device, a pipe) stays as it is; the message is about the first error anyhow.
	if (m_owned) [[maybe_unused]]
		const int ignored = ::ftruncate(m_descriptor, static_cast<off_t>(m_whole_bytes));
	fail(m_name, "write", error);
}

void OutputFile::sync() const
{
	if (::fsync(m_descriptor) != 0) fail(m_name, "write", errno);
}

void OutputFile::close()
{
	const int descriptor = std::exchange(m_descriptor, -1);
	if (m_owned && descriptor >= 0 && ::close(descriptor) != 0) fail(m_name, "close", errno);
}

void syncFile(const std::filesystem::path& path)
{
	// NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the system's own interface
	const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
	if (descriptor < 0) fail(path.string(), "open", errno);
	const int error = ::fsync(descriptor) == 0 ? 0 : errno;
	::close(descriptor);
	if (error != 0) fail(path.string(), "write", error);
}

void writeFileAtomically(const std::filesystem::path& path, std::string_view text)
{
	std::filesystem::path unfinished = path;
	unfinished += ".part";
	std::error_code error;
	try
	{
		OutputFile file(unfinished);
		file.write(text);
		file.sync();
		file.close();
	}
	catch (const OutputError&)
	{
		std::filesystem::remove(unfinished, error);
		throw;
	}
	std::filesystem::rename(unfinished, path, error);
	if (error) fail(path.string(), "put into place", error.value());
}
}  // namespace explore

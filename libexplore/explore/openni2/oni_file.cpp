#include <explore/core/errors.h>
#include <explore/openni2/oni_file.h>

#include <fstream>

namespace explore::openni2
{
namespace
{
/** A frame of a recording is a matter of milliseconds: after that long it will not come. */
constexpr std::chrono::seconds kPatience{10};

void demandReadable(const std::filesystem::path& path)
{
	std::error_code error;
	if (!std::filesystem::exists(path, error)) throw InputError(path.string() + ": no such recording");
	if (!std::filesystem::is_regular_file(path, error)) throw InputError(path.string() + ": is no file");
	std::ifstream file(path, std::ios::binary);
	std::string magic(4, '\0');
	if (!file) throw InputError(path.string() + ": cannot be read");
	if (!file.read(magic.data(), 4) || magic != "NI10")
		throw InputError(path.string() + ": is no recording of OpenNI2: byte 0 does not begin with \"NI10\"");
}
}  // namespace

OniFile::OniFile(const std::filesystem::path& path, const Openni2Config& config)
{
	demandReadable(path);
	try
	{
		m_stream = std::make_unique<DepthStream>(std::filesystem::absolute(path).string(),
		                                         DepthStream::Origin::recording, config);
	}
	catch (const SensorLost& error)
	{
		throw InputError(path.string() + ": cannot be played; it may be cut off or damaged: " + error.what());
	}
	m_count = m_stream->frameCount();
	if (m_count < 1) throw InputError(path.string() + ": holds no depth frame");
}

std::optional<RawDepth> OniFile::next()
{
	if (m_read >= m_count || !m_damage.empty()) return std::nullopt;
	std::optional<RawDepth> frame;
	try
	{
		frame = m_stream->read(kPatience);
	}
	catch (const BadFrame&)
	{
		++m_read;
		throw;
	}
	const int number = m_stream->frameNumber();
	// The recording is played in a loop: a number that falls back means that it ended early.
	if (!frame || number <= m_last_number)
	{
		m_damage = "ends after frame " + std::to_string(m_read) + " of " + std::to_string(m_count);
		return std::nullopt;
	}
	m_last_number = number;
	++m_read;
	return frame;
}
}  // namespace explore::openni2

#include <dlfcn.h>
#include <explore/core/errors.h>
#include <explore/openni2/oni_file.h>
#include <explore/openni2/oni_structure.h>

#include <algorithm>

namespace explore::openni2
{
namespace
{
/** A frame of a recording is a matter of milliseconds: after that long it will not come. */
constexpr std::chrono::seconds kPatience{10};

/** The player's thread may still be on its way out when its driver is unloaded: the driver stays in memory. */
void keepDriverLoaded()
{
	::dlopen("libOniFile.so.0", RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE);  // a driver of another name is left alone
}
}  // namespace

OniFile::OniFile(const std::filesystem::path& path, const Openni2Config& config)
{
	keepDriverLoaded();
	const OniStructure structure = checkStructure(path);
	try
	{
		m_stream = std::make_unique<DepthStream>(std::filesystem::absolute(path).string(),
		                                         DepthStream::Origin::recording, config);
	}
	catch (const SensorLost& error)
	{
		throw InputError(path.string() + ": " + (structure.damage.empty() ? "" : structure.damage + "; ") +
		                 "OpenNI2 cannot play it: " + error.what());
	}
	m_count = m_stream->frameCount();
	if (!structure.damage.empty())
	{
		m_whole = std::min(m_count, structure.depth_frames);
		m_file_damage = structure.damage;
	}
	else
		m_whole = m_count;
	if (m_whole < 1)
		throw InputError(path.string() + ": " + (structure.damage.empty() ? "" : structure.damage + "; ") +
		                 "holds no depth frame");
}

std::optional<RawDepth> OniFile::next()
{
	if (m_read >= m_whole && m_damage.empty()) m_damage = m_file_damage;
	if (m_read >= m_whole || !m_damage.empty()) return std::nullopt;
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

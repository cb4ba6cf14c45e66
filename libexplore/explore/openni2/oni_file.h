// An OpenNI2 recording, read to its end.
#pragma once

#include <explore/openni2/depth_stream.h>

#include <filesystem>
#include <string>

namespace explore::openni2
{
class OniFile
{
public:
	/** Throws InputError that names the file. */
	OniFile(const std::filesystem::path& path, const Openni2Config& config);

	/** Each depth frame in its order; no value at the end, also after damage(). Throws BadFrame for one that cannot be
	 *  used; the next call goes on. */
	std::optional<RawDepth> next();
	/** Empty = intact so far; else what and where. */
	[[nodiscard]] const std::string& damage() const { return m_damage; }
	/** Frames that the recording says it has, and how many of them were read. */
	[[nodiscard]] int frameCount() const { return m_count; }
	[[nodiscard]] int framesRead() const { return m_read; }

private:
	Library m_library;
	std::unique_ptr<DepthStream> m_stream;
	int m_count = 0, m_whole = 0, m_read = 0, m_last_number = -1;
	std::string m_file_damage, m_damage;  ///< seen at once; met so far
};
}  // namespace explore::openni2

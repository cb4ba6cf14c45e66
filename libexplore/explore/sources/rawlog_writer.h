// Writes a gzipped rawlog and notices when the disk does not take it.
#pragma once

#include <mrpt/io/CStream.h>
#include <mrpt/serialization/CSerializable.h>

#include <filesystem>
#include <memory>
#include <string>

namespace explore
{
/** The same objects give the same bytes: nothing of the clock or the file's name is written. */
class RawlogWriter
{
public:
	/** Throws OutputError with the system's reason when the file cannot be made. */
	explicit RawlogWriter(const std::filesystem::path& path);

	/** Throws OutputError when the bytes do not reach the file. */
	void write(const mrpt::serialization::CSerializable& object);
	/** Flushes and closes. A regular file that was not closed so is removed: it would pass for a complete shorter one.
	 *  Throws OutputError. */
	void close();

private:
	class Stream;
	struct StreamDeleter
	{
		void operator()(Stream* stream) const;
	};
	std::unique_ptr<Stream, StreamDeleter> m_stream;
};
}  // namespace explore

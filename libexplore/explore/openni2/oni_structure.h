// How far an .oni file is whole: OpenNI2's player does not tell.
#pragma once

#include <filesystem>
#include <string>

namespace explore::openni2
{
struct OniStructure
{
	int depth_frames = 0;  ///< that are there whole
	std::string damage;    ///< empty = whole to its end; else what and at which byte
};

/** Follows the records of the file from the first to the one that ends it, without looking into the images. Throws
 *  InputError for what cannot be read or is no recording. */
OniStructure checkStructure(const std::filesystem::path& path);
}  // namespace explore::openni2

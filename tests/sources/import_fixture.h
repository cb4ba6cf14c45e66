// Depth images as files, and their way into a rawlog.
#pragma once

#include <explore/sources/import_recording.h>

#include <string>

#include "rawlog_fixture.h"

namespace explore::test
{
/** A 16-bit greyscale PNG written after the PNG specification, without the library that reads it. */
void writePng(const std::filesystem::path& path, const DepthImage& image, double counts_per_m);

/** The intrinsics of `image`, and its scale. */
ImportConfig importConfigOf(const DepthImage& image, double counts_per_m);

void importTo(const std::filesystem::path& log, const Recording& recording, const ImportConfig& config);

/** What `action` throws as an Error. */
template <class Error, class Action>
std::string messageOf(const Action& action)
{
	try
	{
		action();
	}
	catch (const Error& error)
	{
		return error.what();
	}
	return "accepted";
}

}  // namespace explore::test

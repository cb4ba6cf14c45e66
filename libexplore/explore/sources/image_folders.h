// Recordings that are folders of depth images: the TUM RGB-D layout, and plain folders of PNG files.
#pragma once

#include <explore/sources/log_time.h>
#include <mrpt/poses/CPose3D.h>

#include <filesystem>
#include <string>
#include <vector>

namespace explore
{
struct TimedFile
{
	LogTime time;
	std::filesystem::path path;
};

struct TimedPose
{
	LogTime time;
	mrpt::poses::CPose3D pose;
};

/** Camera axes of ours (x forward, y left, z up) from optical ones (z forward, x right, y down). */
mrpt::poses::CPose3D cameraFromOptical();

/** Frames of depth.txt ("time file" a line, # comments), in its order. Throws InputError for a folder without
 * depth.txt, a line that does not parse (with its number), times that do not increase, a file that does not exist, no
 * frame. */
std::vector<TimedFile> listTumFolder(const std::filesystem::path& folder);

/** All *.png of the folder in natural order (2 before 10), `rate_hz` apart from `start` on. Throws InputError for a
 *  folder that is missing or holds none. */
std::vector<TimedFile> listPngFolder(const std::filesystem::path& folder, LogTime start, double rate_hz);

/** "t x y z qx qy qz qw" a line, # comments. Throws InputError with file and line for anything else. */
std::vector<TimedPose> readTumPoses(const std::filesystem::path& file);

/** a < b with runs of digits compared as numbers. */
bool naturallyLess(const std::string& a, const std::string& b);
}  // namespace explore

#include "image_folders.h"

#include <explore/core/errors.h>
#include <explore/sources/pose_track.h>
#include <mrpt/poses/CPose3DQuat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>

namespace explore
{
namespace
{
namespace fs = std::filesystem;

/** Calls `take` for each line that is neither empty nor a comment; `take` returns false where a line does not parse. */
void forEachLine(const fs::path& path, const std::string& expected,
                 const std::function<bool(std::istringstream&)>& take)
{
	std::ifstream file(path);
	if (!file) throw InputError(path.string() + ": " + std::strerror(errno) + "; a text file is needed");
	std::string line;
	for (int number = 1; std::getline(file, line); ++number)
	{
		const std::size_t begin = line.find_first_not_of(" \t\r");
		if (begin == std::string::npos || line[begin] == '#') continue;
		std::istringstream words(line);
		if (!take(words))
			throw InputError(path.string() + ":" + std::to_string(number) + ": '" + line.substr(0, 120) + "'; " +
			                 expected + " is needed");
	}
}

/** A time of the text formats: seconds since 1970. */
bool readTime(std::istringstream& words, LogTime& time)
{
	double seconds = 0;
	if (!(words >> seconds) || !(seconds >= 0.0 && seconds < 1e11)) return false;
	time = mrpt::Clock::fromDouble(seconds);
	return true;
}

std::string withoutZeros(const std::string& digits)
{
	return digits.substr(std::min(digits.find_first_not_of('0'), digits.size()));
}

/** The run of digits, or the single other character, at `at`. */
std::string tokenAt(const std::string& text, std::size_t at)
{
	std::size_t end = at;
	while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
	return text.substr(at, std::max<std::size_t>(end - at, 1));
}
}  // namespace

mrpt::poses::CPose3D cameraFromOptical()
{
	constexpr double kQuarter_rad = std::numbers::pi / 2;
	return {0, 0, 0, -kQuarter_rad, 0, -kQuarter_rad};
}

bool naturallyLess(const std::string& a, const std::string& b)
{
	std::size_t i = 0, j = 0;
	while (i < a.size() && j < b.size())
	{
		const std::string left = tokenAt(a, i), right = tokenAt(b, j);
		i += left.size();
		j += right.size();
		if (left == right) continue;
		if (std::isdigit(static_cast<unsigned char>(left[0])) == 0 ||
		    std::isdigit(static_cast<unsigned char>(right[0])) == 0)
			return left < right;
		const std::string left_digits = withoutZeros(left), right_digits = withoutZeros(right);
		if (left_digits.size() != right_digits.size()) return left_digits.size() < right_digits.size();
		if (left_digits != right_digits) return left_digits < right_digits;
	}
	const bool a_done = i == a.size(), b_done = j == b.size();
	return a_done != b_done ? a_done : a < b;
}

std::vector<TimedFile> listTumFolder(const fs::path& folder)
{
	const fs::path list = folder / "depth.txt";
	std::vector<TimedFile> frames;
	forEachLine(list, "'time file' with increasing times and a file that exists",
	            [&](std::istringstream& words)
	            {
		            TimedFile frame;
		            std::string name;
		            if (!readTime(words, frame.time) || !(words >> name)) return false;
		            frame.path = folder / name;
		            if (!frames.empty() && frame.time <= frames.back().time) return false;
		            frames.push_back(frame);
		            return fs::is_regular_file(frame.path);
	            });
	if (frames.empty()) throw InputError(list.string() + ": lists no image; 'time file' lines are needed");
	return frames;
}

std::vector<TimedFile> listPngFolder(const fs::path& folder, LogTime start, double rate_hz)
{
	std::error_code error;
	fs::directory_iterator entries(folder, error);
	if (error) throw InputError(folder.string() + ": " + error.message() + "; a folder of PNG files is needed");
	std::vector<TimedFile> frames;
	for (const fs::directory_entry& entry : entries)
	{
		std::string extension = entry.path().extension().string();
		std::transform(extension.begin(), extension.end(), extension.begin(),
		               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
		if (extension == ".png" && entry.is_regular_file()) frames.push_back({start, entry.path()});
	}
	if (frames.empty())
		throw InputError(folder.string() + ": holds no .png file; a folder of 16-bit PNG files is needed");
	std::sort(frames.begin(), frames.end(),
	          [](const TimedFile& a, const TimedFile& b)
	          { return naturallyLess(a.path.filename().string(), b.path.filename().string()); });
	for (std::size_t i = 0; i < frames.size(); ++i) frames[i].time = later(start, static_cast<double>(i) / rate_hz);
	return frames;
}

std::vector<TimedPose> readTumPoses(const fs::path& file)
{
	std::vector<TimedPose> poses;
	forEachLine(file, "'t x y z qx qy qz qw' with a unit quaternion",
	            [&](std::istringstream& words)
	            {
		            LogTime time;
		            std::array<double, 7> v{};
		            if (!readTime(words, time)) return false;
		            for (double& value : v)
			            if (!(words >> value) || !std::isfinite(value)) return false;
		            mrpt::math::CQuaternionDouble q(mrpt::math::UNINITIALIZED_QUATERNION);
		            q.r(v[6]), q.x(v[3]), q.y(v[4]), q.z(v[5]);
		            if (std::abs(q.norm() - 1.0) > 0.01) return false;
		            q.normalize();
		            const mrpt::poses::CPose3D pose(mrpt::poses::CPose3DQuat(v[0], v[1], v[2], q));
		            poses.push_back({time, pose});
		            return isSane(pose);
	            });
	return poses;
}
}  // namespace explore

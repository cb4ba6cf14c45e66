#include "external_files.h"

#include <explore/core/errors.h>
#include <explore/sources/allocation_limit.h>
#include <explore/sources/checked_stream.h>
#include <explore/sources/unusable_frame.h>
#include <mrpt/io/lazy_load_path.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationStereoImages.h>

#include <exception>
#include <vector>

namespace explore
{
namespace
{
namespace fs = std::filesystem;

/** MRPT resolves relative names against one path for the whole process: it is set for one load and put back. */
class LazyLoadPath
{
public:
	explicit LazyLoadPath(const fs::path& folder) : m_before(mrpt::io::getLazyLoadPathBase())
	{
		mrpt::io::setLazyLoadPathBase(folder.string());
	}
	~LazyLoadPath() { mrpt::io::setLazyLoadPathBase(m_before); }
	LazyLoadPath(const LazyLoadPath&) = delete;
	LazyLoadPath& operator=(const LazyLoadPath&) = delete;

private:
	std::string m_before;
};

std::vector<std::string> externalFilesOf(const mrpt::obs::CObservation& observation)
{
	std::vector<std::string> files;
	if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&observation))
	{
		if (scan->hasRangeImage && scan->rangeImage_isExternallyStored())
			files.push_back(scan->rangeImage_getExternalStorageFile(""));
		if (scan->hasPoints3D && scan->points3D_isExternallyStored())
			files.push_back(scan->points3D_getExternalStorageFile());
	}
	else if (const auto* cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud*>(&observation))
	{
		if (cloud->isExternallyStored()) files.push_back(cloud->getExternalStorageFile());
	}
	return files;
}

/** Reads a compressed file to its end: MRPT takes what it gets and does not notice damage. */
void checkFile(const fs::path& file)
{
	try
	{
		constexpr std::size_t kChunkBytes = std::size_t{1} << 20U;
		CheckedStream stream(file);
		if (stream.fileSize() == 0) throw UnusableFrame(file.string() + ": is empty", true);
		while (stream.compressed() && !stream.atEnd()) stream.drain(kChunkBytes);
	}
	catch (const InputError& error)
	{
		throw UnusableFrame(std::string("external file ") + error.what(), true);
	}
	catch (const StreamDamage& error)
	{
		throw UnusableFrame("external file " + file.string() + ": " + error.what(), true);
	}
}
}  // namespace

fs::path imagesFolderOf(const fs::path& rawlog, const std::string& configured)
{
	if (!configured.empty()) return configured;
	fs::path beside = rawlog.has_parent_path() ? rawlog.parent_path() : fs::path(".");
	const std::string stem = rawlog.stem().string();
	for (const std::string& name : {stem + "_Images", stem + "_images", std::string("Images")})
	{
		std::error_code error;
		if (fs::is_directory(beside / name, error)) return beside / name;
	}
	return beside;
}

bool storesExternally(const mrpt::obs::CObservation& observation)
{
	if (!externalFilesOf(observation).empty()) return true;
	if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&observation))
		return (scan->hasIntensityImage && scan->intensityImage.isExternallyStored()) ||
		       (scan->hasConfidenceImage && scan->confidenceImage.isExternallyStored());
	if (const auto* image = dynamic_cast<const mrpt::obs::CObservationImage*>(&observation))
		return image->image.isExternallyStored();
	if (const auto* stereo = dynamic_cast<const mrpt::obs::CObservationStereoImages*>(&observation))
		return stereo->imageLeft.isExternallyStored() || stereo->imageRight.isExternallyStored() ||
		       stereo->imageDisparity.isExternallyStored();
	return false;
}

void loadExternalFiles(const mrpt::obs::CObservation& observation, const fs::path& folder)
{
	const std::vector<std::string> files = externalFilesOf(observation);
	if (files.empty()) return;
	for (const std::string& file : files) checkFile(folder / file);
	try
	{
		const LazyLoadPath path(folder);
		const AllocationLimit limit(std::uint64_t{1} << 30U);
		observation.load();
	}
	catch (const std::exception&)
	{
		throw UnusableFrame("external file " + (folder / files.front()).string() + " cannot be loaded", true);
	}
}
}  // namespace explore

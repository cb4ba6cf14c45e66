// What a rawlog contains: for a look before it is replayed.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/sources/log_time.h>
#include <explore/sources/rawlog_reader.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace explore
{
/** All observations of one class and label. */
struct SensorInfo
{
	std::string class_name, label;
	std::size_t count = 0;
	std::optional<LogTime> first, last;
	std::optional<CameraIntrinsics> intrinsics;             ///< of a depth camera's first observation
	std::optional<mrpt::poses::CPose3D> robot_from_sensor;  ///< of the first observation
	std::string form;  ///< of a depth sensor: how its first observation holds depth

	/** Observations a second; no value for fewer than two times. */
	[[nodiscard]] std::optional<double> rate_hz() const;
};

struct RawlogInfo
{
	bool compressed = false;
	std::uint64_t file_bytes = 0;
	std::size_t objects = 0, sensory_frames = 0, observations_alone = 0;
	std::vector<SensorInfo> sensors;         ///< by class, then label
	std::vector<std::string> other_classes;  ///< entries that are no observation
	std::vector<PoseOrigin> pose_origins;    ///< kinds of robot poses met, best first
	bool has_accelerometer = false;
	std::optional<LogTime> first, last;
	std::optional<RawlogDamage> damage;
};

/** Reads the whole file. Throws InputError where nothing can be read at all, or no entry is one of a rawlog. */
RawlogInfo describeRawlog(const std::filesystem::path& path);

/** For people, one fact a line. */
std::string textOf(const RawlogInfo& info);
}  // namespace explore

// The one end of the street: anything that delivers depth frames.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/sources/source_config.h>
#include <mrpt/system/COutputLogger.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace explore
{
/** What became of the input so far. */
struct SourceReport
{
	std::string kind, path;
	std::size_t frames = 0;          ///< delivered
	std::size_t skipped_frames = 0;  ///< observations that could not be used (missing external image, no range data)
	std::size_t dropped_frames = 0;  ///< of a live camera: came while the one before was at work, or too late
	/** Live camera: the greatest age that a frame had when it was delivered. */
	std::optional<double> oldest_frame_ms;
	std::size_t away_frames = 0;   ///< delivered without image or points, a live camera being away
	std::uint64_t lost_bytes = 0;  ///< input after the damage that could not be read
	std::size_t lost_objects = 0;  ///< objects that are known to be damaged or missing (at least 1 when damaged)
	std::string damage;            ///< empty = intact; else what and where (byte offset)
	std::vector<std::string> sensors_found;  ///< labels of depth sensors met so far
	std::string sensor_label;                ///< the one that is used
	PoseOrigin pose_origin = PoseOrigin::none;
	bool identity_mount = false;  ///< robot_from_camera is the identity: camera = robot
};

/** A stream of depth frames in time order. */
class FrameSource
{
public:
	virtual ~FrameSource() = default;
	/** The next frame, or no value at the end of the input (also after damage: see report()). Throws InputError when
	 *  nothing at all can be read, or when the asked sensor is not in the input. A live camera never ends: it returns
	 *  after 0.5 s at the latest, with a frame that has neither image nor points while the camera is away, and throws
	 *  SensorLost when it stays away. */
	virtual std::optional<DepthFrame> next() = 0;
	[[nodiscard]] virtual SourceReport report() const = 0;
	/** Share of the input that was read, 0–1, where it is known. */
	[[nodiscard]] virtual std::optional<double> progress() const = 0;
};

/** The source of the recording that `config.rawlog` names. `logger` outlives the source. Throws ConfigError or
 * InputError. */
std::unique_ptr<FrameSource> makeSource(const SourceConfig& config, mrpt::system::COutputLogger& logger);
}  // namespace explore

// Replays a rawlog as depth frames in one pass, with a bounded look-ahead for poses and gravity.
#pragma once

#include <explore/sources/depth_conversion.h>
#include <explore/sources/gravity_track.h>
#include <explore/sources/rawlog_reader.h>
#include <explore/sources/recorded_poses.h>
#include <explore/sources/source.h>
#include <explore/sources/unusable_frame.h>
#include <explore/sources/warn_once.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <deque>
#include <optional>
#include <string>

namespace explore
{
/** Reads both rawlog layouts (observations; actions with sensory frames). A frame is held back until a pose at or after
 *  its time (and the IMU readings around it) were read, but no longer than 2 s of log time or 64 frames. */
class RawlogSource : public FrameSource
{
public:
	/** Throws InputError or ConfigError. `logger` outlives the source. */
	RawlogSource(const SourceConfig& config, mrpt::system::COutputLogger& logger);

	std::optional<DepthFrame> next() override;
	[[nodiscard]] SourceReport report() const override;
	[[nodiscard]] std::optional<double> progress() const override { return m_reader.progress(); }

private:
	bool readEntry();
	void takeSensoryFrame(const mrpt::obs::CSensoryFrame& sensory_frame);
	void take(const mrpt::obs::CObservation::Ptr& observation);
	void takeDepth(mrpt::obs::CObservation& observation);
	[[nodiscard]] bool isChosenSensor(const std::string& label);
	[[nodiscard]] LogTime frameTime(const mrpt::obs::CObservation& observation);
	void skip(const mrpt::obs::CObservation& observation, const UnusableFrame& why);
	[[nodiscard]] bool frontIsReady() const;
	void complete(DepthFrame& frame);
	void checkInput() const;

	SourceConfig m_config;
	WarnOnce m_warn;
	RawlogReader m_reader;
	DepthConverter m_converter;
	RecordedPoses m_poses;
	GravityTrack m_gravity;

	std::deque<DepthFrame> m_pending;
	std::optional<LogTime> m_log_time;         ///< latest usable time read
	std::optional<LogTime> m_last_frame_time;  ///< of the frame that was read last
	std::optional<std::string> m_label;
	SourceReport m_report;
	std::string m_first_loss;  ///< why the first frame was skipped that should not have been
	std::size_t m_lost_frames = 0;
	bool m_depth_met = false;
};
}  // namespace explore

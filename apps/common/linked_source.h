// A source whose frames carry what the robot itself says: its pose, which way is up, its scans, bumper and cliff
// sensor.
#pragma once

#include <explore/sinks/robot_link/robot_inbox.h>
#include <explore/sources/gravity_track.h>
#include <explore/sources/pose_track.h>
#include <explore/sources/source.h>

#include <memory>
#include <optional>

namespace explore::app
{
/** Passes all frames of a source on.
 *  - From the first pose of the robot on, poses are the robot's alone: interpolated to the frame's time, the nearest
 * one within 0.2 s outside the known times.
 *  - The newest scan up to 0.2 s away becomes obstacles.
 *  - A robot that has sent poses, or scans, and has none for a frame is halted, as is one whose bumper is pressed or
 *    that sees a cliff.
 *  - Messages whose time is more than 10 s away from the frame's are passed over, which is remarked once. */
class LinkedSource : public FrameSource
{
public:
	static constexpr double kNear_s = 0.2;

	/** `inbox` and `logger` outlive the source. */
	LinkedSource(std::unique_ptr<FrameSource> source, RobotInbox& inbox, mrpt::system::COutputLogger& logger);

	/** Throws as that of the source. */
	std::optional<DepthFrame> next() override;
	[[nodiscard]] SourceReport report() const override;
	[[nodiscard]] std::optional<double> progress() const override { return m_source->progress(); }

private:
	void takeMessages(LogTime frame_time);
	void addAcceleration(const RobotMessage::Timed<Eigen::Vector3d>& acceleration);
	void setPose(DepthFrame& frame);
	void setUp(DepthFrame& frame);
	void addObstacles(DepthFrame& frame);
	void setAlarms(DepthFrame& frame) const;
	void lose(DepthFrame& frame, const std::string& what);

	std::unique_ptr<FrameSource> m_source;
	RobotInbox& m_inbox;
	WarnOnce m_warn;
	PoseTrack m_poses;
	GravityTrack m_gravity;
	std::deque<mrpt::obs::CObservation2DRangeScan> m_scans;  ///< by time of arrival
	bool m_had_pose = false, m_had_scan = false;
};

/** The valid points of a scan, robot frame. */
PointCloud pointsOf(const mrpt::obs::CObservation2DRangeScan& scan);
}  // namespace explore::app

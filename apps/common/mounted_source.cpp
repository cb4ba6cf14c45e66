#include <common/interrupt.h>
#include <common/mounted_source.h>
#include <explore/perception/mount.h>
#include <mrpt/core/bits_math.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace explore::app
{
namespace
{
constexpr std::size_t kFramesToLookAt = 10;

/** The recorded yaw; 0 where a rotation far from level leaves it without meaning (as of an optical frame). */
double yawOf(const mrpt::poses::CPose3D& robot_from_camera)
{
	constexpr double kFarFromLevel_rad = std::numbers::pi / 4;
	const bool level = std::abs(robot_from_camera.pitch()) < kFarFromLevel_rad &&
	                   std::abs(robot_from_camera.roll()) < kFarFromLevel_rad;
	return level ? robot_from_camera.yaw() : 0.0;
}
}  // namespace

MountedSource::MountedSource(std::unique_ptr<FrameSource> source, MountPolicy policy,
                             const PerceptionConfig& perception, mrpt::system::COutputLogger& logger, Input input)
    : m_source(std::move(source)), m_policy(policy), m_perception(perception), m_logger(logger), m_input(input)
{
	lookAtFirstFrames();
}

std::optional<DepthFrame> MountedSource::next()
{
	std::optional<DepthFrame> frame;
	if (m_held_back.empty())
		frame = m_source->next();
	else
	{
		frame = std::move(m_held_back.front());
		m_held_back.pop_front();
	}
	if (frame) frame->index -= m_passed_over;
	if (frame && m_mount)
	{
		const auto& recorded = frame->robot_from_camera;
		frame->robot_from_camera = mrpt::poses::CPose3D(recorded.x(), recorded.y(), m_mount->height_m, yawOf(recorded),
		                                                m_mount->pitch_rad, m_mount->roll_rad);
	}
	return frame;
}

SourceReport MountedSource::report() const
{
	SourceReport report = m_source->report();
	report.frames -= m_passed_over;
	report.dropped_frames += m_passed_over;
	return report;
}

void MountedSource::lookAtFirstFrames()
{
	std::vector<DepthFrame> frames;
	while (frames.size() < kFramesToLookAt && signalReceived() == 0)
	{
		auto frame = m_source->next();
		if (!frame) break;
		frames.push_back(std::move(*frame));
	}
	if (frames.empty()) return;
	if (m_policy == MountPolicy::estimate)
		estimate(frames);
	else if (const auto remark = mountRemark(frames, m_perception))
		m_logger.logStr(mrpt::system::LVL_WARN, *remark);
	if (m_input == Input::live)
		m_passed_over = frames.size();
	else
		m_held_back.assign(std::make_move_iterator(frames.begin()), std::make_move_iterator(frames.end()));
}

void MountedSource::estimate(const std::vector<DepthFrame>& frames)
{
	const auto found = estimateMount(frames, m_perception);
	if (!found)
	{
		m_logger.logFmt(mrpt::system::LVL_WARN,
		                "camera mount: no floor in the first %zu frames to estimate it from; the recorded mount stays",
		                frames.size());
		return;
	}
	m_mount = Mount{found->height_m, found->pitch_rad, found->roll_rad};
	m_logger.logFmt(
	    mrpt::system::LVL_INFO,
	    "camera mount from the floor in %zu of %zu frames: %.2f m high, pitch %+.1f deg (down), roll %+.1f deg",
	    found->frames, frames.size(), found->height_m, mrpt::RAD2DEG(found->pitch_rad), mrpt::RAD2DEG(found->roll_rad));
}

}  // namespace explore::app

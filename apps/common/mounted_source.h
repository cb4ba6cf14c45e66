// A source whose camera mount has been looked at: estimated from the floor where the ini asks for it, else checked.
#pragma once

#include <explore/perception/perception_config.h>
#include <explore/sources/source.h>

#include <deque>

namespace explore::app
{
/** Reads the first ten frames ahead, judges the mount by them, and passes all frames on; of a live camera not those
 * ten, which are old by then and count as dropped. */
class MountedSource : public FrameSource
{
public:
	enum class Input
	{
		recording,
		live
	};
	/** Reads the first frames, so that an input without any is noticed here. `logger` outlives the source. Throws as
	 *  FrameSource::next(). */
	MountedSource(std::unique_ptr<FrameSource> source, MountPolicy policy, const PerceptionConfig& perception,
	              mrpt::system::COutputLogger& logger, Input input = Input::recording);

	std::optional<DepthFrame> next() override;
	[[nodiscard]] SourceReport report() const override;
	[[nodiscard]] std::optional<double> progress() const override { return m_source->progress(); }

private:
	void lookAtFirstFrames();
	void estimate(const std::vector<DepthFrame>& frames);

	std::unique_ptr<FrameSource> m_source;
	MountPolicy m_policy;
	PerceptionConfig m_perception;
	mrpt::system::COutputLogger& m_logger;
	Input m_input;
	std::deque<DepthFrame> m_held_back;
	std::size_t m_passed_over = 0;

	struct Mount
	{
		double height_m, pitch_rad, roll_rad;
	};
	std::optional<Mount> m_mount;  ///< replaces the recorded height and tilt
};
}  // namespace explore::app

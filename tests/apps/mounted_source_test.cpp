#include "support/analytic_scene.h"

#include <common/mounted_source.h>
#include <gmock/gmock.h>

using namespace explore;
using namespace explore::app;
using testing::HasSubstr;

namespace
{
/** Frames of a corridor, seen by a camera at `real` while the log says `recorded`. */
class CorridorSource : public FrameSource
{
public:
	CorridorSource(std::size_t frames, const mrpt::poses::CPose3D& real, const mrpt::poses::CPose3D& recorded)
	    : m_frames(frames),
	      m_frame(test::renderFrame(test::corridorScene(10.0, {}, {}), {}, real, test::xtionIntrinsics(160, 120)))
	{
		m_frame.robot_from_camera = recorded;
	}
	std::optional<DepthFrame> next() override
	{
		if (m_delivered == m_frames) return std::nullopt;
		m_frame.index = m_delivered++;
		return m_frame;
	}
	[[nodiscard]] SourceReport report() const override
	{
		SourceReport report;
		report.frames = m_delivered;
		return report;
	}
	[[nodiscard]] std::optional<double> progress() const override { return std::nullopt; }

private:
	std::size_t m_frames, m_delivered = 0;
	DepthFrame m_frame;
};

struct Log : mrpt::system::COutputLogger
{
	Log()
	{
		logging_enable_console_output = false;
		logRegisterCallback([this](std::string_view message, mrpt::system::VerbosityLevel level, std::string_view,
		                           mrpt::Clock::time_point)
		                    { (level == mrpt::system::LVL_WARN ? warnings : notes) += message; });
	}
	std::string warnings, notes;
};

const mrpt::poses::CPose3D kReal(0.1, 0.02, 0.62, 0.0, 0.2, 0.05);

std::vector<DepthFrame> readAll(FrameSource& source)
{
	std::vector<DepthFrame> frames;
	while (auto frame = source.next()) frames.push_back(*frame);
	return frames;
}
}  // namespace

TEST(MountedSource, OfALiveCameraTheFramesThatWereLookedAtAreNotDeliveredLate)
{
	Log log;
	MountedSource source(std::make_unique<CorridorSource>(25, kReal, kReal), MountPolicy::estimate, {}, log,
	                     MountedSource::Input::live);
	const auto frames = readAll(source);
	ASSERT_EQ(frames.size(), 15U);
	for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_EQ(frames[i].index, i);
	EXPECT_NEAR(frames.front().robot_from_camera.z(), 0.62, 0.02) << "they were looked at";
	EXPECT_EQ(source.report().frames, 15U);
	EXPECT_EQ(source.report().dropped_frames, 10U);
}

TEST(MountedSource, EstimateFindsHeightAndTiltAndKeepsTheRest)
{
	Log log;
	MountedSource source(std::make_unique<CorridorSource>(12, kReal, mrpt::poses::CPose3D(0.1, 0.02, 0, 0.3, 0, 0)),
	                     MountPolicy::estimate, {}, log);
	const auto frames = readAll(source);
	ASSERT_EQ(frames.size(), 12U);
	for (std::size_t i = 0; i < frames.size(); ++i)
	{
		EXPECT_EQ(frames[i].index, i);
		const auto& mount = frames[i].robot_from_camera;
		EXPECT_NEAR(mount.z(), 0.62, 0.01);
		EXPECT_NEAR(mount.pitch(), 0.2, 0.01);
		EXPECT_NEAR(mount.roll(), 0.05, 0.01);
		EXPECT_EQ(mount.x(), 0.1);
		EXPECT_EQ(mount.y(), 0.02);
		EXPECT_NEAR(mount.yaw(), 0.3, 1e-12);
	}
	EXPECT_THAT(log.notes, HasSubstr("0.62 m high"));
}

TEST(MountedSource, YawOfAnOpticalFrameIsNotKept)
{
	Log log;
	const mrpt::poses::CPose3D optical(0, 0, 0, -1.5707963, 0, -1.5707963);
	MountedSource source(std::make_unique<CorridorSource>(1, kReal, optical), MountPolicy::estimate, {}, log);
	EXPECT_NEAR(readAll(source).at(0).robot_from_camera.yaw(), 0.0, 1e-12);
}

TEST(MountedSource, WrongRecordedMountIsRemarkedOnceAndKept)
{
	Log log;
	const mrpt::poses::CPose3D wrong(0, 0, 1.5, 0, 0, 0);
	MountedSource source(std::make_unique<CorridorSource>(25, kReal, wrong), MountPolicy::log, {}, log);
	const auto frames = readAll(source);
	ASSERT_EQ(frames.size(), 25U);
	EXPECT_NEAR(frames.back().robot_from_camera.z(), 1.5, 1e-12);
	EXPECT_THAT(log.warnings, HasSubstr("floor"));
	EXPECT_EQ(log.warnings.find("floor is not"), log.warnings.rfind("floor is not"));
}

TEST(MountedSource, RightRecordedMountNeedsNoRemark)
{
	Log log;
	MountedSource source(std::make_unique<CorridorSource>(3, kReal, kReal), MountPolicy::log, {}, log);
	EXPECT_EQ(readAll(source).size(), 3U);
	EXPECT_EQ(log.warnings, "");
}

TEST(MountedSource, EmptySourceStaysEmpty)
{
	Log log;
	MountedSource source(std::make_unique<CorridorSource>(0, kReal, kReal), MountPolicy::estimate, {}, log);
	EXPECT_TRUE(readAll(source).empty());
}

#include "openni2/virtual_camera.h"

#include <OpenNI.h>
#include <explore/core/errors.h>
#include <explore/openni2/openni2_source.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

using namespace explore;
using namespace explore::openni2;
using namespace explore::test;
using namespace std::chrono_literals;
using testing::HasSubstr;

namespace
{
/** Keeps what it is told. */
struct Log : mrpt::system::COutputLogger
{
	Log()
	{
		logging_enable_console_output = false;
		logRegisterCallback([this](std::string_view text, const mrpt::system::VerbosityLevel, std::string_view,
		                           const mrpt::Clock::time_point) { all.append(text).append("\n"); });
	}
	std::string all;
};

/** The next frame that has an image; none after `patience`. */
std::optional<DepthFrame> nextImage(FrameSource& source, std::chrono::seconds patience = 20s)
{
	const auto due = std::chrono::steady_clock::now() + patience;
	while (std::chrono::steady_clock::now() < due)
		if (auto frame = source.next(); frame && !frame->image.empty()) return frame;
	return std::nullopt;
}

/** Whether frames without an image come soon. */
bool becomesEmpty(FrameSource& source)
{
	const auto due = std::chrono::steady_clock::now() + 20s;
	while (std::chrono::steady_clock::now() < due)
		if (const auto frame = source.next(); frame && frame->image.empty()) return true;
	return false;
}

std::string lossOf(FrameSource& source)
{
	const auto due = std::chrono::steady_clock::now() + 30s;
	try
	{
		while (std::chrono::steady_clock::now() < due) source.next();
	}
	catch (const SensorLost& lost)
	{
		return lost.what();
	}
	return "";
}

std::string startError(const SourceConfig& config)
{
	Log log;
	try
	{
		Openni2Source source(config, log);
	}
	catch (const std::exception& error)
	{
		return error.what();
	}
	return "";
}
}  // namespace

TEST(Live, DeliversWhatTheCameraSees)
{
	const VirtualCamera camera;
	Log log;
	Openni2Source source(camera.config(), log);
	std::optional<mrpt::Clock::time_point> last;
	const auto before = mrpt::Clock::now();
	for (std::size_t i = 0; i < 60; ++i)
	{
		const auto frame = nextImage(source);
		ASSERT_TRUE(frame);
		EXPECT_GE(camera.imageOf(frame->image), 0);
		EXPECT_EQ(frame->sensor_label, "OPENNI2");
		EXPECT_GT(frame->timestamp, last.value_or(before - 1s));
		last = frame->timestamp;
		const CameraIntrinsics& found = frame->image.intrinsics;
		EXPECT_NEAR(found.fx_px, camera.served().fx_px, 1e-3);
		EXPECT_NEAR(found.fy_px, camera.served().fy_px, 1e-3);
		EXPECT_EQ(found.cx_px, 79.5);
		EXPECT_EQ(found.cy_px, 59.5);
	}
	EXPECT_GE(*last, before);
	EXPECT_LE(*last, mrpt::Clock::now());
	EXPECT_EQ(log.all, "");
}

TEST(HostTime, FollowsTheLeastDelayAndADriftingClock)
{
	HostTime clock;
	const auto start = mrpt::Clock::fromDouble(1'500'000'000.0);
	const auto after = [&](double seconds)
	{ return start + std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::duration<double>(seconds)); };
	auto last = start;
	double worst_s = 0;
	for (int i = 0; i < 3000; ++i)
	{
		const double taken_s = i / 30.0;
		RawDepth raw;
		// A clock that is 0.01 % slow, and frames that come 5 ms late, every third one 60 ms; the first one is slow.
		raw.device_time_us = static_cast<std::uint64_t>(7e6 + 1e6 * taken_s * 0.9999);
		raw.arrived = after(taken_s + (i % 3 == 0 ? 0.06 : 0.005));
		const auto time = clock.of(raw);
		EXPECT_GT(time, last);
		last = time;
		if (i > 3) worst_s = std::max(worst_s, std::abs(mrpt::Clock::toDouble(time) - 1'500'000'000.0 - taken_s));
	}
	EXPECT_LT(worst_s, 0.007);
}

TEST(HostTime, BeginsAnewAfterASecondOfLateFramesForTheClockWasSetBack)
{
	HostTime clock;
	const auto start = mrpt::Clock::fromDouble(1'500'000'000.0);
	const auto delay_s = [&](int i, double set_back_s)
	{
		RawDepth raw;
		raw.device_time_us = static_cast<std::uint64_t>(7e6 + 1e6 * (i / 30.0 - set_back_s));
		raw.arrived = start + std::chrono::milliseconds(i * 1000 / 30);
		return mrpt::Clock::toDouble(raw.arrived) - mrpt::Clock::toDouble(clock.taken(raw));
	};
	for (int i = 0; i < 30; ++i) EXPECT_NEAR(delay_s(i, 0.0), 0.0, 0.002);
	// Who knows whether they are late: for a second they are held to be.
	for (int i = 30; i < 60; ++i) EXPECT_NEAR(delay_s(i, 0.4), 0.4, 0.01) << i;
	for (int i = 63; i < 120; ++i) EXPECT_NEAR(delay_s(i, 0.4), 0.0, 0.01) << i;
}

TEST(Live, TakesTheLatestFrameAndCountsTheOthers)
{
	VirtualCamera camera;
	camera.set("rate_hz", "100");
	SourceConfig config = camera.config();
	Log log;
	Openni2Source source(config, log);
	ASSERT_TRUE(nextImage(source));
	std::this_thread::sleep_for(600ms);
	const auto asked = mrpt::Clock::now();
	const auto frame = nextImage(source);
	ASSERT_TRUE(frame);
	EXPECT_GT(frame->timestamp, asked - 300ms);
	EXPECT_GE(source.report().dropped_frames, 5U);
	ASSERT_TRUE(source.report().oldest_frame_ms);
	EXPECT_LT(*source.report().oldest_frame_ms, 100.0) << "what waited gave way to what came";
}

TEST(Live, UsesNoFrameThatComesLaterThanATenthOfASecond)
{
	VirtualCamera camera;
	Log log;
	Openni2Source source(camera.config(), log);
	for (int i = 0; i < 20; ++i) ASSERT_TRUE(nextImage(source));
	const std::size_t dropped = source.report().dropped_frames;
	camera.set("late_s", "0.2");
	const auto late_since = std::chrono::steady_clock::now();
	ASSERT_TRUE(becomesEmpty(source)) << "the robot stops";
	EXPECT_GE(source.report().dropped_frames, dropped + 3);
	const auto frame = nextImage(source);
	ASSERT_TRUE(frame) << "all of them being late, it is the clock";
	EXPECT_GT(std::chrono::steady_clock::now() - late_since, 800ms);
	EXPECT_LE(source.report().oldest_frame_ms.value_or(1e6), 100.0);
}

TEST(Live, EveryFrameIsUsedOrCounted)
{
	VirtualCamera camera;
	camera.set("rate_hz", "100");
	Log log;
	std::size_t counted = 0;
	{
		Openni2Source source(camera.config(), log);
		for (int i = 0; i < 10; ++i)
		{
			source.next();
			std::this_thread::sleep_for(30ms * i);
		}
		const SourceReport report = source.report();
		counted = report.frames - report.away_frames + report.dropped_frames;
	}
	// One may wait for its turn, one be on its way to there, and one come after the counting.
	const auto served = std::stoul(camera.left("served"));
	EXPECT_LE(counted, served);
	EXPECT_LE(served, counted + 5);
	EXPECT_GT(counted, 100U);
}

TEST(Live, CountsTenthsOfMillimetres)
{
	VirtualCamera camera(160, 120, 5, 0.0001);
	camera.set("unit", "100um");
	Log log;
	Openni2Source source(camera.config(), log);
	const auto frame = nextImage(source);
	ASSERT_TRUE(frame);
	EXPECT_GE(camera.imageOf(frame->image), 0);
}

TEST(Live, TakesIntrinsicsLabelAndCorrectionFromTheIni)
{
	const VirtualCamera camera(64, 48, 1);
	SourceConfig config = camera.config();
	config.openni2.fx_px = 70, config.openni2.fy_px = 71, config.openni2.cx_px = 33, config.openni2.cy_px = 22;
	config.sensor_label = "HEAD";
	config.camera.depth_scale = 2.0;
	config.camera.z_m = 0.7;
	Log log;
	Openni2Source source(config, log);
	const auto frame = nextImage(source);
	ASSERT_TRUE(frame);
	EXPECT_EQ(frame->image.intrinsics, (CameraIntrinsics{64, 48, 70, 71, 33, 22}));
	EXPECT_EQ(frame->sensor_label, "HEAD");
	EXPECT_EQ(frame->robot_from_camera.z(), 0.7);
	const std::size_t middle = 24 * 64 + 32;
	EXPECT_NEAR(frame->image.depth_m[middle], 2e-3 * camera.served().images[0][middle], 1e-5);
}

TEST(Live, FindsTheCameraByNumberSerialAndUri)
{
	const VirtualCamera camera;
	for (const char* name : {"", "0", "V0042", "virtual/camera@1/1", "virtual/camera@1/9"})
	{
		SourceConfig config = camera.config();
		config.openni2.device = name;
		EXPECT_EQ(startError(config), "") << name;
	}
	SourceConfig config = camera.config();
	config.openni2.device = "V0043";
	EXPECT_THAT(startError(config), HasSubstr("virtual/camera@1/1"));
}

TEST(Live, SaysAtOnceThatThereIsNoCamera)
{
	VirtualCamera camera;
	camera.set("plugged", "0");
	const auto start = std::chrono::steady_clock::now();
	const std::string error = startError(camera.config());
	EXPECT_LT(std::chrono::steady_clock::now() - start, 2s);
	for (const char* hint : {"no depth camera", "udev", "snd_usb_audio", "UsbInterface", "cable"})
		EXPECT_THAT(error, HasSubstr(hint));
}

TEST(Live, SaysWhyTheCameraDoesNotOpen)
{
	VirtualCamera camera;
	camera.set("denied", "1");
	EXPECT_THAT(startError(camera.config()), HasSubstr("access denied"));
	camera.set("denied", "0");
	camera.set("starts", "0");
	EXPECT_THAT(startError(camera.config()), HasSubstr("does not start"));
}

TEST(Live, SaysWhichSizesTheCameraHas)
{
	const VirtualCamera camera;
	SourceConfig config = camera.config();
	config.openni2.width_px = 320;
	Log log;
	EXPECT_THROW(Openni2Source(config, log), ConfigError);
	EXPECT_THAT(startError(config), HasSubstr("160x120 at 30 Hz"));
}

TEST(Live, RegistersDepthWhereTheCameraCanAndSaysWhereItCannot)
{
	VirtualCamera camera;
	SourceConfig config = camera.config();
	config.openni2.registration = true;
	Log log;
	EXPECT_THROW(Openni2Source(config, log), ConfigError);
	EXPECT_THAT(startError(config), HasSubstr("[openni2] registration = true: the camera cannot do that"));
	camera.set("registers", "1");
	EXPECT_EQ(startError(config), "");
	EXPECT_EQ(camera.left("registration"), std::to_string(openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR));
	config.openni2.registration = false;
	EXPECT_EQ(startError(config), "");
	EXPECT_EQ(camera.left("registration"), std::to_string(openni::IMAGE_REGISTRATION_OFF));
}

TEST(Live, ComesBackAfterItWasUnplugged)
{
	VirtualCamera camera;
	Log log;
	Openni2Source source(camera.config(), log);
	const auto before = nextImage(source);
	ASSERT_TRUE(before);
	camera.set("plugged", "0");
	// On a busy machine there is nothing to see for half a second before the loss is noticed.
	for (int i = 0; i < 20 && log.all.empty(); ++i) ASSERT_TRUE(becomesEmpty(source));
	EXPECT_THAT(log.all, HasSubstr("was unplugged"));
	const auto asked = std::chrono::steady_clock::now();
	const auto empty = source.next();
	EXPECT_LT(std::chrono::steady_clock::now() - asked, 1s);
	ASSERT_TRUE(empty);
	EXPECT_TRUE(empty->image.empty());
	EXPECT_GT(empty->timestamp, before->timestamp);

	camera.set("plugged", "1");
	const auto plugged = std::chrono::steady_clock::now();
	const auto after = nextImage(source);
	ASSERT_TRUE(after);
	EXPECT_LT(std::chrono::steady_clock::now() - plugged, 2s);
	EXPECT_GT(after->timestamp, empty->timestamp);
	source.next();
	EXPECT_THAT(log.all, HasSubstr("delivers frames again"));
}

TEST(Live, SaysAtOnceThatItWasUnplugged)
{
#ifdef __SANITIZE_THREAD__
	GTEST_SKIP() << "a test of timing";
#endif
	VirtualCamera camera;
	Log log;
	Openni2Source source(camera.config(), log);
	ASSERT_TRUE(nextImage(source));
	const auto unplugged = std::chrono::steady_clock::now();
	camera.set("plugged", "0");
	ASSERT_TRUE(becomesEmpty(source));
	// A camera that is only silent is waited for half a second.
	EXPECT_LT(std::chrono::steady_clock::now() - unplugged, 400ms);
}

TEST(Live, OpensACameraAnewThatIsSilent)
{
	VirtualCamera camera;
	Log log;
	Openni2Source source(camera.config(), log);
	ASSERT_TRUE(nextImage(source));
	camera.set("stalled", "1");
	const auto due = std::chrono::steady_clock::now() + 3s;
	while (log.all.empty() && std::chrono::steady_clock::now() < due) source.next();
	EXPECT_THAT(log.all, HasSubstr("no frame for 1 s"));
	camera.set("stalled", "0");
	EXPECT_TRUE(nextImage(source));
}

TEST(Live, PassesOverFramesThatAreNotWhole)
{
	VirtualCamera camera;
	Log log;
	Openni2Source source(camera.config(), log);
	for (const char* kind : {"size", "empty"})
	{
		ASSERT_TRUE(nextImage(source));
		camera.set("corrupt", kind);
		ASSERT_TRUE(becomesEmpty(source)) << kind;
		EXPECT_GE(source.report().skipped_frames, 3U);
		camera.set("corrupt", "none");
		const auto frame = nextImage(source);
		ASSERT_TRUE(frame);
		EXPECT_GE(camera.imageOf(frame->image), 0);
	}
}

TEST(Live, SurvivesTwentyPlugsAndIsBackSoonAfterEach)
{
	VirtualCamera camera(64, 48, 3);
	Log log;
	Openni2Source source(camera.config(), log);
	ASSERT_TRUE(nextImage(source));
	std::chrono::duration<double> longest{};
	for (int i = 0; i < 20; ++i)
	{
		camera.set("plugged", "0");
		ASSERT_TRUE(becomesEmpty(source)) << i;
		std::this_thread::sleep_for(100ms * (7 * i % 20));
		camera.set("plugged", "1");
		const auto plugged = std::chrono::steady_clock::now();
		ASSERT_TRUE(nextImage(source)) << i;
		longest = std::max<std::chrono::duration<double>>(longest, std::chrono::steady_clock::now() - plugged);
	}
	EXPECT_LT(longest, 2s);
	RecordProperty("longest_recovery_ms", static_cast<int>(1000 * longest.count()));
}

TEST(Live, IsLostWhenItStaysAway)
{
	VirtualCamera camera;
	SourceConfig config = camera.config();
	config.openni2.lost_after_s = 1.5;
	Log log;
	Openni2Source source(config, log);
	ASSERT_TRUE(nextImage(source));
	camera.set("plugged", "0");
	const std::string loss = lossOf(source);
	for (const char* hint : {"lost", "1.5 s", "udev", "snd_usb_audio", "UsbInterface", "cable"})
		EXPECT_THAT(loss, HasSubstr(hint));
}

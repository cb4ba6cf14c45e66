// The programs with a camera, as a user runs them: processes, files and exit codes.
#include "apps/program.h"
#include "apps/rawlog_program.h"
#include "openni2/virtual_camera.h"
#include "support/test_sockets.h"

#include <explore/openni2/oni_source.h>
#include <explore/sources/rawlog_source.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CRawlog.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <csignal>
#include <iostream>
#include <thread>

using namespace explore;
using namespace explore::test;
using namespace std::chrono_literals;
using std::chrono::steady_clock;
using testing::HasSubstr;

namespace
{
using Arguments = std::vector<std::string>;

/** Arguments that suit a camera of 160 × 120 pixels. */
Arguments withCamera(Arguments arguments)
{
	for (const char* setting : {"source.kind=openni2", "openni2.width_px=160", "openni2.height_px=120",
	                            "openni2.lost_after_s=1.5", "camera.mount=ini", "camera.pose_z=0.5"})
	{
		arguments.emplace_back("--set");
		arguments.emplace_back(setting);
	}
	return arguments;
}

Arguments explored(const std::filesystem::path& out)
{
	return withCamera({"--out", out.string(), "--set", "output.pictures_every=0"});
}

/** Whether `path` gets at least `lines` lines in time. */
bool grows(const std::filesystem::path& path, std::size_t lines)
{
	const auto due = steady_clock::now() + 30s;
	for (; steady_clock::now() < due; std::this_thread::sleep_for(20ms))
		if (linesOf(readFile(path)).size() >= lines) return true;
	return false;
}

/** All lines of frames.jsonl; fails the test where one is no JSON, or the times do not grow. */
std::vector<nlohmann::json> frameLines(const std::filesystem::path& out)
{
	std::vector<nlohmann::json> frames;
	double last_t = 0;
	for (const std::string& line : linesOf(readFile(out / "frames.jsonl")))
	{
		frames.push_back(nlohmann::json::parse(line));
		EXPECT_EQ(frames.back()["frame"], frames.size() - 1);
		EXPECT_GT(frames.back()["t"], last_t);
		last_t = frames.back()["t"];
	}
	return frames;
}

nlohmann::json summaryOf(const std::filesystem::path& out)
{
	return nlohmann::json::parse(readFile(out / "summary.json"));
}

bool waitsFor(const Program& program, std::chrono::milliseconds time)
{
	const auto due = steady_clock::now() + time;
	while (program.running() && steady_clock::now() < due) std::this_thread::sleep_for(10ms);
	return !program.running();
}
}  // namespace

TEST(CameraPrograms, ExploreFromTheCamera)
{
	const VirtualCamera camera;
	const auto out = testFolder() / "out";
	Arguments arguments = explored(out);
	arguments.insert(arguments.end(), {"--max-frames", "60"});
	const ProgramResult result = exploreMrpt(arguments);
	EXPECT_EQ(result.exit_code, 0) << result.err;
	const auto frames = frameLines(out);
	ASSERT_EQ(frames.size(), 60U);
	EXPECT_EQ(frames[0]["sensor"], "OPENNI2");
	EXPECT_GE(summaryOf(out)["frames_with_ground"], 50);
	EXPECT_EQ(summaryOf(out)["source"]["kind"], "openni2");
	EXPECT_TRUE(summaryOf(out)["source"]["dropped_frames"].is_number());
	EXPECT_EQ(exploreMrpt({"--resume", out.string()}).exit_code, 3);
}

TEST(CameraPrograms, WithoutACameraEndAtOnce)
{
	VirtualCamera camera;
	camera.set("plugged", "0");
	const auto start = steady_clock::now();
	const ProgramResult result = exploreMrpt({"--ini", "xtion.ini", "--out", (testFolder() / "out").string()});
	EXPECT_LT(steady_clock::now() - start, 2s);
	EXPECT_EQ(result.exit_code, 4);
	for (const char* hint :
	     {"no depth camera", "udev", "snd_usb_audio", "UsbInterface", "/etc/openni2/PS1080.ini", "cable"})
		EXPECT_THAT(result.err, HasSubstr(hint));
	EXPECT_EQ(exploreRawlog({"record", "--openni2", "list"}).exit_code, 4);
}

TEST(CameraPrograms, StopTheRobotWhileTheCameraIsAwayAndEndWhenItIsLost)
{
	VirtualCamera camera;
	const auto out = testFolder() / "out";
	Program program(EXPLORE_MRPT_PROGRAM, explored(out), {});
	ASSERT_TRUE(grows(out / "frames.jsonl", 15));
	camera.set("plugged", "0");
	ASSERT_TRUE(waitsFor(program, 20s));
	const ProgramResult result = program.wait();
	EXPECT_EQ(result.exit_code, 4) << result.err;
	EXPECT_THAT(result.err, HasSubstr("was unplugged"));
	EXPECT_THAT(result.err, HasSubstr("UsbInterface"));
	const auto frames = frameLines(out);
	ASSERT_FALSE(frames.empty());
	EXPECT_EQ(frames.back()["stop"], true);
	EXPECT_EQ(frames.back()["stop_reason"], "empty_frame");
	EXPECT_EQ(frames.back()["command"]["v"], nlohmann::json({0, 0, 0}));
	const auto summary = summaryOf(out);
	EXPECT_GE(summary["source"]["away_frames"], 2);
	EXPECT_THAT(summary["exploration"]["reason"].get<std::string>(), HasSubstr("lost"));
}

TEST(CameraPrograms, TellTheRobotToStopAsSoonAsTheCameraIsUnplugged)
{
	VirtualCamera camera;
	const UdpReceiver robot;
	Arguments arguments = explored(testFolder() / "out");
	// Lost cameras end runs: not before this one is told to.
	arguments.insert(arguments.end(),
	                 {"--set", "robot_link.commands=" + robot.uri(), "--set", "openni2.lost_after_s=10"});
	Program program(EXPLORE_MRPT_PROGRAM, arguments, {});
	const auto moves = [&] { return !nlohmann::json::parse(robot.socket().receive())["stop"].get<bool>(); };
	const auto due = steady_clock::now() + 30s;
	bool moving = false;
	while (!moving && steady_clock::now() < due) moving = robot.socket().readable(1000) && moves();
	ASSERT_TRUE(moving);

	const auto unplugged = steady_clock::now();
	camera.set("plugged", "0");
	auto last = unplugged;
	while (steady_clock::now() < unplugged + 1s)
		if (robot.socket().readable(100) && moves()) last = steady_clock::now();
	const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(last - unplugged);
	RecordProperty("last_command_to_move_ms", static_cast<int>(took.count()));
	// Some 100 ms on a machine with nothing else to do.
	EXPECT_LT(took, 300ms);
	program.signal(SIGTERM);
	const ProgramResult result = program.wait();
	EXPECT_EQ(result.exit_code, 143) << result.err;
}

TEST(CameraPrograms, GoOnWhenTheCameraIsBack)
{
	VirtualCamera camera;
	const auto out = testFolder() / "out";
	Program program(EXPLORE_MRPT_PROGRAM, explored(out), {});
	ASSERT_TRUE(grows(out / "frames.jsonl", 15));
	camera.set("plugged", "0");
	std::this_thread::sleep_for(700ms);
	camera.set("plugged", "1");
	const std::size_t lines = linesOf(readFile(out / "frames.jsonl")).size();
	EXPECT_TRUE(grows(out / "frames.jsonl", lines + 30));
	program.signal(SIGTERM);
	const ProgramResult result = program.wait();
	EXPECT_EQ(result.exit_code, 143);
	EXPECT_THAT(result.err, HasSubstr("delivers frames again"));
}

TEST(CameraPrograms, EndWithinASecondOfAnInterrupt)
{
	VirtualCamera camera;
	for (const bool away : {false, true})
	{
		const auto out = testFolder() / "out";
		camera.set("plugged", "1");
		Program program(EXPLORE_MRPT_PROGRAM, explored(out), {});
		ASSERT_TRUE(grows(out / "frames.jsonl", 15));
		if (away) camera.set("plugged", "0");
		program.signal(SIGINT);
		EXPECT_TRUE(waitsFor(program, 1000ms)) << away;
		EXPECT_EQ(program.wait().exit_code, 130);
		EXPECT_FALSE(frameLines(out).empty());
		EXPECT_EQ(summaryOf(out)["exploration"]["reason"], "interrupted");
		std::filesystem::remove_all(out);
	}
}

TEST(CameraPrograms, ARecordingAndItsRawlogAreTheSame)
{
	const VirtualCamera camera(160, 120, 40);
	const auto oni = (testFolder() / "camera.oni").string(), log = (testFolder() / "camera.rawlog").string();
	recordOni(oni, 30);
	const Arguments same{"--set", "camera.mount=ini", "--set", "camera.pose_z=0.5", "--quiet", "--out"};
	const auto from_oni = testFolder() / "oni", again = testFolder() / "again", from_log = testFolder() / "log";
	const auto explore = [&](const char* kind, const std::string& input, const std::filesystem::path& out)
	{
		Arguments arguments{kind, input};
		arguments.insert(arguments.end(), same.begin(), same.end());
		arguments.push_back(out.string());
		const ProgramResult result = exploreMrpt(arguments);
		EXPECT_EQ(result.exit_code, 0) << result.err;
		return readFile(out / "frames.jsonl");
	};
	const std::string frames = explore("--oni", oni, from_oni);
	EXPECT_GE(linesOf(frames).size(), 30U);
	EXPECT_EQ(summaryOf(from_oni)["source"]["kind"], "oni");
	EXPECT_EQ(explore("--oni", oni, again), frames);
	const ProgramResult recorded = exploreRawlog(
	    {"record", "--oni", oni, "--out", log, "--set", "camera.mount=ini", "--set", "camera.pose_z=0.5"});
	ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
	EXPECT_EQ(explore("--rawlog", log, from_log), frames);

	SourceConfig config;
	config.rawlog = log, config.oni = oni;
	mrpt::system::COutputLogger quiet;
	quiet.logging_enable_console_output = false;
	RawlogSource rawlog(config, quiet);
	openni2::OniSource recording(config, quiet);
	while (const auto frame = recording.next())
	{
		const auto kept = rawlog.next();
		ASSERT_TRUE(kept);
		EXPECT_EQ(kept->timestamp, frame->timestamp);
		EXPECT_EQ(kept->image.depth_m, frame->image.depth_m);
		EXPECT_EQ(kept->image.intrinsics, frame->image.intrinsics);
		EXPECT_GE(camera.imageOf(kept->image), 0);
		EXPECT_EQ(kept->robot_from_camera.z(), 0.5);
	}
	EXPECT_FALSE(rawlog.next());
}

TEST(CameraPrograms, RecordTheCamera)
{
	const VirtualCamera camera;
	const auto log = (testFolder() / "camera.rawlog").string();
	const ProgramResult list = exploreRawlog({"record", "--openni2", "list"});
	EXPECT_EQ(list.exit_code, 0) << list.err;
	EXPECT_THAT(list.out, HasSubstr("0: Virtual camera of Nobody, virtual/camera@1/1"));
	const ProgramResult result = exploreRawlog(
	    withCamera({"record", "--openni2", "V0042", "--out", log, "--seconds", "1", "--pose", "0.1,0,0.4,0,5,0"}));
	EXPECT_EQ(result.exit_code, 0) << result.err;
	SourceConfig config;
	config.rawlog = log;
	mrpt::system::COutputLogger quiet;
	quiet.logging_enable_console_output = false;
	RawlogSource source(config, quiet);
	int frames = 0;
	for (; const auto frame = source.next(); ++frames)
	{
		EXPECT_GE(camera.imageOf(frame->image), 0);
		EXPECT_EQ(frame->robot_from_camera.x(), 0.1);
	}
	EXPECT_GE(frames, 10);
	EXPECT_LE(frames, 31);
}

TEST(CameraPrograms, RecordColourWhenAsked)
{
	VirtualCamera camera(160, 120, 20);
	const auto oni = (testFolder() / "camera.oni").string(), log = (testFolder() / "camera.rawlog").string();
	recordOni(oni, 20, {.color = true});
	const Arguments asked{"--set", "openni2.color=true", "--out", log};
	Arguments of_file{"record", "--oni", oni}, of_camera = withCamera({"record", "--openni2", "--seconds", "1"});
	for (Arguments* arguments : {&of_file, &of_camera})
	{
		arguments->insert(arguments->end(), asked.begin(), asked.end());
		const ProgramResult result = exploreRawlog(*arguments);
		ASSERT_EQ(result.exit_code, 0) << result.err;
		mrpt::obs::CRawlog rawlog;
		ASSERT_TRUE(rawlog.loadFromRawLogFile(log));
		std::size_t frames = 0, with_color = 0;
		for (const auto& entry : rawlog)
		{
			const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(entry);
			ASSERT_TRUE(scan);
			++frames;
			if (!scan->hasIntensityImage) continue;
			++with_color;
			EXPECT_EQ(scan->intensityImageChannel, mrpt::obs::CObservation3DRangeScan::CH_VISIBLE);
			ASSERT_EQ(scan->intensityImage.getWidth(), 160U);
			ASSERT_EQ(scan->intensityImage.getHeight(), 120U);
			// Red to the left, green to the right, but for what compression does to them; OpenCV's order.
			EXPECT_GT(scan->intensityImage.at<std::uint8_t>(40, 60, 2), 180);
			EXPECT_GT(scan->intensityImage.at<std::uint8_t>(120, 60, 1), 180);
			const double blue = scan->intensityImage.at<std::uint8_t>(40, 60, 0);
			const auto depth =
			    std::ranges::find_if(camera.served().images, [&](const auto& image)
			                         { return std::equal(image.begin(), image.end(), scan->rangeImage.data()); });
			ASSERT_NE(depth, camera.served().images.end());
			const auto number = static_cast<double>(depth - camera.served().images.begin());
			EXPECT_LT(std::abs(std::remainder(number - imageOfBlue(blue, 20), 20.0)), 1.6);
		}
		EXPECT_GE(frames, 8U);
		EXPECT_GE(2 * with_color, frames);
		EXPECT_EQ(result.err.find("no colour image") != std::string::npos, with_color < frames) << result.err;
	}
	camera.set("color", "none");
	const ProgramResult refused = exploreRawlog(of_camera);
	EXPECT_EQ(refused.exit_code, 2);
	EXPECT_THAT(refused.err, HasSubstr("[openni2] color = true: the camera has no colour images"));
}

TEST(CameraPrograms, ExploreByDepthAloneAndSaySo)
{
	VirtualCamera camera;
	camera.set("color", "none");
	Arguments arguments = explored(testFolder() / "out");
	arguments.insert(arguments.end(), {"--max-frames", "3", "--set", "openni2.color=true"});
	const ProgramResult result = exploreMrpt(arguments);
	EXPECT_EQ(result.exit_code, 0) << result.err;
	EXPECT_THAT(result.err, HasSubstr("goes by depth alone"));
}

/** A minute in real time; what is asked for holds on a machine of any speed. */
TEST(CameraPrograms, AMinuteOfVgaAtThirtyHertz)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	GTEST_SKIP() << "a test of timing: not with a sanitizer";
#endif
	const VirtualCamera camera(640, 480, 30);
	const auto out = testFolder() / "out";
	Arguments arguments{"--out", out.string(), "--quiet"};
	for (const char* setting :
	     {"source.kind=openni2", "camera.mount=ini", "camera.pose_z=0.5", "output.pictures_every=0"})
		arguments.insert(arguments.end(), {"--set", setting});
	const double before = mrpt::Clock::nowDouble();
	Program program(EXPLORE_MRPT_PROGRAM, arguments, {});
	ASSERT_TRUE(grows(out / "frames.jsonl", 1));
	std::this_thread::sleep_for(60s);
	const double told_to_stop = mrpt::Clock::nowDouble();
	program.signal(SIGINT);
	const ProgramResult result = program.wait();
	EXPECT_EQ(result.exit_code, 130) << result.err;
	const double after = mrpt::Clock::nowDouble();

	const nlohmann::json source = summaryOf(out)["source"];
	const std::string figures = source.dump();
	EXPECT_LE(source["oldest_frame_ms"], 100.0) << figures;
	const auto frames = frameLines(out);
	ASSERT_FALSE(frames.empty());
	EXPECT_GE(frames.front()["t"], before);
	EXPECT_LE(frames.back()["t"], after);
	const std::size_t away = source["away_frames"], used = frames.size() - away, dropped = source["dropped_frames"];
	const std::size_t served = std::stoul(camera.left("served"));
	EXPECT_GE(served, 1700U) << "a minute of 30 Hz";
	EXPECT_GE(dropped, 10U) << "those that the mount was judged by";
	// All but what was on its way at the end, and what the camera served while the program wrote its results.
	const double unused = 5.0 + 30.0 * (after - told_to_stop);
	EXPECT_LE(used + dropped, served) << figures;
	EXPECT_GE(static_cast<double>(used + dropped) + unused, static_cast<double>(served)) << figures;
	EXPECT_LE(after - told_to_stop, 2.0);
	RecordProperty("used", static_cast<int>(used));
	RecordProperty("oldest_frame_ms", source["oldest_frame_ms"].dump());
	std::cout << used << " of " << served << " frames used, " << figures << '\n';
}

TEST(CameraPrograms, RecordUntilTheyAreInterrupted)
{
	const VirtualCamera camera;
	const auto log = testFolder() / "camera.rawlog";
	Program program(EXPLORE_RAWLOG_PROGRAM, withCamera({"record", "--openni2", "--out", log.string()}), {});
	const auto due = steady_clock::now() + 20s;
	const auto begun = [&] { return std::filesystem::exists(log); };
	while (!begun() && steady_clock::now() < due) std::this_thread::sleep_for(10ms);
	std::this_thread::sleep_for(500ms);
	program.signal(SIGINT);
	EXPECT_EQ(program.wait().exit_code, 130);
	const ProgramResult explored_log =
	    exploreMrpt({"--rawlog", log.string(), "--out", (testFolder() / "out").string(), "--quiet"});
	EXPECT_EQ(explored_log.exit_code, 0) << explored_log.err;
}

TEST(CameraPrograms, RefuseWhatIsNoRecording)
{
	const auto oni = (freshFolder() / "junk.oni").string(), out = (testFolder() / "out").string();
	writeFile(oni, std::string(5000, 'x'));
	const ProgramResult junk = exploreMrpt({"--oni", oni, "--out", out});
	EXPECT_EQ(junk.exit_code, 3);
	EXPECT_THAT(junk.err, HasSubstr("junk.oni: is no recording of OpenNI2"));
	EXPECT_EQ(exploreMrpt({"--oni", oni + "x", "--out", out}).exit_code, 3);
	EXPECT_EQ(exploreMrpt({"--oni", oni, "--rawlog", oni, "--out", out}).exit_code, 2);
	EXPECT_EQ(exploreMrpt({"--oni", oni, "--world", oni, "--out", out}).exit_code, 2);
	EXPECT_EQ(exploreRawlog({"record", "--oni", oni, "--out", out}).exit_code, 3);
	EXPECT_EQ(exploreRawlog({"record", "--oni", oni, "--openni2", "--out", out}).exit_code, 2);
	EXPECT_EQ(exploreRawlog({"record", "--openni2"}).exit_code, 2);
	EXPECT_EQ(exploreRawlog({"record", "--out", out}).exit_code, 2);
	EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(CameraPrograms, TellWhatIsWrongWithADamagedRecording)
{
	const VirtualCamera camera;
	const auto oni = testFolder() / "camera.oni", out = testFolder() / "out";
	recordOni(oni, 20);
	const std::string whole = readFile(oni);
	const std::size_t size = whole.rfind(std::string("NIR\0\x0b\0\0\0", 8));
	writeFile(oni, whole.substr(0, size * 2 / 3));
	const ProgramResult cut = exploreMrpt({"--oni", oni.string(), "--out", out.string()});
	EXPECT_EQ(cut.exit_code, 3);
	EXPECT_THAT(cut.err, HasSubstr("cut off at byte"));

	// In the middle of a frame's pixels, which begin 40 bytes after their record's magic.
	std::string holed = whole;
	const std::size_t frame = holed.find(std::string("NIR\0\x0a\0\0\0", 8), size / 2);
	holed.replace(frame + 1000, 300, 300, '\0');
	writeFile(oni, holed);
	const ProgramResult damaged = exploreMrpt({"--oni", oni.string(), "--out", out.string()});
	EXPECT_EQ(damaged.exit_code, 3);
	EXPECT_GE(frameLines(out).size(), 19U);
	EXPECT_THAT(summaryOf(out)["source"]["damage"].get<std::string>(), HasSubstr("1 frames cannot be used"));
}

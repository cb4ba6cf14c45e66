// explore-mrpt with a robot on the other side of its sockets.
#include "apps/program.h"
#include "apps/rawlog_maker.h"
#include "support/test_sockets.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

using namespace explore::test;
using namespace std::chrono_literals;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
constexpr double kStart_s = 1.5e9;  ///< of writeCorridorRawlog

/** Sends what `message` gives, every 10 ms, as long as it lives. */
class ChattyRobot
{
public:
	ChattyRobot(int port, std::function<std::string()> message)
	    : m_message(std::move(message)),
	      m_thread(
	          [this, port]
	          {
		          const TestSocket socket = udpSender(port);
		          while (!m_ends) socket.send(m_message()), std::this_thread::sleep_for(10ms);
	          })
	{
	}
	ChattyRobot(const ChattyRobot&) = delete;
	ChattyRobot& operator=(const ChattyRobot&) = delete;
	~ChattyRobot()
	{
		m_ends = true;
		m_thread.join();
	}

private:
	std::function<std::string()> m_message;
	std::atomic<bool> m_ends = false;
	std::thread m_thread;
};

std::string set(const std::string& key, const std::string& value)
{
	return "robot_link." + key + "=" + value;
}

std::vector<json> jsonLines(const std::string& text)
{
	std::vector<json> lines;
	for (const auto& line : linesOf(text)) lines.push_back(json::parse(line));
	return lines;
}

std::vector<json> commandsOf(const std::vector<Received>& received)
{
	std::vector<json> commands;
	for (const Received& one : received) commands.push_back(json::parse(one.text));
	return commands;
}

/** Numbered one after the other, moving at some time, and the last three words are stops at zero. */
void expectDriveThatEndsInStop(const std::vector<json>& commands)
{
	ASSERT_GE(commands.size(), 5U);
	bool moved = false;
	for (std::size_t i = 0; i < commands.size(); ++i)
	{
		EXPECT_EQ(commands[i]["seq"], i);
		if (!commands[i]["stop"].get<bool>()) moved = true;
	}
	EXPECT_TRUE(moved) << "never told to move";
	for (std::size_t i = commands.size() - 3; i < commands.size(); ++i)
	{
		EXPECT_TRUE(commands[i]["stop"].get<bool>());
		EXPECT_EQ(commands[i]["v"], (json{0.0, 0.0, 0.0}));
		EXPECT_EQ(commands[i]["yaw_rate"], 0.0);
	}
}

struct RobotLinkRun : testing::Test
{
	explicit RobotLinkRun(std::size_t frames = 12) : folder(freshFolder())
	{
		writeCorridorRawlog(folder / "log.rawlog", {frames});
	}
	/** Arguments of a run with these keys of [robot_link]; at the camera's pace. */
	[[nodiscard]] std::vector<std::string> arguments(const std::vector<std::string>& keys) const
	{
		std::vector<std::string> result{"--rawlog", (folder / "log.rawlog").string(), "--out", (folder / "o").string(),
		                                "--realtime"};
		for (const std::string& key : keys) result.insert(result.end(), {"--set", key});
		return result;
	}
	[[nodiscard]] std::vector<json> frames() const { return jsonLines(readFile(folder / "o" / "frames.jsonl")); }

	fs::path folder;
};

struct LongRobotLinkRun : RobotLinkRun
{
	LongRobotLinkRun() : RobotLinkRun(100) {}
};
}  // namespace

TEST_F(RobotLinkRun, CommandsGoOverUdpAndEndInStop)
{
	const UdpReceiver robot;
	Program program(EXPLORE_MRPT_PROGRAM, arguments({set("commands", robot.uri()), set("watchdog", "2")}), {});
	const auto received = robot.all(3000);
	const auto result = program.wait();
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const auto commands = commandsOf(received);
	expectDriveThatEndsInStop(commands);
	EXPECT_GE(commands.size(), 20U) << "1.1 s at 20 Hz and the last words";
	// What was commanded is what the frames say.
	const auto frames = this->frames();
	for (const json& command : commands)
		for (const json& frame : frames)
			if (!command["stop"].get<bool>() && frame["t"] == command["t"])
			{
				EXPECT_EQ(command["v"], frame["command"]["v"]);
				EXPECT_EQ(command["yaw_rate"], frame["command"]["yaw_rate"]);
			}
}

TEST_F(RobotLinkRun, CommandsGoToAUnixStream)
{
	const TestSocket server = unixServer(folder / "r.sock");
	Program program(EXPLORE_MRPT_PROGRAM,
	                arguments({set("commands", "unix://" + (folder / "r.sock").string()), set("watchdog", "2")}), {});
	ASSERT_TRUE(server.readable(20'000));
	const TestSocket robot = accepted(server);
	std::string text;
	for (std::string part = robot.receive(); !part.empty(); part = robot.receive()) text += part;
	EXPECT_EQ(program.wait().exit_code, 0);
	expectDriveThatEndsInStop(jsonLines(text));
}

TEST_F(RobotLinkRun, AUnixReceiverThatIsNotThereEndsTheRunAtItsStart)
{
	const auto result = exploreMrpt(arguments({set("commands", "unix://" + (folder / "r.sock").string())}));
	EXPECT_EQ(result.exit_code, 5);
	EXPECT_THAT(result.err, AllOf(HasSubstr("r.sock"), HasSubstr("No such file")));
	EXPECT_FALSE(fs::exists(folder / "o"));
}

TEST_F(LongRobotLinkRun, AUnixReceiverThatLeavesEndsTheRun)
{
	const TestSocket server = unixServer(folder / "r.sock");
	Program program(EXPLORE_MRPT_PROGRAM, arguments({set("commands", "unix://" + (folder / "r.sock").string())}), {});
	ASSERT_TRUE(server.readable(20'000));
	{
		const TestSocket robot = accepted(server);
	}
	const auto result = program.wait();
	EXPECT_EQ(result.exit_code, 5);
	EXPECT_THAT(result.err, HasSubstr("commands cannot be delivered"));
}

TEST_F(RobotLinkRun, CommandsOnStandardOutputAreAlone)
{
	const auto result = exploreMrpt(arguments({set("commands", "stdout"), set("watchdog", "2")}));
	ASSERT_EQ(result.exit_code, 0) << result.err;
	expectDriveThatEndsInStop(jsonLines(result.out));
	EXPECT_THAT(result.err, HasSubstr("12 frames")) << "the summary goes where it does not disturb";
}

TEST_F(RobotLinkRun, CommandsAndFramesCannotShareStandardOutput)
{
	const auto result =
	    exploreMrpt({"--rawlog", (folder / "log.rawlog").string(), "--out", "-", "--set", set("commands", "stdout")});
	EXPECT_EQ(result.exit_code, 2);
	EXPECT_EQ(result.out, "");
	EXPECT_THAT(result.err, AllOf(HasSubstr("[robot_link] commands = stdout"), HasSubstr("--out -")));
}

TEST_F(RobotLinkRun, AWrongAddressIsAUsageError)
{
	for (const char* text : {"udp://robot", "tcp://a:1"})
	{
		const auto result = exploreMrpt(arguments({set("commands", text)}));
		EXPECT_EQ(result.exit_code, 2);
		EXPECT_THAT(result.err, HasSubstr(text));
	}
}

TEST_F(LongRobotLinkRun, TheLastWordAfterAnInterruptIsStop)
{
	const UdpReceiver robot;
	Program program(EXPLORE_MRPT_PROGRAM, arguments({set("commands", robot.uri()), set("watchdog", "2")}), {});
	std::vector<Received> received;
	for (bool moved = false; !moved && robot.socket().readable(20'000);)
	{
		received.push_back({SteadyClock::now(), robot.socket().receive()});
		moved = !json::parse(received.back().text)["stop"].get<bool>();
	}
	program.signal(SIGINT);
	for (const Received& late : robot.all(3000)) received.push_back(late);
	const auto result = program.wait();
	EXPECT_EQ(result.exit_code, 130);
	expectDriveThatEndsInStop(commandsOf(received));
	EXPECT_LT(frames().size(), 100U);
}

TEST_F(LongRobotLinkRun, AStallOfTheExplorerStopsTheRobot)
{
	// A gap of 2 s in the recording, which the run keeps after it has decided on frame 11.
	writeCorridorRawlog(folder / "log.rawlog", {14, [](std::size_t i, auto& scan)
	                                            {
		                                            if (i > 10) scan.timestamp += 2s;
	                                            }});
	const UdpReceiver robot;
	Program program(EXPLORE_MRPT_PROGRAM, arguments({set("commands", robot.uri()), set("watchdog", "0.5")}), {});
	const auto commands = commandsOf(robot.all(5000));
	const auto result = program.wait();
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const json before_gap = frames().at(11);
	ASSERT_FALSE(before_gap["stop"].get<bool>());
	bool moved = false, stopped = false;
	for (const json& command : commands)
		if (command["t"] == before_gap["t"]) (command["stop"].get<bool>() ? stopped : moved) = true;
	EXPECT_TRUE(moved);
	EXPECT_TRUE(stopped) << "the watchdog is missing";
	EXPECT_THAT(result.err, HasSubstr("no new decision for 0.5 s"));
	EXPECT_THAT(readFile(folder / "o" / "summary.json"), HasSubstr("no new decision for 0.5 s"));
}

TEST_F(LongRobotLinkRun, ABumperStopsTheRobotUntilItIsReleased)
{
	const UdpReceiver robot;
	const int port = freePort();
	std::atomic<bool> pressed = true;
	const ChattyRobot bumper(
	    port, [&] { return std::string(R"({"bumper":{"pressed":)") + (pressed ? "true}}" : "false}}"); });
	auto asked = arguments(
	    {set("commands", robot.uri()), set("watchdog", "2"), set("listen", "udp://127.0.0.1:" + std::to_string(port))});
	asked.insert(asked.end(), {"--max-frames", "30"});
	Program program(EXPLORE_MRPT_PROGRAM, asked, {});
	// Heard from the beginning, but for the first moment; released when 0.75 s of the log have passed.
	std::vector<json> commands;
	while (robot.socket().readable(3000))
	{
		commands.push_back(json::parse(robot.socket().receive()));
		if (commands.back()["t"].is_number() && commands.back()["t"].get<double>() > kStart_s + 0.75) pressed = false;
	}
	ASSERT_EQ(program.wait().exit_code, 0);
	const auto frames = this->frames();
	ASSERT_EQ(frames.size(), 30U);
	for (std::size_t i = 5; i <= 7; ++i)
	{
		EXPECT_EQ(frames[i]["stop_reason"], "bumper") << i;
		EXPECT_TRUE(frames[i]["headings"]["chosen"].is_null());
		EXPECT_EQ(frames[i]["command"]["v"], (json{0.0, 0.0, 0.0}));
	}
	EXPECT_NE(frames[29]["stop_reason"], "bumper") << "released";
	std::size_t stops = 0;
	for (const json& command : commands)
	{
		if (command["t"].is_null()) continue;
		const double after_s = command["t"].get<double>() - kStart_s;
		if (after_s < 0.45 || after_s > 0.65) continue;
		++stops;
		EXPECT_TRUE(command["stop"].get<bool>());
	}
	EXPECT_GT(stops, 0U);
	const auto moves_later = [](const json& command) {
		return command["t"].is_number() && command["t"].get<double>() > kStart_s + 0.75 && !command["stop"].get<bool>();
	};
	EXPECT_TRUE(std::ranges::any_of(commands, moves_later)) << "released";
}

TEST_F(RobotLinkRun, ACliffStopsTheRobot)
{
	const int port = freePort();
	const ChattyRobot cliff(port, [] { return std::string(R"({"cliff":{"seen":true}})"); });
	const auto result = exploreMrpt(arguments({set("listen", "udp://127.0.0.1:" + std::to_string(port))}));
	ASSERT_EQ(result.exit_code, 0) << result.err;
	EXPECT_EQ(frames().at(11)["stop_reason"], "cliff");
}

TEST_F(RobotLinkRun, PosesOfTheRobotAreInTheFrames)
{
	const int port = freePort();
	// The robot is at x = 20 m + 0.3 m/s and tells it for all of the log, again and again.
	std::atomic<int> count = 0;
	const ChattyRobot robot(port,
	                        [&]
	                        {
		                        const double after_s = 0.05 * (count++ % 30) - 0.05;
		                        char text[200];
		                        std::snprintf(text, sizeof(text), R"({"pose":{"t":%.3f,"x":%.4f,"y":-3,"yaw":0.2}})",
		                                      kStart_s + after_s, 20.0 + 0.3 * after_s);
		                        return std::string(text);
	                        });
	const auto result = exploreMrpt(arguments({set("listen", "udp://127.0.0.1:" + std::to_string(port))}));
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const auto frames = this->frames();
	ASSERT_EQ(frames.size(), 12U);
	for (std::size_t i = 9; i < 12; ++i)
	{
		EXPECT_EQ(frames[i]["pose"]["from"], "robot_link");
		EXPECT_NEAR(frames[i]["pose"]["x"].get<double>(), 20.0 + 0.03 * static_cast<double>(i), 1e-3);
		EXPECT_NEAR(frames[i]["pose"]["y"].get<double>(), -3.0, 1e-9);
		EXPECT_NEAR(frames[i]["pose"]["yaw"].get<double>(), 0.2, 1e-9);
	}
	EXPECT_EQ(json::parse(readFile(folder / "o" / "summary.json"))["source"]["pose_from"], "robot_link");
}

TEST_F(RobotLinkRun, RandomBytesAreRemarkedOnceAndChangeNothing)
{
	ASSERT_EQ(
	    exploreMrpt({"--rawlog", (folder / "log.rawlog").string(), "--out", (folder / "plain").string()}).exit_code, 0);
	const int port = freePort();
	std::mt19937 random(3);
	const ChattyRobot noise(port,
	                        [&]
	                        {
		                        std::string text;
		                        for (std::size_t n = random() % 300; n > 0; --n) text += static_cast<char>(random());
		                        return text;
	                        });
	const auto result = exploreMrpt(arguments({set("listen", "udp://127.0.0.1:" + std::to_string(port))}));
	ASSERT_EQ(result.exit_code, 0) << result.err;
	EXPECT_EQ(readFile(folder / "o" / "frames.jsonl"), readFile(folder / "plain" / "frames.jsonl"));
	const std::size_t first = result.err.find("not a message");
	EXPECT_NE(first, std::string::npos);
	EXPECT_EQ(first, result.err.rfind("not a message"));
	EXPECT_THAT(result.err, HasSubstr("messages were malformed"));
}

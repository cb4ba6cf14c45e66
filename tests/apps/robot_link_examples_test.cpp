// The clients that doc/robot-link.md shows, against the program, on the bundled recording of a corridor.
#include "apps/program.h"
#include "support/test_sockets.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

using namespace explore::test;
using nlohmann::json;
using testing::HasSubstr;

namespace
{
/** Whether somebody receives datagrams at the port; asked without touching it. */
bool isTaken(int port)
{
	char local[8];
	std::snprintf(local, sizeof(local), ":%04X ", static_cast<unsigned>(port));
	return readFile("/proc/net/udp").find(std::string("0100007F") + local) != std::string::npos;
}

/** Runs the client beside explore-mrpt; what the client prints in the end. */
std::string printedBy(const std::string& program, std::vector<std::string> arguments)
{
	const auto folder = freshFolder();
	const int commands = freePort(), listen = freePort();
	arguments.insert(arguments.end(), {std::to_string(commands), std::to_string(listen)});
	const auto printed = folder / "client.txt";
	Program client(program, arguments, {printed.string(), 0, {}});
	while (client.running() && !isTaken(commands)) std::this_thread::sleep_for(std::chrono::milliseconds(50));
	const auto result = exploreMrpt({"--ini", "corridor.ini", "--rawlog", EXPLORE_SOURCE_DIR "/rawlogs/corridor.rawlog",
	                                 "--realtime", "--max-frames", "20", "--out", (folder / "o").string(), "--set",
	                                 "robot_link.commands=udp://127.0.0.1:" + std::to_string(commands), "--set",
	                                 "robot_link.listen=udp://127.0.0.1:" + std::to_string(listen), "--set",
	                                 "robot_link.watchdog=2", "--set", "memory.enabled=false"});
	EXPECT_EQ(result.exit_code, 0) << result.err;
	EXPECT_EQ(client.wait().exit_code, 0);
	const auto lines = linesOf(readFile(folder / "o" / "frames.jsonl"));
	EXPECT_EQ(lines.size(), 20U);
	const auto is_told = [](const std::string& line) { return json::parse(line)["pose"]["from"] == "robot_link"; };
	EXPECT_GT(std::ranges::count_if(lines, is_told), 0) << "its poses do not arrive";
	return readFile(printed);
}

void expectADrive(const std::string& printed)
{
	int count = 0;
	double distance_m = 0, turned_rad = 0;
	ASSERT_EQ(std::sscanf(printed.c_str(), "%d commands, %lf m, %lf rad", &count, &distance_m, &turned_rad), 3)
	    << printed;
	EXPECT_GE(count, 20);
	EXPECT_GT(distance_m, 0.0);
	EXPECT_GT(turned_rad, 0.0);
	EXPECT_THAT(printed, HasSubstr("the last one stop"));
}
}  // namespace

TEST(RobotLinkExamples, TheClientInCppDrives)
{
	expectADrive(printedBy(EXPLORE_ROBOT_CLIENT, {}));
}

TEST(RobotLinkExamples, TheClientInPythonDrives)
{
	if (std::system("python3 -c 'import json, socket' > /dev/null 2>&1") != 0)
		GTEST_SKIP() << "python3 is not installed: the example in Python is not run";
	expectADrive(printedBy("/usr/bin/env", {"python3", EXPLORE_SOURCE_DIR "/doc/examples/robot_client.py"}));
}

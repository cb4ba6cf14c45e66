// explore-mrpt --resume: a run that was killed goes on and leaves what it would have left.
#include "apps/program.h"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

using namespace explore::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
using Arguments = std::vector<std::string>;

const Arguments kSimulated{"--ini",
                           "corridor.ini",
                           "--world",
                           "corridor.sdf",
                           "--max-frames",
                           "90",
                           "--quiet",
                           "--set",
                           "output.checkpoint_period=0.05",
                           "--set",
                           "simulator.pose=odometry"};
const Arguments kRecorded{"--ini",
                          "office.ini",
                          "--set",
                          "source.rawlog=office.rawlog",
                          "--quiet",
                          "--set",
                          "output.checkpoint_period=0.05",
                          "--set",
                          "output.annotated=true"};

Arguments into(Arguments arguments, const fs::path& out)
{
	arguments.insert(arguments.end(), {"--out", out.string()});
	return arguments;
}

std::size_t framesIn(const fs::path& out)
{
	return linesOf(readFile(out / "frames.jsonl")).size();
}

/** Waits until the run has so many frames and a state, and kills it; false where it ended before. */
bool killAfter(Program& program, const fs::path& out, std::size_t frames)
{
	while (program.running() && (framesIn(out) < frames || !fs::exists(out / "state" / "checkpoint")))
		std::this_thread::sleep_for(std::chrono::milliseconds(2));
	program.signal(SIGKILL);
	return program.wait().exit_code == 128 + SIGKILL;
}

/** Without what the clock says. */
json summaryIn(const fs::path& out)
{
	json summary = json::parse(readFile(out / "summary.json"));
	summary.erase("timing_ms");
	summary.erase("peak_rss_mb");
	summary.erase("processor");
	return summary;
}

/** Without what the clock says. */
std::string reportIn(const fs::path& out)
{
	std::string page = readFile(out / "report.html");
	const auto from = page.find("<noscript>"), to = page.find("id=\"run\">");
	EXPECT_NE(to, std::string::npos) << out;
	return to == std::string::npos ? "" : page.erase(from, to - from);
}

void expectSameResults(const fs::path& a, const fs::path& b)
{
	for (const char* name : {"frames.jsonl", "trajectory.tum", "truth.tum", "map.ot", "map.bt", "map.pgm", "map.yaml",
	                         "scene.3Dscene", "annotated.rawlog"})
		EXPECT_TRUE(readFile(a / name) == readFile(b / name)) << name;
	EXPECT_EQ(linesOf(readFile(a / "timing.csv")).size(), linesOf(readFile(b / "timing.csv")).size());
	EXPECT_EQ(summaryIn(a), summaryIn(b));
	EXPECT_TRUE(reportIn(a) == reportIn(b));
}

void killTwiceAndGoOn(const Arguments& arguments, std::size_t first, std::size_t second)
{
	const fs::path folder = freshFolder(), whole = folder / "whole", killed = folder / "killed";
	ASSERT_EQ(exploreMrpt(into(arguments, whole)).exit_code, 0);
	Program begun(EXPLORE_MRPT_PROGRAM, into(arguments, killed), {});
	ASSERT_TRUE(killAfter(begun, killed, first));
	ASSERT_FALSE(fs::exists(killed / "summary.json"));
	Program once(EXPLORE_MRPT_PROGRAM, {"--resume", killed.string(), "--quiet"}, {});
	ASSERT_TRUE(killAfter(once, killed, second));
	const auto twice = exploreMrpt({"--resume", killed.string(), "--quiet"});
	ASSERT_EQ(twice.exit_code, 0) << twice.err;
	expectSameResults(killed, whole);
}

/** A short run that could go on. */
fs::path interrupted()
{
	const fs::path out = freshFolder() / "o";
	EXPECT_EQ(exploreMrpt({"--ini", "corridor.ini", "--max-frames", "3", "--quiet", "--out", out.string()}).exit_code,
	          0);
	return out;
}

void expectRefused(const fs::path& out, const std::string& why)
{
	const auto result = exploreMrpt({"--resume", out.string()});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.err, AllOf(HasSubstr("checkpoint"), HasSubstr(why)));
}
}  // namespace

TEST(Resume, ASimulatedRunThatWasKilledTwiceLeavesTheSame)
{
	killTwiceAndGoOn(kSimulated, 20, 50);
}

TEST(Resume, ARecordingGoesOnWhereItWasLeft)
{
	killTwiceAndGoOn(kRecorded, 8, 16);
}

TEST(Resume, MoreFramesMayBeAskedForThanAtFirst)
{
	const fs::path folder = freshFolder();
	const Arguments common{"--ini", "corridor.ini", "--quiet", "--max-frames"};
	const auto run = [&](const std::string& frames, const std::string& name)
	{
		Arguments arguments = common;
		arguments.push_back(frames);
		return exploreMrpt(into(arguments, folder / name)).exit_code;
	};
	ASSERT_EQ(run("4", "a"), 0);
	ASSERT_EQ(run("9", "b"), 0);
	ASSERT_EQ(exploreMrpt({"--resume", (folder / "a").string(), "--max-frames", "9", "--quiet"}).exit_code, 0);
	expectSameResults(folder / "a", folder / "b");
}

TEST(Resume, WorksFromAnotherFolder)
{
	const fs::path folder = freshFolder();
	const Program::Setup there{{}, 0, folder};
	ASSERT_EQ(exploreMrpt({"--ini", "corridor.ini", "--max-frames", "3", "--out", "run", "--quiet"}, there).exit_code,
	          0);
	const auto result = exploreMrpt({"--resume", (folder / "run").string(), "--max-frames", "5"});
	EXPECT_EQ(result.exit_code, 0) << result.err;
	EXPECT_EQ(framesIn(folder / "run"), 5U);
}

TEST(Resume, ARunThatIsOverSaysSo)
{
	const fs::path out = freshFolder() / "o";
	ASSERT_EQ(
	    exploreMrpt({"--ini", "office.ini", "--set", "source.rawlog=office.rawlog", "--quiet", "--out", out.string()})
	        .exit_code,
	    0);
	const std::string before = readFile(out / "summary.json");
	const auto result = exploreMrpt({"--resume", out.string()});
	EXPECT_EQ(result.exit_code, 0);
	EXPECT_THAT(result.out, AllOf(HasSubstr("over already"), HasSubstr("log ended")));
	EXPECT_EQ(readFile(out / "summary.json"), before);
}

TEST(Resume, WhatIsNoStateIsRefusedWithAReason)
{
	expectRefused(freshFolder(), "no state of a run");
	const fs::path out = interrupted(), file = out / "state" / "checkpoint";
	const std::string bytes = readFile(file);
	const auto with = [&](std::string changed, const std::string& why)
	{
		writeFile(file, changed);
		expectRefused(out, why);
	};
	with(bytes.substr(0, bytes.size() / 2), "cut off");
	with(bytes.substr(0, bytes.find('\n') + 5), "cut off");
	with("", "is not the state of a run");
	std::string damaged = bytes;
	damaged[bytes.size() - 100] = static_cast<char>(damaged[bytes.size() - 100] ^ 4);
	with(damaged, "checksum");
	with(bytes.substr(0, bytes.find(" of version ")) + " of version 0.0.0" + bytes.substr(bytes.find('\n')),
	     "another version");
	writeFile(file, bytes);
	EXPECT_EQ(exploreMrpt({"--resume", out.string(), "--quiet"}).exit_code, 0) << "undamaged it is accepted";
}

TEST(Resume, FilesThatAreShorterThanTheStateSaysAreRefused)
{
	const fs::path out = interrupted();
	fs::resize_file(out / "frames.jsonl", 10);
	const auto result = exploreMrpt({"--resume", out.string()});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.err, HasSubstr("frames.jsonl: cannot be continued"));
}

TEST(Resume, TakesNothingThatWouldChangeTheRun)
{
	for (const Arguments& other : {Arguments{"--ini", "office.ini"}, Arguments{"--set", "perception.seed=2"},
	                               Arguments{"--seed", "2"}, Arguments{"--out", "x"}, Arguments{"--robot", "mav"}})
	{
		Arguments arguments{"--resume", "x"};
		arguments.insert(arguments.end(), other.begin(), other.end());
		const auto result = exploreMrpt(arguments);
		EXPECT_EQ(result.exit_code, 2) << other.front();
		EXPECT_THAT(result.err, AllOf(HasSubstr("--resume"), HasSubstr(other.front())));
	}
}

TEST(Resume, NoStateIsKeptWhereNoneIsWanted)
{
	const fs::path out = freshFolder() / "o";
	ASSERT_EQ(exploreMrpt({"--ini", "corridor.ini", "--max-frames", "2", "--quiet", "--out", out.string(), "--set",
	                       "output.checkpoint_period=0"})
	              .exit_code,
	          0);
	EXPECT_FALSE(fs::exists(out / "state"));
}

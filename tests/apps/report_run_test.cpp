// report.html as runs leave it: with every end of a run, and the same after --resume.
#include "apps/program.h"
#include "apps/rawlog_maker.h"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

using namespace explore::test;
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
json dataOf(const std::string& page, const std::string& id)
{
	const std::string begin = "id=\"" + id + "\">";
	const auto from = page.find(begin);
	if (from == std::string::npos) return {};
	return json::parse(page.substr(from + begin.size(), page.find("</script>", from) - from - begin.size()));
}

/** Without what the clock says. */
std::string timelessPage(const fs::path& out)
{
	std::string page = readFile(out / "report.html");
	const auto from = page.find("<noscript>"), to = page.find("<script type=\"application/json\" id=\"run\">");
	EXPECT_NE(to, std::string::npos) << out;
	return to == std::string::npos ? "" : page.erase(from, to - from);
}
}  // namespace

TEST(ReportRun, IsWrittenWithEveryRun)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {6});
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", out)).exit_code, 0);
	const std::string page = readFile(out / "report.html");
	EXPECT_EQ(dataOf(page, "summary"), json::parse(readFile(out / "summary.json")));
	EXPECT_EQ(dataOf(page, "run")["cameras"].size(), 6U);
	EXPECT_EQ(dataOf(page, "timing")["stages"]["total"]["median"].size(), 6U);
	EXPECT_FALSE(fs::exists(out / "state" / "report")) << "the run is over";
}

TEST(ReportRun, CanBeSwitchedOffAndAnOldOneIsRemoved)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {2});
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", out)).exit_code, 0);
	ASSERT_TRUE(fs::exists(out / "report.html"));
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", out, {"--set", "output.report=false"})).exit_code, 0);
	EXPECT_FALSE(fs::exists(out / "report.html"));
	EXPECT_FALSE(fs::exists(out / "state" / "report"));
}

TEST(ReportRun, NothingOfItStaysWithoutACheckpoint)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {4});
	ASSERT_EQ(
	    exploreMrpt(runOf(folder / "log.rawlog", out, {"--max-frames", "2", "--set", "output.checkpoint_period=0"}))
	        .exit_code,
	    0);
	EXPECT_TRUE(fs::exists(out / "report.html"));
	EXPECT_FALSE(fs::exists(out / "state"));
}

TEST(ReportRun, OfDamagedInputHasWhatCameBefore)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {10});
	fs::resize_file(folder / "log.rawlog", fs::file_size(folder / "log.rawlog") / 2);
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", out)).exit_code, 3);
	const std::string page = readFile(out / "report.html");
	const json summary = dataOf(page, "summary");
	EXPECT_FALSE(summary["source"]["damage"].is_null());
	EXPECT_GT(summary["source"]["frames"], 0);
	EXPECT_EQ(dataOf(page, "run")["cameras"].size(), summary["source"]["frames"]);
}

TEST(ReportRun, OfAnInterruptedRunHasWhatCameBefore)
{
	const fs::path out = freshFolder() / "o";
	Program program(EXPLORE_MRPT_PROGRAM, {"--ini", "corridor.ini", "--quiet", "--out", out.string()}, {});
	while (program.running() && linesOf(readFile(out / "frames.jsonl")).size() < 5)
		std::this_thread::sleep_for(std::chrono::milliseconds(5));
	program.signal(SIGINT);
	ASSERT_EQ(program.wait().exit_code, 128 + SIGINT);
	const std::string page = readFile(out / "report.html");
	const json summary = dataOf(page, "summary");
	EXPECT_EQ(summary["exploration"]["reason"], "interrupted");
	EXPECT_GE(summary["source"]["frames"], 5);
	EXPECT_EQ(dataOf(page, "run")["cameras"].size(), summary["source"]["frames"]);
	EXPECT_FALSE(dataOf(page, "run")["plans"].empty());
}

TEST(ReportRun, OfARunThatGoesOnCoversAllOfIt)
{
	const fs::path folder = freshFolder(), log = folder / "log.rawlog";
	writeCorridorRawlog(log, {16});
	ASSERT_EQ(exploreMrpt(runOf(log, folder / "whole")).exit_code, 0);
	ASSERT_EQ(exploreMrpt(runOf(log, folder / "parts", {"--max-frames", "7"})).exit_code, 0);
	EXPECT_EQ(dataOf(readFile(folder / "parts" / "report.html"), "run")["cameras"].size(), 7U);
	EXPECT_TRUE(fs::exists(folder / "parts" / "state" / "report"));
	ASSERT_EQ(exploreMrpt({"--resume", (folder / "parts").string(), "--max-frames", "11", "--quiet"}).exit_code, 0);
	ASSERT_EQ(exploreMrpt({"--resume", (folder / "parts").string(), "--max-frames", "100", "--quiet"}).exit_code, 0);
	EXPECT_TRUE(timelessPage(folder / "parts") == timelessPage(folder / "whole"));
	EXPECT_FALSE(fs::exists(folder / "parts" / "state" / "report"));
}

TEST(ReportRun, AFullDiskIsNoticedAndTheLinesAreWhole)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {12});
	Program::Setup setup;
	setup.file_size_limit = 8000;
	const auto result = exploreMrpt(runOf(folder / "log.rawlog", out), setup);
	EXPECT_EQ(result.exit_code, 5);
	EXPECT_THAT(result.err, HasSubstr("report"));
	const std::string frames = readFile(out / "frames.jsonl");
	EXPECT_EQ(frames.back(), '\n');
	EXPECT_FALSE(fs::exists(out / "report.html"));
	EXPECT_FALSE(fs::exists(out / "report.html.part"));
	EXPECT_THAT(json::parse(readFile(out / "summary.json"))["exploration"]["reason"].get<std::string>(),
	            HasSubstr("report"));
}

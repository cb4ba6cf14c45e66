#include "apps/eval_fixture.h"
#include "apps/rawlog_maker.h"

#include <explore/evaluation/eval_file.h>
#include <explore/evaluation/truth_file.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace explore;
using test::exploreEval;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace
{
/** Two families with doors, one without; the second has a door that the truth does not know and one too narrow. */
std::vector<std::string> threeLogs(const fs::path& folder)
{
	const auto frontal = test::headOf("frontal", "single wall single door");
	const auto mixed = test::headOf("mixed", "single wall multiple doors");
	const auto plain = test::headOf("plain", "", true);
	return {test::writeScoredLog(folder, "frontal", {{2.6}, {3.0, 0.4}, {2.3, -0.3, 1.1}}, frontal).string(),
	        test::writeScoredLog(folder, "mixed", {{2.6}, {2.6, 0, 0.95, false}, {2.5, 0, 0.72}}, mixed).string(),
	        test::writeScoredLog(folder, "plain", {{2.6, 0, 0}, {2.2, 0, 0}, {2.6, 0.2, 1.0, false}}, plain).string()};
}

Json readResults(const fs::path& out)
{
	return Json::parse(test::readFile(out / "eval.json"));
}

const Json& groupNamed(const Json& groups, const std::string& name)
{
	const auto found = std::ranges::find_if(groups, [&](const Json& group) { return group["name"] == name; });
	EXPECT_NE(found, groups.end()) << name;
	return *found;
}

void expectSameFolder(const fs::path& a, const fs::path& b)
{
	std::vector<std::string> files;
	for (const fs::path& folder : {a, b})
		for (const auto& entry : fs::recursive_directory_iterator(folder))
			if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder).string());
	EXPECT_GE(files.size(), 10U);
	for (const std::string& file : files)
		EXPECT_TRUE(test::readFile(a / file) == test::readFile(b / file)) << file << " differs";
}
}  // namespace

TEST(Eval, ScoresDoorsAgainstTheTruth)
{
	const auto folder = test::freshFolder();
	const auto logs = threeLogs(folder);
	const auto result = exploreEval({logs[0], logs[1], logs[2], "--out", (folder / "out").string(), "--quiet"});
	EXPECT_EQ(result.exit_code, 0) << result.err;
	EXPECT_EQ(result.err, "");
	EXPECT_EQ(result.out, test::readFile(folder / "out" / "table.txt"));
	EXPECT_LT(result.out.find("single wall single door"), result.out.find("single wall multiple doors"));

	const Json results = readResults(folder / "out")["results"];
	const Json& frontal = groupNamed(results["families"], "frontal")["figures"];
	EXPECT_EQ(frontal["doors"][1]["hits"], 3);
	EXPECT_EQ(frontal["doors"][1]["precision"]["value"], 1.0);
	EXPECT_NEAR(frontal["doors"][1]["precision"]["low"].get<double>(), std::pow(0.025, 1.0 / 3.0), 1e-12);
	EXPECT_LT(frontal["center_error"]["p99"], 0.1);

	// mixed: found; found though unknown to the truth; too narrow for the method.
	const Json& mixed = groupNamed(results["families"], "mixed")["figures"];
	EXPECT_EQ(mixed["doors"][1]["hits"], 1);
	EXPECT_EQ(mixed["doors"][1]["false_alarms"], 1);
	EXPECT_EQ(mixed["doors"][1]["misses"], 1);
	EXPECT_EQ(mixed["miss_causes"], Json({{"size_limit", 1}}));
	EXPECT_EQ(mixed["false_alarm_causes"], Json({{"evidence_wrong", 1}}));
	EXPECT_EQ(mixed["confusion"]["open"], Json({{"open", 1}, {"none", 1}}));
	EXPECT_EQ(mixed["confusion"]["none"], Json({{"open", 1}}));

	const Json& plain = groupNamed(results["families"], "plain")["figures"];
	EXPECT_EQ(plain["false_alarm_frames"]["good"], 1);
	EXPECT_EQ(plain["false_alarm_frames"]["all"], 3);
	EXPECT_EQ(results["positives"]["doors"][1]["hits"], 4);
	EXPECT_EQ(results["negatives"]["doors"][1]["false_alarms"], 1);
	EXPECT_EQ(groupNamed(results["configurations"], "all of them")["figures"]["doors"][1]["hits"], 4);
}

TEST(Eval, EveryFrameAndDoorHasItsLine)
{
	const auto folder = test::freshFolder();
	const auto logs = threeLogs(folder);
	ASSERT_EQ(exploreEval({logs[0], logs[1], "--out", (folder / "out").string(), "--quiet"}).exit_code, 0);
	const auto frames = test::linesOf(test::readFile(folder / "out" / "frames.csv"));
	ASSERT_EQ(frames.size(), 7U);
	for (const std::string& line : frames)
		EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(frames[0], ',')) << line;
	EXPECT_THAT(frames[5], HasSubstr("false_alarm:evidence_wrong"));

	const auto doors = test::linesOf(test::readFile(folder / "out" / "doors.csv"));
	ASSERT_EQ(doors.size(), 7U);
	for (const std::string& line : doors)
		EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(doors[0], ',')) << line;
	EXPECT_THAT(doors[4], HasSubstr(",0,0,hit,,door,2.6,0,0.95,0.95,open,1,visible,1,2.5,0,"));
	EXPECT_THAT(doors[5], HasSubstr(",1,1,false_alarm,evidence_wrong,,"));
	EXPECT_THAT(doors[6], HasSubstr(",2,2,miss,size_limit,door,"));
}

TEST(Eval, PageShowsTheWorstFramesAndNeedsNoOtherFile)
{
	const auto folder = test::freshFolder();
	const auto logs = threeLogs(folder);
	ASSERT_EQ(exploreEval({logs[0], logs[1], logs[2], "--out", (folder / "out").string()}).exit_code, 0);
	const std::string page = test::readFile(folder / "out" / "index.html");
	EXPECT_LT(page.size(), 15'000'000U);
	EXPECT_THAT(page,
	            AllOf(HasSubstr("<title>explore-eval</title>"), HasSubstr("data:image/jpeg;base64,/9j/"),
	                  HasSubstr("size_limit: the door is narrower or wider than the method looks for"),
	                  HasSubstr("single wall multiple doors"), Not(HasSubstr("http")), Not(HasSubstr("<script"))));
	std::size_t figures = 0;
	for (std::size_t at = 0; (at = page.find("<figure>", at)) != std::string::npos; ++at) ++figures;
	EXPECT_EQ(figures, 3U);
}

TEST(Eval, AnyNumberOfJobsGivesTheSameBytes)
{
	const auto folder = test::freshFolder();
	const auto logs = threeLogs(folder);
	std::vector<std::string> arguments{logs[2], logs[0], logs[1], "--jobs", "1", "--out", (folder / "one").string()};
	ASSERT_EQ(exploreEval(arguments).exit_code, 0);
	arguments[4] = "3";
	arguments[6] = (folder / "three").string();
	std::swap(arguments[0], arguments[2]);
	ASSERT_EQ(exploreEval(arguments).exit_code, 0);
	expectSameFolder(folder / "one", folder / "three");
}

TEST(Eval, MergedPartsAreTheSameAsOneRun)
{
	const auto folder = test::freshFolder();
	const auto logs = threeLogs(folder);
	const auto out = [&](const char* name) { return (folder / name).string(); };
	const auto whole = exploreEval({logs[0], logs[1], logs[2], "--out", out("whole")});
	ASSERT_EQ(exploreEval({logs[2], "--out", out("part1")}).exit_code, 0);
	ASSERT_EQ(exploreEval({logs[0], logs[1], "--out", out("part2")}).exit_code, 0);
	const auto merged = exploreEval({"merge", out("part1"), out("part2"), "--out", out("merged")});
	EXPECT_EQ(merged.exit_code, 0) << merged.err;
	EXPECT_EQ(merged.out, whole.out);
	expectSameFolder(folder / "whole", folder / "merged");
}

TEST(Eval, PartsThatDoNotFitAreRefused)
{
	const auto folder = test::freshFolder();
	const auto logs = threeLogs(folder);
	const auto out = [&](const char* name) { return (folder / name).string(); };
	ASSERT_EQ(exploreEval({logs[0], "--out", out("a")}).exit_code, 0);
	ASSERT_EQ(exploreEval({logs[1], "--out", out("b"), "--set", "perception.seed=2"}).exit_code, 0);
	const auto merge = [&](const std::vector<std::string>& parts)
	{
		std::vector<std::string> arguments{"merge", "--out", out("merged")};
		arguments.insert(arguments.end(), parts.begin(), parts.end());
		return exploreEval(arguments);
	};
	auto result = merge({out("a"), out("b")});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.err, AllOf(HasSubstr(out("b")), HasSubstr("configuration"), HasSubstr("--set")));
	result = merge({out("a"), out("a")});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.err, AllOf(HasSubstr(logs[0]), HasSubstr("twice")));
	result = merge({out("a"), out("none")});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.err, HasSubstr("none/eval.json"));
	test::writeFile(folder / "a" / "frames.csv", evaluation::frameHeader());
	result = merge({out("a")});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.err, AllOf(HasSubstr("frames.csv"), HasSubstr("fewer lines")));
	EXPECT_FALSE(fs::exists(folder / "merged" / "eval.json"));
}

TEST(Eval, RequirementsThatAreMissedAreNamed)
{
	const auto folder = test::freshFolder();
	const auto logs = threeLogs(folder);
	auto result = exploreEval({logs[0], logs[1], logs[2], "--require", "recall.value=0.75,precision.value=0.8"});
	EXPECT_EQ(result.exit_code, 0) << result.err;
	result = exploreEval({logs[0], logs[1], logs[2], "--quiet", "--require",
	                      "recall.value=0.9,precision=0.99,false_alarms.value=0.5,reports=0.1"});
	EXPECT_EQ(result.exit_code, 1);
	const auto lines = test::linesOf(result.err);
	ASSERT_EQ(lines.size(), 3U) << result.err;
	EXPECT_THAT(lines[0], AllOf(HasSubstr("recall.value: measured 0.8000 (4 of 5)"), HasSubstr("at least 0.9")));
	EXPECT_THAT(lines[1], AllOf(HasSubstr("precision: measured 0.8000"), HasSubstr("at the lower end")));
	EXPECT_THAT(lines[2], AllOf(HasSubstr("reports: measured 0.3333 (1 of 3)"), HasSubstr("at most 0.1")));

	result = exploreEval({logs[0], "--require", "direction_given=0.5"});
	EXPECT_EQ(result.exit_code, 1);
	EXPECT_THAT(result.err, HasSubstr("not measured"));
	result = exploreEval({logs[0], "--require", "precison=0.9"});
	EXPECT_EQ(result.exit_code, 2);
	EXPECT_THAT(result.err, AllOf(HasSubstr("precison=0.9"), HasSubstr("precision, recall")));
}

TEST(Eval, ALogWithoutTruthIsReportedAlone)
{
	const auto folder = test::freshFolder();
	const auto log = (folder / "corridor.rawlog").string();
	test::writeCorridorRawlog(log, {.frames = 3});
	const auto result = exploreEval({log, "--out", (folder / "out").string()});
	EXPECT_EQ(result.exit_code, 0) << result.err;
	EXPECT_THAT(result.out, AllOf(HasSubstr("Logs without truth"), HasSubstr("corridor.truth.json is not there")));
	const auto lines = test::linesOf(test::readFile(folder / "out" / "frames.csv"));
	ASSERT_EQ(lines.size(), 4U);
	EXPECT_EQ(std::ranges::count(lines[1], ','), std::ranges::count(lines[0], ','));
}

TEST(Eval, ADamagedLogIsScoredUpToTheDamage)
{
	const auto folder = test::freshFolder();
	const auto logs = threeLogs(folder);
	const std::string bytes = test::readFile(logs[0]);
	test::writeFile(logs[0], bytes.substr(0, bytes.size() * 2 / 3));
	const auto result = exploreEval({logs[0], logs[1], "--out", (folder / "out").string(), "--quiet"});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.err, AllOf(HasSubstr(logs[0] + ": damaged"), Not(HasSubstr(logs[1]))));
	EXPECT_THAT(result.out, HasSubstr("frames of the truth have no depth frame"));
	const Json results = readResults(folder / "out")["results"];
	EXPECT_EQ(groupNamed(results["families"], "mixed")["figures"]["doors"][1]["hits"], 1);
	EXPECT_LT(groupNamed(results["families"], "frontal")["figures"]["frames"], 3);
}

TEST(Eval, ALogThatCannotBeReadDoesNotStopTheOthers)
{
	const auto folder = test::freshFolder();
	const auto logs = threeLogs(folder);
	test::writeFile(evaluation::truthPathOf(logs[1]), "{\"schema\":1}");
	const auto missing = (folder / "missing.rawlog").string();
	const auto result = exploreEval({logs[0], logs[1], missing, "--quiet"});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.out, HasSubstr("frontal"));
	EXPECT_THAT(result.err, AllOf(HasSubstr("mixed.truth.json: at the top: the key \"world\" is missing"),
	                              HasSubstr("missing.rawlog")));
}

TEST(Eval, TheRobotIsThatOfTheTruthUnlessToldOtherwise)
{
	const auto folder = test::freshFolder();
	auto head = test::headOf("frontal", "");
	head.robot.radius_m = 0.45;  // needs 1.0 m: no report says that it fits
	const auto log = test::writeScoredLog(folder, "wide", {{2.6}}, head).string();
	const auto out = (folder / "out").string();
	const auto hits = [&](const std::vector<std::string>& more)
	{
		std::vector<std::string> arguments{log, "--out", out, "--ini", "corridor.ini"};
		arguments.insert(arguments.end(), more.begin(), more.end());
		const auto result = exploreEval(arguments);
		EXPECT_EQ(result.exit_code, 0) << result.err;
		EXPECT_EQ(more.empty(), result.out.find("the robot is not the one") == std::string::npos) << result.out;
		return readResults(out)["results"]["positives"]["doors"][1]["hits"].get<int>();
	};
	EXPECT_EQ(hits({}), 0);
	EXPECT_EQ(hits({"--set", "robot.radius=0.2"}), 1);
	EXPECT_EQ(hits({"--robot", "ground"}), 1);
}

TEST(Eval, MistakesOnTheCommandLineAreUsageErrors)
{
	const auto folder = test::freshFolder();
	const auto log = (folder / "a.rawlog").string();
	EXPECT_EQ(exploreEval({}).exit_code, 2);
	EXPECT_EQ(exploreEval({"--ini", "corridor.ini"}).exit_code, 2);
	EXPECT_EQ(exploreEval({log, log}).exit_code, 2);
	EXPECT_EQ(exploreEval({log, "--jobs", "0"}).exit_code, 2);
	EXPECT_EQ(exploreEval({log, "--ini", "none.ini"}).exit_code, 2);
	EXPECT_EQ(exploreEval({log, "--set", "robot.radios=1"}).exit_code, 2);
	EXPECT_EQ(exploreEval({"merge"}).exit_code, 2);
	EXPECT_EQ(exploreEval({"--help"}).exit_code, 0);
	EXPECT_THAT(exploreEval({"--version"}).out, testing::StartsWith("explore-eval "));
	test::writeFile(folder / "file", "x");
	EXPECT_EQ(exploreEval({log, "--out", (folder / "file").string()}).exit_code, 5);
	test::Program::Setup full_disk;
	full_disk.file_size_limit = 500;
	EXPECT_EQ(exploreEval({log, "--out", (folder / "out").string()}, full_disk).exit_code, 5);
}

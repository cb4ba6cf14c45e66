// explore-eval compare and gallery, and the scripts that run many configurations.
#include "apps/eval_fixture.h"

#include <explore/evaluation/truth_file.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace explore;
using test::exploreEval;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace
{
/** A script of apps/explore-eval, with the programs of this build. */
test::ProgramResult runScript(const std::string& name, std::vector<std::string> arguments)
{
	const fs::path script = fs::path(EXPLORE_SOURCE_DIR) / "apps" / "explore-eval" / name;
	std::vector<std::string> all{"EXPLORE_EVAL=" EXPLORE_EVAL_PROGRAM, "EXPLORE_MRPT=" EXPLORE_MRPT_PROGRAM,
	                             script.string()};
	all.insert(all.end(), arguments.begin(), arguments.end());
	return test::Program("/usr/bin/env", all, {}).wait();
}

/** Four doors of 0.95 m. */
std::string doorsLog(const fs::path& folder)
{
	return test::writeScoredLog(folder, "frontal", {{2.6}, {3.0, 0.4}, {2.3, -0.3}, {2.8, 0.2}},
	                            test::headOf("frontal", ""))
	    .string();
}

const Json& figure(const Json& comparison, std::size_t run, const std::string& name)
{
	return comparison["runs"][run]["figures"][name];
}
}  // namespace

TEST(EvalCompare, TellsWhatAnotherConfigurationChanges)
{
	const auto folder = test::freshFolder();
	const auto log = doorsLog(folder);
	const auto out = [&](const char* name) { return (folder / name).string(); };
	ASSERT_EQ(exploreEval({log, "--out", out("base"), "--no-pictures"}).exit_code, 0);
	ASSERT_EQ(exploreEval({log, "--out", out("wide"), "--set", "perception.min_gap=1.1"}).exit_code, 0);
	const auto result = exploreEval({"compare", out("base"), out("wide"), out("base"), "--out", out("compared")});
	EXPECT_EQ(result.exit_code, 0) << result.err;
	EXPECT_EQ(result.out, test::readFile(folder / "compared" / "compare.txt"));
	EXPECT_THAT(result.out, testing::AllOf(HasSubstr("wide perception.min_gap=1.1"), HasSubstr("-100.00")));
	const Json json = Json::parse(test::readFile(folder / "compared" / "compare.json"));
	EXPECT_EQ(figure(json, 0, "recall")["base"], 1.0);
	EXPECT_EQ(figure(json, 0, "recall")["difference"], -1.0);
	EXPECT_EQ(figure(json, 1, "recall")["difference"], 0.0);
	EXPECT_EQ(json["runs"][0]["scenes"], 4);
}

TEST(EvalCompare, CostsThatAreTooHighAreNamed)
{
	const auto folder = test::freshFolder();
	const auto log = doorsLog(folder);
	const auto out = [&](const char* name) { return (folder / name).string(); };
	ASSERT_EQ(exploreEval({log, "--out", out("base")}).exit_code, 0);
	ASSERT_EQ(exploreEval({log, "--out", out("wide"), "--set", "perception.min_gap=1.1"}).exit_code, 0);
	auto result = exploreEval({"compare", out("base"), out("wide"), "--cost", "recall=1"});
	EXPECT_EQ(result.exit_code, 1);
	EXPECT_THAT(result.err, HasSubstr("costs too much: wide perception.min_gap=1.1: recall: -100.00 points"));
	EXPECT_EQ(exploreEval({"compare", out("base"), out("base"), "--cost", "recall=0,precision=0"}).exit_code, 0);
	EXPECT_EQ(exploreEval({"compare", out("base"), out("wide"), "--cost", "recal=1"}).exit_code, 2);
	EXPECT_EQ(exploreEval({"compare", out("base")}).exit_code, 2);
	EXPECT_EQ(exploreEval({"compare", out("base"), out("none")}).exit_code, 3);
}

TEST(EvalCompare, TheScriptRunsEachSetOnce)
{
	const auto folder = test::freshFolder();
	const auto log = doorsLog(folder);
	test::writeFile(folder / "sets.txt",
	                "# what is compared\nbase\n\nwide perception.min_gap=1.1\nboth perception.min_gap=0.7 "
	                "perception.max_gap=0.9\n");
	const auto out = folder / "out";
	auto result = runScript("compare_sets.sh", {"-j", "1", (folder / "sets.txt").string(), out.string(), log, "--set",
	                                            "perception.method=paper"});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const Json json = Json::parse(test::readFile(out / "compare.json"));
	ASSERT_EQ(json["runs"].size(), 2U);
	EXPECT_EQ(json["runs"][1]["run"], "both perception.min_gap=0.7 perception.max_gap=0.9");
	EXPECT_EQ(figure(json, 0, "recall")["difference"], -1.0);
	EXPECT_EQ(figure(json, 1, "recall")["difference"], -1.0);
	EXPECT_FALSE(fs::exists(out / "base" / "pictures"));
	result = runScript("compare_sets.sh", {"-c", "recall=1", (folder / "sets.txt").string(), out.string(), log, "--set",
	                                       "perception.method=paper"});
	EXPECT_EQ(result.exit_code, 1) << result.err;
	EXPECT_THAT(result.err, testing::AllOf(HasSubstr("costs too much: wide"), testing::Not(HasSubstr("run wide"))))
	    << "is there already";
	EXPECT_EQ(runScript("compare_sets.sh", {}).exit_code, 2);
}

TEST(EvalCompare, ThresholdsAreScaledWithinTheirBounds)
{
	const auto result = runScript("scaled_sets.sh", {"corridor.ini"});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const auto lines = test::linesOf(result.out);
	ASSERT_GT(lines.size(), 4U);
	EXPECT_EQ(lines[0], "base");
	EXPECT_THAT(lines, testing::Contains("max_range_x0.8 perception.max_range=4"));
	EXPECT_THAT(lines, testing::Contains("max_range_x1.2 perception.max_range=6"));
	EXPECT_THAT(result.out, testing::AllOf(testing::Not(HasSubstr("seed")), testing::Not(HasSubstr("scan_height")),
	                                       testing::Not(HasSubstr("alpha"))));
	// Each is accepted as it stands, also where a factor leads out of its bounds.
	const auto extreme = test::linesOf(runScript("scaled_sets.sh", {"corridor.ini", "0.0001", "10000"}).out);
	for (std::size_t i = 1; i < extreme.size(); ++i)
	{
		const std::string setting = extreme[i].substr(extreme[i].find(' ') + 1);
		EXPECT_EQ(test::exploreMrpt({"--ini", "corridor.ini", "--dump-config", "--set", setting}).exit_code, 0)
		    << setting;
	}
}

TEST(EvalGallery, ShowsTheFirstFrameOfEachLog)
{
	const auto folder = test::freshFolder();
	const auto doors = doorsLog(folder);
	const auto plain =
	    test::writeScoredLog(folder, "plain", {{2.6, 0, 0}, {2.6}}, test::headOf("plain", "", true)).string();
	const auto out = folder / "doc";
	const auto result = exploreEval(
	    {"gallery", plain, doors, "--ini", "corridor.ini", "--set", "perception.method=paper", "--out", out.string()});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	const std::string page = test::readFile(out / "scene-pictures.md");
	EXPECT_LT(page.find("## frontal"), page.find("## plain"));
	EXPECT_THAT(page, HasSubstr("there is: open, 0.95 m wide\n* found: open, 0.9"));
	EXPECT_THAT(page.substr(page.find("## plain")), HasSubstr("there is: no opening in view\n* found: nothing"));
	EXPECT_THAT(page,
	            HasSubstr("explore-eval gallery --ini corridor.ini --set perception.method=paper LOG... --out doc"));
	for (const char* name : {"frontal", "plain"})
	{
		const std::string picture = test::readFile(out / "images" / "scenes" / (std::string(name) + ".jpg"));
		EXPECT_TRUE(picture.starts_with("\xFF\xD8") && picture.ends_with("\xFF\xD9")) << name;
		EXPECT_LT(picture.size(), 60'000U);
		EXPECT_THAT(page, HasSubstr("](images/scenes/" + std::string(name) + ".jpg)"));
	}
	fs::remove(evaluation::truthPathOf(plain));
	EXPECT_EQ(exploreEval({"gallery", plain, "--out", out.string()}).exit_code, 3);
	EXPECT_EQ(exploreEval({"gallery", "--out", out.string()}).exit_code, 2);
}

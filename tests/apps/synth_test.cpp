// explore-rawlog synth as a user runs it: logs of random scenes and their truth.
#include <explore/evaluation/truth_file.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "apps/program.h"
#include "apps/rawlog_program.h"

using namespace explore::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;
namespace fs = std::filesystem;

namespace
{
ProgramResult synth(const fs::path& out, std::vector<std::string> more)
{
	more.insert(more.begin(), {"synth", "--size", "160", "--seed", "4", "--out", out.string()});
	return exploreRawlog(more);
}

std::vector<std::string> namesIn(const fs::path& folder)
{
	std::vector<std::string> names;
	for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
	std::sort(names.begin(), names.end());
	return names;
}
}  // namespace

TEST(Synth, WritesALogThatInfoFindsIntactAndItsTruth)
{
	const auto folder = freshFolder();
	const auto result = synth(folder / "new" / "scenes",
	                          {"--family", "oblique_door", "--count", "3", "--looks", "2", "--robot", "mav"});
	ASSERT_EQ(result.exit_code, 0) << result.err;
	EXPECT_THAT(result.out, HasSubstr("oblique_door-mav.rawlog: 3 scenes"));
	EXPECT_THAT(namesIn(folder / "new" / "scenes"),
	            testing::ElementsAre("oblique_door-mav.rawlog", "oblique_door-mav.truth.json"));

	const fs::path log = folder / "new" / "scenes" / "oblique_door-mav.rawlog";
	EXPECT_THAT(exploreRawlog({"info", log.string()}).out,
	            AllOf(HasSubstr("CObservation3DRangeScan 'XTION': 6"), HasSubstr("160x120"),
	                  HasSubstr("accelerometer: yes"), HasSubstr("damage:        none")));
	const explore::TruthLog truth = explore::evaluation::readTruth(explore::evaluation::truthPathOf(log));
	EXPECT_EQ(truth.family, "oblique_door");
	EXPECT_EQ(truth.robot.kind, explore::RobotKind::mav);
	EXPECT_EQ(truth.noise, "kinect");
	EXPECT_EQ(truth.seed, 4U);
	ASSERT_THAT(truth.frames, SizeIs(6));
	EXPECT_EQ(truth.frames.back().scene, 2);
	EXPECT_THAT(truth.frames.front().doors, SizeIs(1));
}

TEST(Synth, WritesTheSameForAnyNumberOfJobs)
{
	const auto folder = freshFolder();
	const std::vector<std::string> what = {"--family", "window",  "--family", "ajar_30", "--family",
	                                       "window",   "--count", "3",        "--looks", "2"};
	for (const char* jobs : {"1", "3"})
	{
		auto arguments = what;
		arguments.insert(arguments.end(), {"--jobs", jobs});
		ASSERT_EQ(synth(folder / jobs, arguments).exit_code, 0);
	}
	EXPECT_THAT(namesIn(folder / "1"), SizeIs(8)) << "a log and its truth for each family and robot";
	EXPECT_EQ(namesIn(folder / "1"), namesIn(folder / "3"));
	for (const std::string& name : namesIn(folder / "1"))
		EXPECT_EQ(readFile(folder / "1" / name), readFile(folder / "3" / name)) << name;
}

TEST(Synth, NamesTheCommandThatMakesTheLogAgain)
{
	const auto folder = freshFolder();
	ASSERT_EQ(
	    synth(folder / "first", {"--family", "all", "--count", "1", "--robot", "ground", "--noise", "none"}).exit_code,
	    0);
	const fs::path log = folder / "first" / "stairwell-ground.rawlog";
	std::istringstream words(explore::evaluation::readTruth(explore::evaluation::truthPathOf(log)).command);
	std::vector<std::string> arguments;
	for (std::string word; words >> word;) arguments.push_back(word);
	ASSERT_EQ(arguments.at(0), "explore-rawlog");
	arguments.erase(arguments.begin());
	fs::create_directories(folder / "again");
	ASSERT_EQ(
	    exploreRawlog(arguments, {.standard_output = {}, .file_size_limit = 0, .working_folder = folder / "again"})
	        .exit_code,
	    0);
	EXPECT_EQ(readFile(folder / "again" / "stairwell-ground.rawlog"), readFile(log));
	EXPECT_EQ(readFile(folder / "again" / "stairwell-ground.truth.json"),
	          readFile(folder / "first" / "stairwell-ground.truth.json"));
}

TEST(Synth, WorseNoiseIsToldByTheTruthAndMadeAgain)
{
	const auto folder = freshFolder();
	const std::vector<std::string> what = {"--family", "frontal_door", "--count", "2", "--robot", "ground"};
	const auto with = [&](const char* name, std::vector<std::string> more)
	{
		more.insert(more.begin(), what.begin(), what.end());
		EXPECT_EQ(synth(folder / name, more).exit_code, 0);
		return folder / name / "frontal_door-ground.rawlog";
	};
	const fs::path usual = with("usual", {}), same = with("same", {"--noise-scale", "1", "--holes", "0"});
	const fs::path worse = with("worse", {"--noise-scale", "2", "--holes", "0.3"});
	EXPECT_EQ(readFile(usual), readFile(same));
	EXPECT_NE(readFile(usual), readFile(worse));
	const auto truthOf = [](const fs::path& log)
	{ return explore::evaluation::readTruth(explore::evaluation::truthPathOf(log)); };
	EXPECT_EQ(truthOf(usual).command, truthOf(same).command);
	EXPECT_EQ(truthOf(worse).noise, "kinect x2 holes 0.3");
	EXPECT_THAT(truthOf(worse).command, HasSubstr("--noise kinect --noise-scale 2 --holes 0.3 --out"));
	EXPECT_EQ(exploreRawlog({"synth", "--family", "window", "--count", "1", "--holes", "1.5", "--out", "x"}).exit_code,
	          2);
}

TEST(Synth, ListsTheFamilies)
{
	const auto result = exploreRawlog({"synth", "--list"});
	EXPECT_EQ(result.exit_code, 0);
	EXPECT_THAT(result.out, AllOf(HasSubstr("single_wall_single_door"), HasSubstr("obstacle_stool"),
	                              HasSubstr("1000 scenes"), HasSubstr("nothing to pass")));
}

TEST(Synth, RefusesWhatItDoesNotKnow)
{
	const auto folder = freshFolder();
	const std::string out = (folder / "out").string();
	for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
	         {"synth"},
	         {"synth", "--family", "window", "--out", out},
	         {"synth", "--family", "window", "--count", "2"},
	         {"synth", "--count", "2", "--out", out},
	         {"synth", "--family", "window", "--count", "0", "--out", out},
	         {"synth", "--family", "window", "--count", "2", "--looks", "0", "--out", out},
	         {"synth", "--family", "window", "--count", "2", "--robot", "boat", "--out", out},
	         {"synth", "--family", "window", "--count", "2", "--noise", "loud", "--out", out}})
		EXPECT_EQ(exploreRawlog(arguments).exit_code, 2) << testing::PrintToString(arguments);
	const auto typo = exploreRawlog({"synth", "--family", "widow", "--count", "1", "--out", out});
	EXPECT_EQ(typo.exit_code, 2);
	EXPECT_THAT(typo.err, AllOf(HasSubstr("widow"), HasSubstr("did you mean window?")));
	EXPECT_FALSE(fs::exists(out));
}

TEST(Synth, ThatCannotWriteExitsWith5)
{
	const auto folder = freshFolder();
	writeFile(folder / "file", "");
	const auto result = synth(folder / "file", {"--family", "window", "--count", "1"});
	EXPECT_EQ(result.exit_code, 5);
	EXPECT_THAT(result.err, HasSubstr("file"));

	// A disk that fills up in the middle: no log passes for a shorter one.
	const auto full = exploreRawlog({"synth", "--size", "160", "--family", "window", "--count", "20", "--jobs", "2",
	                                 "--out", (folder / "full").string()},
	                                {.standard_output = {}, .file_size_limit = 60'000, .working_folder = {}});
	EXPECT_EQ(full.exit_code, 5);
	for (const std::string& name : namesIn(folder / "full")) EXPECT_EQ(fs::path(name).extension(), "") << name;
}

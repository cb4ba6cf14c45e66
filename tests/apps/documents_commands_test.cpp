// Every command of the documentation is run, page by page and in its order, in a folder of its own; what is done
// differently from the page stands below, and nothing else is.
#include "apps/document_commands.h"
#include "apps/rawlog_program.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <regex>

using namespace explore::test;
namespace fs = std::filesystem;

namespace
{
/** Commands whose text contains `part`, on `page` or, where that is empty, on any. */
struct Listed
{
	const char* page;
	const char* part;
	const char* why;

	[[nodiscard]] bool holds(const PageStep& step) const
	{
		return (*page == '\0' || step.page == page) && step.file.empty() && step.text.find(part) != std::string::npos;
	}
};

/** Not run at all. */
const std::vector<Listed> kNotRun{
    {"", "cmake --", "builds the project"},
    {"doc/CONTRIBUTING.md", "ctest --preset", "runs the tests"},
    {"", "./run.sh", "installs packages, builds and tests"},
    {"doc/CONTRIBUTING.md", ".ci/run", "builds and tests everything"},
    {"doc/CONTRIBUTING.md", "tests/support/kill_and_resume.sh", "minutes of kills; CI runs it"},
    {"", "apt install", "installs a package"},
    {"doc/ros.md", "apt-get install", "installs packages"},
    {"doc/installing.md", "cmake -S doc/examples/find_doors", "needs an installed library; .ci/check-debs runs it"},
    {"doc/robot-link.md", "g++ ", "compiles what apps_robot_link_test runs"},
    {"doc/robot-link.md", "doc/examples/robot_client.py 5005", "never ends by itself; apps_robot_link_test runs it"},
    {"doc/ros.md", "rosbag", "needs ROS packages; apps.RosBag runs it where they are"},
    {"doc/ros.md", "bag_to_folder.py", "needs ROS packages; apps.RosBag runs it where they are"},
    {"doc/method.md", "tests/support/logs_to_fit.sh", "makes logs for hours"},
    {"doc/evaluation.md", "apps/explore-eval/slurm_array.sh", "needs Slurm; apps.EvalSlurm runs it with a stand-in"},
};

/** Not run, but every --option has to be one of the program's. */
const std::vector<Listed> kOptionsOnly{
    {"doc/results.md", "", "campaigns of hours"},
    {"doc/scene-pictures.md", "", "the page's own pictures, of 2820 scenes"},
    {"", " --oni ", "needs a recording of OpenNI2; openni2_test makes and reads one"},
    {"", "import --png", "needs a folder of images; apps.RawlogImport runs it"},
    {"", "import --tum", "needs a folder of images; apps.RawlogImport and apps.RosBag run it"},
    {"README.md", "my_building.sdf", "a world of the reader's"},
    {"doc/evaluation.md", "gallery", "the page's own pictures; apps.Eval makes such a page"},
    {"doc/ros.md", "my_robot.ini", "an ini of the reader's"},
};

/** Literal changes, beside those of adapted(). */
struct Change
{
	const char* page;
	const char* from;
	const char* to;
	const char* why;
};
const std::vector<Change> kChanges{
    {"doc/evaluation.md", "LOG.rawlog...", "rawlogs/office.rawlog", "a log with truth"},
    {"doc/evaluation.md", "a.rawlog", "mine.rawlog", "some log"},
    {"doc/evaluation.md", "b.rawlog", "MY.rawlog", "another log"},
    {"doc/evaluation.md", "--family all --count 50", "--family frontal_door --family corner_door --count 1", "minutes"},
    {"doc/evaluation.md", "=3,recall=3", "=100,recall=100", "so few scenes cannot tell"},
    {"doc/evaluation.md", "=1,recall=1", "=100,recall=100", "so few scenes cannot tell"},
    {"doc/evaluation.md", "scaled_sets.sh corridor.ini", "scaled_sets.sh corridor.ini | head -2", "dozens of runs"},
    {"rawlogs/README.md", "worlds/", "rawlogs/worlds/", "the page says to be in that folder"},
    {"doc/ros.md", "LOG.rawlog", "MY.rawlog", "some log"},
};

bool contains(const std::string& text, const std::string& part)
{
	return text.find(part) != std::string::npos;
}

const Listed* listedIn(const std::vector<Listed>& list, const PageStep& step)
{
	const auto found = std::find_if(list.begin(), list.end(), [&](const Listed& entry) { return entry.holds(step); });
	return found == list.end() ? nullptr : &*found;
}

bool wantsCamera(const std::string& command)
{
	return contains(command, "--openni2") || (contains(command, "explore-mrpt --ini xtion.ini") &&
	                                          !contains(command, "--rawlog") && !contains(command, "--dump-config"));
}

/** `option` gets this value, or is appended with it where it is missing. */
void setOption(std::string& command, const std::string& option, const std::string& value)
{
	const std::regex given(option + " [^ ]+");
	if (std::regex_search(command, given))
		command = std::regex_replace(command, given, option + " " + value);
	else
		command += " " + option + " " + value;
}

void shortenMrpt(std::string& command)
{
	const bool whole = contains(command, "--rawlog") && !contains(command, "--realtime");
	if (!whole && !contains(command, "--dump-config") && !contains(command, "--help"))
		setOption(command, "--max-frames", "10");
}

void shortenRawlog(std::string& command)
{
	if (contains(command, " synth ") && !contains(command, "--list"))
		for (const char* option : {"--count", "--size"})
			setOption(command, option, contains(option, "size") ? "160" : "1");
	if (!contains(command, " record ")) return;
	if (!contains(command, " list")) setOption(command, "--seconds", "2");
	if (contains(command, "--world")) setOption(command, "--size", "160");
}

void shortenEval(std::string& command)
{
	const bool scores = contains(command, "--ini") && !contains(command, " soak ") && !contains(command, " gallery ");
	if (scores && !contains(command, "--no-pictures")) command += " --no-pictures";
	if (!contains(command, " soak ")) return;
	setOption(command, "--runs", "1");
	command += " --set simulator.time_limit=1";
}

/** The command as the test runs it: shorter runs, smaller pictures, fewer scenes. */
std::string adapted(const PageStep& step)
{
	const std::size_t remark = step.text.find(" #");
	std::string command = std::regex_replace(step.text.substr(0, remark), std::regex(R"(\s+$)"), "");
	for (const Change& change : kChanges)
		if (step.page == change.page)
			for (std::size_t at = command.find(change.from); at != std::string::npos;
			     at = command.find(change.from, at + std::string(change.to).size()))
				command.replace(at, std::string(change.from).size(), change.to);
	if (command.starts_with("explore-mrpt")) shortenMrpt(command);
	if (command.starts_with("explore-rawlog")) shortenRawlog(command);
	if (command.starts_with("explore-eval")) shortenEval(command);
	return command;
}

/** What "# exit code N" beside it says, else 0. */
int expectedExitCode(const PageStep& step)
{
	std::smatch match;
	return std::regex_search(step.text, match, std::regex("# exit code ([0-9]+)")) ? std::stoi(match[1]) : 0;
}

ProgramResult shell(const std::string& command, const fs::path& folder)
{
	std::string path = "export PATH=";
	for (const char* program : {EXPLORE_MRPT_PROGRAM, EXPLORE_EVAL_PROGRAM, EXPLORE_RAWLOG_PROGRAM})
		path += fs::path(program).parent_path().string() + ":";
	return Program("/bin/sh", {"-c", path + "$PATH; " + command}, {{}, 0, folder}).wait();
}

/** Program, and subcommand where it has one. */
std::string programOf(const std::string& command)
{
	std::smatch match;
	const std::regex program(
	    "^explore-(mrpt|rawlog( (info|import|record|synth))?|eval( (merge|compare|gallery|soak))?)");
	return std::regex_search(command, match, program) ? match[0].str() : std::string();
}

void expectKnownOptions(const PageStep& step, const fs::path& folder)
{
	const std::string program = programOf(step.text);
	if (program.empty()) return;
	static std::map<std::string, std::vector<std::string>> known;
	if (!known.contains(program)) known[program] = longOptionsIn(shell(program + " --help", folder).out);
	for (const std::string& option : longOptionsIn(step.text.substr(0, step.text.find(" #"))))
		EXPECT_THAT(known[program], testing::Contains(option)) << program << " has no such option";
}

/** Without a camera the program says what to check; a build without OpenNI2 says so. */
void expectCameraOrAdvice(const ProgramResult& result)
{
	if (result.exit_code == 4)
	{
		EXPECT_THAT(result.err, testing::HasSubstr("What to check"));
	}
	if (result.exit_code == 2)
	{
		EXPECT_THAT(result.err, testing::HasSubstr("OpenNI2"));
	}
	EXPECT_THAT(result.exit_code, testing::AnyOf(0, 2, 4)) << result.err;
}

void run(const PageStep& step, const fs::path& folder)
{
	const std::string command = adapted(step);
	const ProgramResult result = shell(command, folder);
	if (wantsCamera(command)) return expectCameraOrAdvice(result);
	EXPECT_EQ(result.exit_code, expectedExitCode(step)) << "run as: " << command << "\n" << result.out << result.err;
}

/** A copy of what the pages' commands find where the reader is: the project's folder, and a recording of theirs. */
fs::path readersFolder()
{
	const fs::path source = EXPLORE_SOURCE_DIR;
	fs::path folder = freshFolder() / "reader";
	for (const char* part : {"rawlogs", "doc/examples", "apps/explore-eval", "tests/data"})
	{
		fs::create_directories((folder / part).parent_path());
		fs::copy(source / part, folder / part, fs::copy_options::recursive);
	}
	for (const char* name : {"MY.rawlog", "mine.rawlog"}) fs::copy(source / "rawlogs/corridor.rawlog", folder / name);
	writeFile(folder / "sets.txt", "full\npaper perception.method=paper\n");
	return folder;
}

std::string nameOf(const testing::TestParamInfo<std::string>& page)
{
	return std::regex_replace(page.param, std::regex("[^A-Za-z0-9]"), "_");
}
}  // namespace

class DocumentCommands : public testing::TestWithParam<std::string>
{
};

TEST_P(DocumentCommands, RunAsThePageSays)
{
	const auto steps = stepsOf(GetParam());
	const fs::path folder = readersFolder();
	for (const PageStep& step : steps)
	{
		SCOPED_TRACE(step.page + ":" + std::to_string(step.line) + ": " + (step.file.empty() ? step.text : step.file));
		if (!step.file.empty())
			writeFile(folder / step.file, step.text);
		else if (listedIn(kNotRun, step) == nullptr)
		{
			expectKnownOptions(step, folder);
			if (listedIn(kOptionsOnly, step) == nullptr && !isSynopsis(adapted(step))) run(step, folder);
		}
	}
}

INSTANTIATE_TEST_SUITE_P(Page, DocumentCommands, testing::ValuesIn(documentPages()), nameOf);

TEST(DocumentCommandLists, NoEntryIsLeftOver)
{
	std::vector<PageStep> all;
	for (const std::string& page : documentPages())
		for (const PageStep& step : stepsOf(page)) all.push_back(step);
	for (const auto* list : {&kNotRun, &kOptionsOnly})
		for (const Listed& entry : *list)
			EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const PageStep& step) { return entry.holds(step); }))
			    << "'" << entry.part << "' (" << entry.why << ") is on no page any more";
	for (const Change& change : kChanges)
		EXPECT_TRUE(std::any_of(all.begin(), all.end(),
		                        [&](const PageStep& step)
		                        { return step.page == change.page && contains(step.text, change.from); }))
		    << "'" << change.from << "' (" << change.why << ") is not on " << change.page << " any more";
}

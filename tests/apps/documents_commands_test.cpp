// Every command of the documentation is run, page by page and in its order, in a folder of its own; what is done
// differently from the page stands in adapted() and document_exceptions.h, and nothing else is.
#include "apps/document_commands.h"
#include "apps/document_exceptions.h"
#include "apps/rawlog_program.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <regex>

using namespace explore::test;
namespace fs = std::filesystem;

namespace
{
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

bool lacksPython(const std::vector<PageStep>& steps, const fs::path& folder)
{
	return shell("python3 -c 'import json'", folder).exit_code != 0 &&
	       std::any_of(steps.begin(), steps.end(),
	                   [](const PageStep& step) { return step.text.starts_with("python3 "); });
}

std::string nameOfPage(const testing::TestParamInfo<std::string>& page)
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
	if (lacksPython(steps, folder)) GTEST_SKIP() << "python3 is not installed";
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

INSTANTIATE_TEST_SUITE_P(Page, DocumentCommands, testing::ValuesIn(documentPages()), nameOfPage);

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

TEST(LabelDoors, FindsWhichDoorsTheRecordingShows)
{
	const fs::path folder = readersFolder();
	std::string said;
	const auto steps = stepsOf("doc/labelling.md");
	if (lacksPython(steps, folder)) GTEST_SKIP() << "python3 is not installed";
	for (const PageStep& step : steps)
		if (!step.file.empty())
			writeFile(folder / step.file, step.text);
		else if (contains(step.text, "--out mine") || contains(step.text, "label_doors.py"))
			said = shell(step.text, folder).out;
	EXPECT_EQ(said, "60 frames, 4 doors, visible 63 times\n");
	const std::string page = readFile(fs::path(EXPLORE_SOURCE_DIR) / "doc/labelling.md");
	EXPECT_THAT(page, testing::HasSubstr("`" + said.substr(0, said.find('\n')) + "`"));
}

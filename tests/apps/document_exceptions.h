// What documents_commands_test does not run, or not as a page has it, and why. An entry that no page has any more
// fails.
#pragma once

#include "apps/document_commands.h"

#include <string>
#include <vector>

namespace explore::test
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
inline const std::vector<Listed> kNotRun{
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
    {"doc/live.md", "rawlog-grabber ", "needs mrpt-hwdrivers; apps_grabber_test runs it where that is"},
    {"doc/viewers.md", "rawlog-edit ", "needs mrpt-apps; apps_viewers_test runs it where that is"},
    {"doc/ros.md", "rosbag", "needs ROS packages; apps.RosBag runs it where they are"},
    {"doc/ros.md", "bag_to_folder.py", "needs ROS packages; apps.RosBag runs it where they are"},
    {"doc/method.md", "tests/support/logs_to_fit.sh", "makes logs for hours"},
    {"doc/evaluation.md", "apps/explore-eval/slurm_array.sh", "needs Slurm; apps.EvalSlurm runs it with a stand-in"},
};

/** Not run, but every --option has to be one of the program's. */
inline const std::vector<Listed> kOptionsOnly{
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
inline const std::vector<Change> kChanges{
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
}  // namespace explore::test

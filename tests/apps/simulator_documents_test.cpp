// The simulator's ini reference is written by the program's own field lists.
#include "support/test_files.h"

#include <explore/config/ini.h>
#include <explore/simulation/depth_camera.h>
#include <explore/simulation/simulated_robot_config.h>
#include <gtest/gtest.h>

#include <cstdlib>

using namespace explore;

TEST(SimulatorDocuments, IniReferenceIsCurrent)
{
	auto camera = simulation::depthCamera("xtion");
	camera.color = true;  // as explore-rawlog record has it
	simulation::SimulatedRobotConfig robot;
	const std::string whole = iniReference(
	    [&](FieldVisitor& fields)
	    {
		    simulation::describe(fields, camera);
		    simulation::describe(fields, robot);
	    });
	const std::string expected =
	    "# Ini reference of the simulator\n\n"
	    "Sections that `explore-rawlog record --ini` takes beside those of `doc/ini-reference.md`; of these it uses\n"
	    "`[robot]` and, with `mount = ini`, `[camera]`. Written by the program from its own field lists.\n\n" +
	    whole.substr(whole.find("## ["));

	const auto path = std::filesystem::path(EXPLORE_SOURCE_DIR) / "doc" / "ini-reference-simulator.md";
	if (std::getenv("EXPLORE_UPDATE_DOCS") != nullptr) test::writeFile(path, expected);
	EXPECT_EQ(test::readFile(path), expected)
	    << path << " is out of date; write it anew with: EXPLORE_UPDATE_DOCS=1 ctest -R SimulatorDocuments";
}

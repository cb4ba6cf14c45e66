#include <common/exit_codes.h>
#include <explore-rawlog/info_command.h>
#include <explore/sources/rawlog_info.h>
#ifdef EXPLORE_SIMULATION
#include <explore-rawlog/world_info.h>
#include <explore/simulation/load_world.h>
#else
#include <explore/core/errors.h>
#endif

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>

namespace explore::app
{
namespace
{
/** Worlds are XML; no rawlog begins like that. */
bool isWorld(const std::filesystem::path& path)
{
	if (path.extension() == ".sdf" || path.extension() == ".world") return true;
	char first = '\0';
	std::ifstream(path) >> first;  // skips blanks
	return first == '<';
}

int printWorld(const std::string& path)
{
#ifdef EXPLORE_SIMULATION
	std::cout << textOf(simulation::loadWorld(path, simulation::usualWorldPaths()));
	return kDone;
#else
	throw ConfigError(path + " is a simulated world: this explore-rawlog was built without the simulator");
#endif
}

int printRawlog(const std::string& path)
{
	const RawlogInfo contents = describeRawlog(path);
	std::cout << textOf(contents);
	return contents.damage ? kInputError : kDone;
}
}  // namespace

void addInfoCommand(CLI::App& app, std::function<int()>& command)
{
	auto path = std::make_shared<std::string>();
	CLI::App* info =
	    app.add_subcommand("info",
	                       "Observations, rates, intrinsics, poses and damage of a rawlog (exit code 3 when it is "
	                       "damaged); or bodies, labels and left-out elements of a simulated world.");
	info->add_option("FILE", *path, "The rawlog, plain or gzipped, or the SDF world")->required();
	info->callback([path, &command]
	               { command = [path] { return isWorld(*path) ? printWorld(*path) : printRawlog(*path); }; });
}
}  // namespace explore::app

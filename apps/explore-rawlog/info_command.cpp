#include <explore-mrpt/exit_codes.h>
#include <explore-rawlog/info_command.h>
#include <explore/sources/rawlog_info.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

namespace explore::app
{
void addInfoCommand(CLI::App& app, std::function<int()>& command)
{
	auto path = std::make_shared<std::string>();
	CLI::App* info = app.add_subcommand(
	    "info", "Observations, rates, intrinsics, poses and damage of a rawlog. Exit code 3 when it is damaged.");
	info->add_option("LOG", *path, "The rawlog, plain or gzipped")->required();
	info->callback(
	    [path, &command]
	    {
		    command = [path]
		    {
			    const RawlogInfo contents = describeRawlog(*path);
			    std::cout << textOf(contents);
			    return contents.damage ? kInputError : kDone;
		    };
	    });
}
}  // namespace explore::app

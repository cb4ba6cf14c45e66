#include <common/exit_codes.h>
#include <common/parse_arguments.h>

#include <CLI/CLI.hpp>
#include <iostream>

namespace explore::app
{
std::optional<int> parseArguments(CLI::App& app, int argc, const char* const* argv)
{
	if (argc <= 1)
	{
		std::cerr << app.help();
		return kUsageError;
	}
	try
	{
		app.parse(argc, argv);
	}
	catch (const CLI::ParseError& answer)
	{
		return app.exit(answer, std::cout, std::cerr) == 0 ? kDone : kUsageError;
	}
	return std::nullopt;
}
}  // namespace explore::app

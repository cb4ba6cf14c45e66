#include <common/exit_codes.h>
#include <common/parse_arguments.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

namespace explore::app
{
namespace
{
/** Without the long lists of what does not go together: descriptions say "instead of", and the error names both. */
class ShortHelp : public CLI::Formatter
{
public:
	[[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override
	{
		const std::string all = CLI::Formatter::make_option_opts(option);
		return all.substr(0, all.find(" Excludes:"));
	}
};

void useFormatter(CLI::App& app, const std::shared_ptr<ShortHelp>& formatter)
{
	app.formatter(formatter);
	for (CLI::App* const part : app.get_subcommands({})) useFormatter(*part, formatter);
}
}  // namespace

std::optional<int> parseArguments(CLI::App& app, const FirstCommands& first, int argc, const char* const* argv)
{
	if (argc <= 1)
	{
		std::cerr << app.get_description() << "\n\n"
		          << first.lines << "\nAll options: " << app.get_name() << " --help\n";
		return kUsageError;
	}
	useFormatter(app, std::make_shared<ShortHelp>());
	app.footer("Examples:\n" + first.lines + "\n" + app.get_footer());
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

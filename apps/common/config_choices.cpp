#include <common/config_choices.h>

#include <CLI/CLI.hpp>

namespace explore::app
{
std::vector<std::string> ConfigChoices::overrides() const
{
	std::vector<std::string> overrides = set;
	if (seed)
		for (const char* key : {"perception.seed=", "simulator.seed="})
			overrides.push_back(key + std::to_string(*seed));
	return overrides;
}

void addIniOption(CLI::App& app, ConfigChoices& choices)
{
	app.add_option("--ini", choices.ini, "Configuration: a path, or a name in the ini/ folder such as corridor.ini")
	    ->type_name("NAME");
}

void addOverrideOptions(CLI::App& app, ConfigChoices& choices, const std::string& robot_help)
{
	app.add_option("--sensors-pose", choices.sensors_pose,
	               "Sensor poses from a rawlog-grabber ini, instead of the recorded ones")
	    ->type_name("FILE");
	app.add_option("--set", choices.set, "Overrides one key of the ini; may be repeated")
	    ->type_name("SECTION.KEY=VALUE")
	    ->allow_extra_args(false);
	app.add_option("--robot", choices.robot, robot_help)
	    ->type_name("KIND")
	    ->transform(CLI::CheckedTransformer(kRobots, CLI::ignore_case).description(""));
	app.add_option("--seed", choices.seed, "The same as --set perception.seed=N --set simulator.seed=N")
	    ->type_name("N");
}
}  // namespace explore::app

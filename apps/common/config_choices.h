// What a command line says about the configuration; the same options in every program that explores.
#pragma once

#include <explore/core/robot.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace explore::app
{
/** What --robot takes. */
inline const std::map<std::string, RobotKind> kRobots{{"ground", RobotKind::ground}, {"mav", RobotKind::mav}};

struct ConfigChoices
{
	std::string ini;                 ///< empty = built-in defaults
	std::string rawlog, oni, world;  ///< empty = as the ini says
	std::vector<std::string> set;    ///< "section.key=value"
	std::optional<RobotKind> robot;
	std::string sensors_pose;
	std::optional<int> seed;

	/** `set` and what `seed` stands for: "section.key=value", later ones win. */
	[[nodiscard]] std::vector<std::string> overrides() const;
};

/** --ini */
void addIniOption(CLI::App& app, ConfigChoices& choices);
/** --sensors-pose, --set, --robot (explained by `robot_help`), --seed */
void addOverrideOptions(CLI::App& app, ConfigChoices& choices, const std::string& robot_help);
}  // namespace explore::app

// Everything that an ini holds, and how ini and command line become one configuration.
#pragma once

#include <common/config_choices.h>
#include <explore/config/simulated_camera.h>
#include <explore/config/simulated_robot.h>
#include <explore/pipeline/explorer_config.h>
#include <explore/sinks/output_config.h>
#include <explore/sinks/robot_link/link_config.h>
#include <explore/sources/source_config.h>

#include <filesystem>

namespace explore::app
{
struct AppConfig
{
	SourceConfig source;
	simulation::DepthCameraConfig simulated_camera = simulation::depthCamera("xtion", 320);
	simulation::SimulatedRobotConfig simulated_robot;
	ExplorerConfig explorer;
	OutputConfig output;
	RobotLinkConfig robot_link;
};
/** [source] [simulator] [camera] [simulated_camera] [simulated_robot], those of ExplorerConfig, [output] [robot_link]
 */
void describe(FieldVisitor& fields, AppConfig& config);

/** The size and limits of a usual robot of this kind (see doc/ini-reference.md, [robot]). */
RobotConfig robotDefaults(RobotKind kind);

struct LoadedConfig
{
	AppConfig config;
	std::filesystem::path ini;  ///< the file that was read; empty = none
};

/** Defaults, then the ini, then --robot, then --set, --seed, --rawlog, --oni and --world; what comes later wins.
 *  - Keys of [robot] that the ini leaves out are those of robotDefaults(kind), whichever kind it names.
 *  - `--robot` naming the other kind replaces the ini's whole [robot] by robotDefaults.
 *  Throws ConfigError. */
LoadedConfig loadConfig(const ConfigChoices& choices);

/** Sets what "section.key=value" says. Throws ConfigError. */
void applyOverrides(AppConfig& config, const std::vector<std::string>& overrides);

/** The complete commented ini with the values of `config`. */
std::string dumpConfig(AppConfig config);
}  // namespace explore::app

#include <common/config_choices.h>
#include <common/exit_codes.h>
#include <explore-rawlog/noise_options.h>
#include <explore-rawlog/synth_command.h>
#include <explore-rawlog/synth_logs.h>
#include <explore/config/suggestions.h>
#include <explore/core/errors.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>

namespace explore::app
{
namespace
{
using simulation::NoiseModel;
using simulation::sceneFamilies;
using simulation::SceneFamily;

const std::map<std::string, NoiseModel> kNoises{
    {"none", NoiseModel::none}, {"kinect", NoiseModel::kinect}, {"speckle", NoiseModel::speckle}};

struct SynthOptions
{
	std::vector<std::string> families;
	std::optional<RobotKind> robot;  ///< no value: both
	int count = 0, looks = 1, width_px = 640, jobs = 1;
	std::uint64_t seed = 1;
	NoiseModel noise = NoiseModel::kinect;
	double noise_scale = 1.0, holes = 0.0;
	std::string out;
	bool color = false, list = false;
};

void addOptions(CLI::App& synth, SynthOptions& options)
{
	synth.add_flag("--list", options.list, "Tells the families and what they are, and does nothing else");
	synth.add_option("--family", options.families, "A family of scenes, or all; may be repeated")->type_name("NAME");
	synth.add_option("--count", options.count, "Scenes a log; a larger count begins with those of a smaller one")
	    ->type_name("N")
	    ->check(CLI::Range(1, 1'000'000).description(""));
	synth.add_option("--seed", options.seed, "Of all that is random")->type_name("N")->capture_default_str();
	synth.add_option("--robot", options.robot, "ground or mav; else a log for each")
	    ->type_name("KIND")
	    ->transform(CLI::CheckedTransformer(kRobots, CLI::ignore_case).description(""));
	synth.add_option("--looks", options.looks, "Frames a scene, of a short approach")
	    ->type_name("N")
	    ->check(CLI::Range(1, 1000).description(""))
	    ->capture_default_str();
	synth.add_option("--size", options.width_px, "Width of the images, three quarters of it high")
	    ->type_name("PX")
	    ->check(CLI::Range(16, 4096).description(""))
	    ->capture_default_str();
	synth.add_option("--noise", options.noise, "none, kinect (default) or speckle")
	    ->type_name("NAME")
	    ->transform(CLI::CheckedTransformer(kNoises, CLI::ignore_case).description(""));
	addNoiseOptions(synth, options.noise_scale, options.holes);
	synth.add_flag("--color", options.color, "Colour images too");
	synth.add_option("--jobs", options.jobs, "Logs made at a time; they do not depend on it")
	    ->type_name("N")
	    ->check(CLI::Range(1, 256).description(""))
	    ->capture_default_str();
	synth.add_option("--out", options.out, "Folder for FAMILY-ROBOT.rawlog and FAMILY-ROBOT.truth.json")
	    ->type_name("DIR");
}

int listFamilies()
{
	for (const SceneFamily& family : sceneFamilies())
	{
		std::cout << std::left << std::setw(30) << family.name << family.description;
		if (family.negative == simulation::Negative::yes) std::cout << "; nothing to pass";
		if (family.negative == simulation::Negative::for_ground) std::cout << "; nothing to pass on the ground";
		if (!family.configuration.empty()) std::cout << "; a row of the paper's table";
		std::cout << "; at least " << family.scenesForAClaim() << " scenes\n";
	}
	return kDone;
}

const SceneFamily& familyOf(const std::string& name)
{
	if (const SceneFamily* family = simulation::sceneFamilyNamed(name)) return *family;
	const auto nearest = std::ranges::min(
	    sceneFamilies(), {}, [&name](const SceneFamily& family) { return editDistance(family.name, name); });
	throw ConfigError("--family " + name + ": no such family; did you mean " + std::string(nearest.name) +
	                  "? --list tells them all");
}

std::vector<SynthTask> tasksOf(const SynthOptions& options)
{
	std::vector<const SceneFamily*> families;
	for (const std::string& name : options.families)
		if (name == "all")
			for (const SceneFamily& family : sceneFamilies()) families.push_back(&family);
		else
			families.push_back(&familyOf(name));
	std::vector<SynthTask> tasks;
	for (const SceneFamily* family : families)
		for (const RobotKind robot : {RobotKind::ground, RobotKind::mav})
		{
			const bool wanted = options.robot.value_or(robot) == robot;
			const bool known = std::ranges::any_of(
			    tasks, [&](const SynthTask& task) { return task.family == family && task.robot == robot; });
			if (wanted && !known) tasks.push_back({family, robot});
		}
	return tasks;
}

int synthesise(const SynthOptions& options)
{
	if (options.list) return listFamilies();
	if (options.families.empty() || options.count == 0 || options.out.empty())
		throw ConfigError("synth needs --family NAME|all, --count N and --out DIR; --list tells the families");
	SynthConfig config;
	config.seed = options.seed;
	config.count = options.count;
	config.looks = options.looks;
	config.out = options.out;
	config.camera = simulation::depthCamera("xtion", options.width_px);
	config.camera.noise = options.noise;
	config.camera.noise_scale = options.noise_scale;
	config.camera.hole_share = options.holes;
	config.camera.color = options.color;
	writeLogs(tasksOf(options), config, options.jobs,
	          [&](const SynthTask& task)
	          { std::cout << logPathOf(task, config).string() << ": " << config.count << " scenes" << std::endl; });
	return kDone;
}
}  // namespace

void addSynthCommand(CLI::App& app, std::function<int()>& command)
{
	auto options = std::make_shared<SynthOptions>();
	CLI::App* synth = app.add_subcommand("synth", "Makes rawlogs of random scenes with their truth.");
	addOptions(*synth, *options);
	synth->callback([options, &command] { command = [options] { return synthesise(*options); }; });
}
}  // namespace explore::app

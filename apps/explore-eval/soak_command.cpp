#include <common/app_config.h>
#include <common/exit_codes.h>
#include <explore-eval/process_pool.h>
#include <explore-eval/soak_command.h>
#include <explore-mrpt/run.h>
#include <explore/core/errors.h>
#include <explore/evaluation/soak.h>
#include <explore/sinks/output_file.h>
#include <explore/sinks/output_folder.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>

namespace explore::app
{
namespace
{
namespace fs = std::filesystem;
using evaluation::SoakRun;

/** A world of the command line: "FILE" or "FILE@START". */
struct SoakWorld
{
	std::string name, file, start;
};

SoakWorld worldOf(const std::string& text)
{
	const std::size_t at = text.rfind('@');
	SoakWorld world;
	world.file = text.substr(0, at);
	if (at != std::string::npos) world.start = text.substr(at + 1);
	world.name = fs::path(world.file).stem().string();
	return world;
}

/** Worlds that share a file name get a number. */
std::vector<SoakWorld> worldsOf(const EvalOptions& options)
{
	std::vector<SoakWorld> worlds;
	worlds.reserve(options.worlds.size());
	for (const std::string& text : options.worlds)
	{
		SoakWorld world = worldOf(text);
		const auto same = std::ranges::count_if(
		    worlds, [&](const SoakWorld& other) { return fs::path(other.file).stem() == world.name; });
		if (same > 0) world.name.append("_").append(std::to_string(same + 1));
		worlds.push_back(std::move(world));
	}
	return worlds;
}

struct Task
{
	SoakWorld world;
	int seed = 0;

	[[nodiscard]] std::string name() const { return world.name + ", seed " + std::to_string(seed); }
	[[nodiscard]] fs::path folderIn(const fs::path& out) const { return out / world.name / std::to_string(seed); }
};

/** Seed by seed, so that a run that ends early has as many of each world. */
std::vector<Task> tasksOf(const EvalOptions& options)
{
	std::vector<Task> tasks;
	const auto worlds = worldsOf(options);
	const int first = options.seed.value_or(1);
	for (int seed = first; seed < first + options.runs; ++seed)
		for (const SoakWorld& world : worlds) tasks.push_back({world, seed});
	return tasks;
}

Options optionsOf(const Task& task, const EvalOptions& options)
{
	Options run;
	static_cast<ConfigChoices&>(run) = static_cast<const ConfigChoices&>(options);
	run.world = task.world.file;
	if (!task.world.start.empty()) run.set.push_back("simulator.start=" + task.world.start);
	run.seed = task.seed;
	run.out = task.folderIn(options.out).string();
	run.verbosity = mrpt::system::LVL_ERROR;
	run.quiet = true;
	return run;
}

/** One exploration, in a process of its own; why it failed, or an empty text. */
std::string exploreOnce(const Task& task, const EvalOptions& options)
{
	try
	{
		const Options choices = optionsOf(task, options);
		if (const int exit_code = run(choices); exit_code != kDone) return "exit code " + std::to_string(exit_code);
		const OutputPaths paths = outputPaths(choices.out);
		if (!options.keep_frames)
			for (const fs::path* file : {&paths.frames, &paths.timing}) removeOldFile(*file);
		return "";
	}
	catch (const std::exception& error)
	{
		return error.what();
	}
}

/** What a task that was not begun in time returns. */
constexpr const char* kNotBegun = "not begun";

std::vector<SoakRun> runAll(const std::vector<Task>& tasks, const EvalOptions& options)
{
	using Clock = std::chrono::steady_clock;
	std::optional<Clock::time_point> end;
	if (options.minutes > 0.0)
		end = Clock::now() +
		      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(60.0 * options.minutes));
	std::vector<std::string> names;
	names.reserve(tasks.size());
	for (const Task& task : tasks) names.push_back(task.name());
	std::size_t ended = 0;
	const auto texts = inProcesses(
	    names, options.jobs,
	    [&](std::size_t i) { return end && Clock::now() > *end ? kNotBegun : exploreOnce(tasks[i], options); },
	    [&](std::size_t i)
	    {
		    if (!options.quiet)
			    std::cerr << "explored " << ++ended << " of " << tasks.size() << ": " << names[i] << '\n';
	    });
	std::vector<SoakRun> runs;
	for (std::size_t i = 0; i < tasks.size(); ++i)
	{
		const Task& task = tasks[i];
		if (texts[i] == kNotBegun) continue;
		if (texts[i].empty())
			runs.push_back(
			    evaluation::readSoakRun(task.world.name, task.seed, outputPaths(task.folderIn(options.out)).summary));
		else
		{
			SoakRun& failed = runs.emplace_back();
			failed.world = task.world.name;
			failed.seed = task.seed;
			failed.error = texts[i];
		}
	}
	return runs;
}
}  // namespace

int soak(const EvalOptions& options)
{
	// A wrong ini would fail in every run alike.
	loadConfig(options);
	const std::vector<Task> tasks = tasksOf(options);
	makeFolder(options.out);
	const std::vector<SoakRun> runs = runAll(tasks, options);
	const std::string tables = evaluation::soakText(runs);
	const fs::path out = options.out;
	writeFileAtomically(out / "soak.csv", evaluation::soakCsv(runs));
	writeFileAtomically(out / "soak.txt", tables);
	OutputFile::standardOutput().write(tables);
	if (runs.size() < tasks.size())
		std::cerr << "explore-eval: " << tasks.size() - runs.size() << " runs were not begun in " << options.minutes
		          << " minutes\n";
	const bool failed = std::ranges::any_of(runs, [](const SoakRun& run) { return !run.error.empty(); });
	return failed ? kInputError : kDone;
}
}  // namespace explore::app

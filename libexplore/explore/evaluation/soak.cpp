#include <explore/evaluation/csv.h>
#include <explore/evaluation/json_place.h>
#include <explore/evaluation/scene_bootstrap.h>
#include <explore/evaluation/soak.h>
#include <explore/evaluation/text_table.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace explore::evaluation
{
namespace
{
using Runs = std::vector<const SoakRun*>;
using Figure = std::function<std::optional<double>(const SoakRun&)>;

std::optional<double> numberIn(const JsonPlace& place)
{
	return place.isNull() ? std::nullopt : std::optional(place.number());
}

/** The median over the runs that have the figure. */
std::string medianText(const Runs& runs, const Figure& figure, const char* format)
{
	SceneValues values;
	for (std::size_t i = 0; i < runs.size(); ++i)
		if (const auto value = figure(*runs[i])) values.add(*value, i);
	values.sort();
	const SceneStatistic median = [&](const SceneWeights& weights) { return values.quantile(weights, 0.5); };
	const auto interval = bootstrapIntervals(runs.size(), std::span(&median, 1)).front();
	return withInterval(median(SceneWeights(runs.size(), 1)), interval, format);
}

/** Goal flips in 100 m of all runs' ways together. */
std::string flipsText(const Runs& runs)
{
	const SceneStatistic rate = [&](const SceneWeights& weights) -> std::optional<double>
	{
		double flips = 0, path_m = 0;
		for (std::size_t i = 0; i < runs.size(); ++i)
		{
			flips += weights[i] * static_cast<double>(runs[i]->goal_flips);
			path_m += weights[i] * runs[i]->path_m;
		}
		return path_m > 0.0 ? std::optional(100.0 * flips / path_m) : std::nullopt;
	};
	const auto interval = bootstrapIntervals(runs.size(), std::span(&rate, 1)).front();
	return withInterval(rate(SceneWeights(runs.size(), 1)), interval, "%.2f");
}

/** The least or greatest of a figure; "-" where no run has it. */
template <class Better>
std::string extremeText(const Runs& runs, const Figure& figure, const char* format, const Better& better)
{
	std::optional<double> extreme;
	for (const SoakRun* run : runs)
		if (const auto value = figure(*run); value && (!extreme || better(*value, *extreme))) extreme = value;
	return extreme ? mrpt::format(format, *extreme) : "-";
}

std::size_t sumOf(const Runs& runs, std::size_t SoakRun::*figure)
{
	std::size_t sum = 0;
	for (const SoakRun* run : runs) sum += run->*figure;
	return sum;
}

std::vector<std::string> rowOf(const std::string& world, const Runs& runs)
{
	const auto complete = std::ranges::count_if(runs, [](const SoakRun* run) { return run->complete; });
	const Figure coverage = [](const SoakRun& run) { return run.coverage; };
	const Figure from_start_m = [](const SoakRun& run) { return run.from_start_m; };
	return {world,
	        std::to_string(complete) + " of " + std::to_string(runs.size()),
	        extremeText(runs, coverage, "%.4f", std::less<>()),
	        medianText(runs, coverage, "%.4f"),
	        std::to_string(sumOf(runs, &SoakRun::collisions)),
	        extremeText(runs, from_start_m, "%.2f", std::greater<>()),
	        flipsText(runs),
	        medianText(
	            runs, [](const SoakRun& run) { return run.path_m; }, "%.0f"),
	        medianText(
	            runs, [](const SoakRun& run) { return run.time_s; }, "%.0f"),
	        medianText(
	            runs, [](const SoakRun& run) { return run.median_ms; }, "%.1f")};
}

std::string failuresText(std::span<const SoakRun> runs)
{
	std::string text;
	for (const SoakRun& run : runs)
	{
		if (run.error.empty() && run.complete && run.collisions == 0) continue;
		text += "  " + run.world + ", seed " + std::to_string(run.seed) + ": ";
		if (!run.error.empty())
			text += "failed: " + run.error;
		else
			text += (run.complete ? "" : "not complete: " + run.reason + "; ") + std::to_string(run.collisions) +
			        " collisions";
		text += '\n';
	}
	return text.empty() ? "" : "\nRuns that failed, did not complete or touched something\n" + text;
}
}  // namespace

SoakRun readSoakRun(const std::string& world, int seed, const std::filesystem::path& path)
{
	const Json document = readJson(path);
	const JsonPlace summary(document, path.string());
	const JsonPlace exploration = summary.at("exploration"), truth = summary.at("truth");
	SoakRun run;
	run.world = world;
	run.seed = seed;
	run.complete = exploration.at("complete").boolean();
	run.reason = exploration.at("reason").text();
	run.time_s = numberIn(exploration.at("time_s")).value_or(0.0);
	run.frames = summary.at("source").at("frames").count();
	run.path_m = truth.at("path_m").number();
	run.from_start_m = truth.at("from_start_m").number();
	run.collisions = truth.at("collisions").count();
	run.goal_flips = truth.at("goal_flips").count();
	run.reachable_m2 = truth.at("reachable_m2").number();
	run.coverage = numberIn(truth.at("coverage"));
	run.min_clearance_m = numberIn(truth.at("min_clearance_m"));
	if (const JsonPlace timing = summary.at("timing_ms"); timing.has("total"))
		run.median_ms = timing.at("total").at("median").number();
	return run;
}

std::string soakText(std::span<const SoakRun> runs)
{
	if (runs.empty()) return "";
	std::vector<std::pair<std::string, Runs>> worlds;
	Runs all;
	for (const SoakRun& run : runs)
	{
		if (!run.error.empty()) continue;
		auto world = std::ranges::find(worlds, run.world, [](const auto& named) { return named.first; });
		if (world == worlds.end()) world = worlds.insert(worlds.end(), {run.world, {}});
		world->second.push_back(&run);
		all.push_back(&run);
	}
	TextTable table({"<world", "complete", "coverage min", "median", "collisions", "from start max m", "flips/100 m",
	                 "path m", "time s", "ms a frame"});
	for (const auto& [world, its_runs] : worlds) table.row(rowOf(world, its_runs));
	if (worlds.size() > 1) table.row(rowOf("all", all));
	return "Explorations in simulated worlds; 95 % intervals over runs in brackets\n" + table.text() +
	       failuresText(runs);
}

std::string soakCsv(std::span<const SoakRun> runs)
{
	CsvRow header;
	for (const char* title :
	     {"world", "seed", "error", "complete", "reason", "time_s", "frames", "path_m", "from_start_m", "collisions",
	      "goal_flips", "reachable_m2", "coverage", "min_clearance_m", "median_ms"})
		header.text(title);
	std::string text = header.line();
	for (const SoakRun& run : runs)
		text += CsvRow()
		            .text(run.world)
		            .count(static_cast<std::size_t>(run.seed))
		            .text(run.error)
		            .flag(run.complete)
		            .text(run.reason)
		            .number(run.time_s)
		            .count(run.frames)
		            .number(run.path_m)
		            .number(run.from_start_m)
		            .count(run.collisions)
		            .count(run.goal_flips)
		            .number(run.reachable_m2)
		            .number(run.coverage)
		            .number(run.min_clearance_m)
		            .number(run.median_ms)
		            .line();
	return text;
}
}  // namespace explore::evaluation

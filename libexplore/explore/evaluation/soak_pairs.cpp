#include <explore/evaluation/scene_bootstrap.h>
#include <explore/evaluation/soak_pairs.h>
#include <explore/evaluation/text_table.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <charconv>

namespace explore::evaluation
{
namespace
{
namespace fs = std::filesystem;

std::optional<int> seedOf(const fs::path& folder)
{
	const std::string name = folder.filename().string();
	int seed = 0;
	const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), seed);
	const bool is_number = error == std::errc() && end == name.data() + name.size();
	return is_number ? std::optional(seed) : std::nullopt;
}

std::vector<fs::path> foldersIn(const fs::path& folder)
{
	std::vector<fs::path> folders;
	if (!fs::is_directory(folder)) return folders;
	for (const fs::directory_entry& entry : fs::directory_iterator(folder))
		if (entry.is_directory()) folders.push_back(entry.path());
	std::ranges::sort(folders);
	return folders;
}

bool areComplete(const SoakPairs& pairs, std::size_t i)
{
	return pairs.base[i].complete && pairs.other[i].complete;
}

std::optional<double> longerShare(const SoakPairs& pairs, const SceneWeights& weights)
{
	double base_m = 0, other_m = 0;
	for (std::size_t i = 0; i < pairs.base.size(); ++i)
	{
		if (!areComplete(pairs, i)) continue;
		base_m += weights[i] * pairs.base[i].path_m;
		other_m += weights[i] * pairs.other[i].path_m;
	}
	return base_m > 0.0 ? std::optional(other_m / base_m - 1.0) : std::nullopt;
}

std::string longerText(const SoakPairs& pairs)
{
	const SceneStatistic percent = [&](const SceneWeights& weights) -> std::optional<double>
	{
		const auto share = longerShare(pairs, weights);
		return share ? std::optional(100.0 * *share) : std::nullopt;
	};
	const std::size_t count = pairs.base.size();
	const auto interval = bootstrapIntervals(count, std::span(&percent, 1)).front();
	return withInterval(percent(SceneWeights(count, 1)), interval, "%+.1f");
}

std::string completeText(const std::vector<SoakRun>& runs)
{
	return std::to_string(std::ranges::count_if(runs, &SoakRun::complete)) + " of " + std::to_string(runs.size());
}

std::string medianOf(const std::vector<SoakRun>& runs, const char* format, double (*figure)(const SoakRun&))
{
	SceneValues values;
	for (std::size_t i = 0; i < runs.size(); ++i) values.add(figure(runs[i]), i);
	values.sort();
	return mrpt::format(format, values.quantile(SceneWeights(runs.size(), 1), 0.5).value_or(0.0));
}

std::vector<std::string> rowOf(const SoakPairs& pairs)
{
	const auto path_m = [](const SoakRun& run) { return run.path_m; };
	const auto coverage = [](const SoakRun& run) { return run.coverage.value_or(0.0); };
	return {pairs.world,
	        completeText(pairs.base),
	        completeText(pairs.other),
	        medianOf(pairs.base, "%.1f", path_m),
	        medianOf(pairs.other, "%.1f", path_m),
	        longerText(pairs),
	        medianOf(pairs.base, "%.4f", coverage),
	        medianOf(pairs.other, "%.4f", coverage)};
}
}  // namespace

std::vector<SoakRun> readSoakRuns(const fs::path& folder)
{
	std::vector<SoakRun> runs;
	for (const fs::path& world : foldersIn(folder))
		for (const fs::path& run : foldersIn(world))
			if (const auto seed = seedOf(run); seed && fs::exists(run / "summary.json"))
				runs.push_back(readSoakRun(world.filename().string(), *seed, run / "summary.json"));
	return runs;
}

std::vector<SoakPairs> pairsOf(std::span<const SoakRun> base, std::span<const SoakRun> other)
{
	std::vector<SoakPairs> worlds;
	for (const SoakRun& run : base)
	{
		const auto same = std::ranges::find_if(
		    other, [&](const SoakRun& one) { return one.world == run.world && one.seed == run.seed; });
		if (same == other.end()) continue;
		auto world = std::ranges::find(worlds, run.world, &SoakPairs::world);
		if (world == worlds.end()) world = worlds.insert(worlds.end(), {run.world, {}, {}});
		world->base.push_back(run);
		world->other.push_back(*same);
	}
	return worlds;
}

std::optional<double> longerShare(const SoakPairs& pairs)
{
	return longerShare(pairs, SceneWeights(pairs.base.size(), 1));
}

std::string soakPairsText(const std::string& base_name, const std::string& other_name,
                          std::span<const SoakPairs> worlds)
{
	TextTable table({"<world", "complete", "other", "path m", "other", "other is longer by %", "coverage", "other"});
	SoakPairs all{"all", {}, {}};
	for (const SoakPairs& world : worlds)
	{
		table.row(rowOf(world));
		all.base.insert(all.base.end(), world.base.begin(), world.base.end());
		all.other.insert(all.other.end(), world.other.begin(), world.other.end());
	}
	if (worlds.size() > 1) table.row(rowOf(all));
	return other_name + " (other) beside " + base_name +
	       ", run by run; medians, and 95 % intervals over pairs that are both complete\n" + table.text();
}
}  // namespace explore::evaluation

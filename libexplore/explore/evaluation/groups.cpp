#include <explore/evaluation/figures.h>

#include <algorithm>
#include <functional>
#include <map>
#include <tuple>

namespace explore::evaluation
{
namespace
{
using SceneList = std::vector<const SceneScore*>;

/** Order of the groups: negative ones last, then by rank and name, robot and noise. */
using Key = std::tuple<bool, std::size_t, std::string, std::string, std::string>;

constexpr std::array<std::string_view, 3> kPaperRows{"single wall single door", "single wall multiple doors",
                                                     "multiple walls multiple doors"};

/** The paper's order, whatever separates the words; others after them. */
std::size_t rankOf(std::string configuration)
{
	std::ranges::replace(configuration, '_', ' ');
	return static_cast<std::size_t>(std::ranges::find(kPaperRows, configuration) - kPaperRows.begin());
}

void append(SceneList& list, const LogScore& log)
{
	for (const SceneScore& scene : log.scenes) list.push_back(&scene);
}

/** The scenes of the logs with truth, by the key that `keyOf` gives a log, where it gives one. */
std::vector<Group> grouped(const std::vector<LogScore>& logs,
                           const std::function<std::vector<Key>(const LogScore&)>& keys_of)
{
	std::map<Key, SceneList> lists;
	for (const LogScore& log : logs)
		if (log.has_truth && !log.scenes.empty())
			for (const Key& key : keys_of(log)) append(lists[key], log);
	std::vector<Group> groups;
	groups.reserve(lists.size());
	for (const auto& [key, scenes] : lists)
		groups.push_back({std::get<2>(key), std::get<3>(key), std::get<4>(key), std::get<0>(key), figuresOf(scenes)});
	return groups;
}

std::vector<Key> configurationKeys(const LogScore& log)
{
	if (log.configuration.empty()) return {};
	return {{false, rankOf(log.configuration), log.configuration, log.platform, log.noise},
	        {false, kPaperRows.size() + 1, "all of them", log.platform, log.noise}};
}

std::vector<Key> familyKeys(const LogScore& log)
{
	return {{log.negative, 0, log.family.empty() ? log.world : log.family, log.platform, log.noise}};
}

std::vector<Key> pooledKeys(const LogScore& log)
{
	return {{log.negative, 0, log.negative ? "all without doors" : "all with doors", log.platform, log.noise}};
}

/** The figures of all logs for which `wanted` holds; no value without scenes. */
template <class Wanted>
std::optional<Figures> figuresWhere(const std::vector<LogScore>& logs, const Wanted& wanted)
{
	SceneList scenes;
	for (const LogScore& log : logs)
		if (log.has_truth && wanted(log)) append(scenes, log);
	return scenes.empty() ? std::nullopt : std::optional(figuresOf(scenes));
}
}  // namespace

Results resultsOf(const std::vector<LogScore>& logs)
{
	Results results;
	results.configurations = grouped(logs, configurationKeys);
	results.families = grouped(logs, familyKeys);
	results.pooled = grouped(logs, pooledKeys);
	results.positives = figuresWhere(logs, [](const LogScore& log) { return !log.negative; });
	results.negatives = figuresWhere(logs, [](const LogScore& log) { return log.negative; });
	results.everything = figuresWhere(logs, [](const LogScore&) { return true; });
	for (const LogScore& log : logs)
		if (!log.has_truth && log.error.empty()) results.without_truth.push_back(&log);
	return results;
}
}  // namespace explore::evaluation

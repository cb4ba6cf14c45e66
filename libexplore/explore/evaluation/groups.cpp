#include <explore/evaluation/figures.h>

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <map>
#include <sstream>

namespace explore::evaluation
{
namespace
{
using SceneList = std::vector<const SceneScore*>;

/** Order of the groups: negative ones behind, mirrors last, then by rank and name, robot and noise. */
struct Key
{
	bool by_tracks = false, negative = false;
	std::size_t rank = 0;
	std::string name, platform, noise;

	auto operator<=>(const Key&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm of clang-tidy 14
};

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
		groups.push_back({key.name, key.platform, key.noise, key.negative, key.by_tracks, figuresOf(scenes)});
	return groups;
}

/** Whether one of the words of the family's name begins like one of `beginnings`. */
bool isAbout(const LogScore& log, std::initializer_list<std::string_view> beginnings)
{
	std::string name = log.family;
	std::ranges::replace(name, '_', ' ');
	std::istringstream words(name);
	for (std::string word; words >> word;)
		if (std::ranges::any_of(beginnings, [&](std::string_view beginning) { return word.starts_with(beginning); }))
			return true;
	return false;
}

/** Each robot and noise, then all of them where there is more than one. */
std::vector<Group> pooledWhere(const std::vector<LogScore>& logs, const std::string& name, bool negative,
                               const std::function<bool(const LogScore&)>& wanted)
{
	const auto keys = [&](bool all)
	{
		return grouped(logs,
		               [&, all](const LogScore& log) -> std::vector<Key>
		               {
			               if (scoredByTracks(log) || !wanted(log)) return {};
			               return {{false, negative, 0, name, all ? "" : log.platform, all ? "" : log.noise}};
		               });
	};
	std::vector<Group> groups = keys(false);
	if (groups.size() < 2) return groups;
	std::ranges::move(keys(true), std::back_inserter(groups));
	return groups;
}

std::vector<Key> configurationKeys(const LogScore& log)
{
	if (log.configuration.empty()) return {};
	return {{false, false, rankOf(log.configuration), log.configuration, log.platform, log.noise},
	        {false, false, kPaperRows.size() + 1, "all of them", log.platform, log.noise}};
}

std::vector<Key> familyKeys(const LogScore& log)
{
	const std::string& name = log.family.empty() ? log.world : log.family;
	return {{scoredByTracks(log), log.negative, 0, name, log.platform, log.noise}};
}

/** The figures of the last group, which is that of all robots and noises. */
std::optional<Figures> lastOf(const std::vector<Group>& groups)
{
	return groups.empty() ? std::nullopt : std::optional(groups.back().figures);
}
}  // namespace

bool scoredByTracks(const LogScore& log)
{
	return isAbout(log, {"mirror"});
}

Results resultsOf(const std::vector<LogScore>& logs)
{
	Results results;
	results.configurations = grouped(logs, configurationKeys);
	results.families = grouped(logs, familyKeys);
	const auto with_doors =
	    pooledWhere(logs, "all with doors", false, [](const LogScore& log) { return !log.negative; });
	const auto without = pooledWhere(logs, "all without doors", true, [](const LogScore& log) { return log.negative; });
	results.overall = pooledWhere(logs, "all families", false, [](const LogScore&) { return true; });
	results.positives = lastOf(with_doors);
	results.negatives = lastOf(without);
	results.everything = lastOf(results.overall);
	for (const auto* groups : {&with_doors, &without})
		results.pooled.insert(results.pooled.end(), groups->begin(), groups->end());
	results.corners = pooledWhere(logs, "corner doors", false,
	                              [](const LogScore& log) { return !log.negative && isAbout(log, {"corner"}); });
	results.hazards =
	    pooledWhere(logs, "hazards", true,
	                [](const LogScore& log) {
		                return log.negative && isAbout(log, {"glass", "black", "closed", "stair", "shaft", "window"});
	                });
	for (const LogScore& log : logs)
		if (!log.has_truth && log.error.empty()) results.without_truth.push_back(&log);
	return results;
}
}  // namespace explore::evaluation

#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/evaluation/compare_text.h>
#include <explore/evaluation/text_table.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <sstream>

namespace explore::evaluation
{
namespace
{
constexpr double kPoints = 100.0, kRounding_points = 1e-9;
constexpr std::string_view kValueSuffix = ".value";

std::string percent(const std::optional<double>& value)
{
	return value ? mrpt::format("%.2f", kPoints * *value) : "-";
}

std::string points(const std::optional<double>& value)
{
	return value ? mrpt::format("%+.2f", kPoints * *value) : "-";
}

std::string points(const std::optional<Interval>& interval)
{
	return interval ? mrpt::format("%+.2f..%+.2f", kPoints * interval->low, kPoints * interval->high) : "-";
}

std::string summary(const RunComparison& comparison)
{
	std::string text = std::to_string(comparison.scenes) + " scenes";
	if (comparison.unpaired > 0) text += ", " + std::to_string(comparison.unpaired) + " without a pair";
	return text;
}

/** Lines: figures; columns: base, then other, difference and interval of each run. */
std::string figureTable(const RunComparison& comparison)
{
	TextTable table({"<", "base %", "other %", "points", "95 %"});
	const auto figures = comparedFigures();
	for (std::size_t i = 0; i < figures.size(); ++i)
	{
		const Difference& difference = comparison.figures[i];
		if (!difference.base && !difference.other) continue;
		table.row({std::string(figures[i].title), percent(difference.base), percent(difference.other),
		           points(difference.difference), points(difference.interval)});
	}
	return comparison.run + " (" + summary(comparison) + ")\n" + table.text() + "\n";
}

std::string overview(const std::string& base, const std::vector<RunComparison>& comparisons)
{
	const auto figures = comparedFigures();
	std::vector<std::size_t> shown;
	for (std::size_t i = 0; i < figures.size(); ++i)
		if (std::ranges::any_of(comparisons, [&](const RunComparison& run) { return run.figures[i].base.has_value(); }))
			shown.push_back(i);
	std::vector<std::string> titles{"<"};
	for (const std::size_t i : shown) titles.emplace_back(figures[i].title);
	TextTable table(titles);
	std::vector<std::string> base_row{base + " (%)"};
	for (const std::size_t i : shown) base_row.push_back(percent(comparisons.front().figures[i].base));
	table.row(base_row);
	for (const RunComparison& run : comparisons)
	{
		std::vector<std::string> row{run.run};
		for (const std::size_t i : shown) row.push_back(points(run.figures[i].difference));
		table.row(row);
	}
	return "What each run changes against " + base + ", in points\n" + table.text() + "\n";
}

/** A figure of a family that changed for sure. */
struct Change
{
	const GroupComparison* family;
	const Difference* difference;
	std::string_view title;
};

std::string changesTable(const RunComparison& run)
{
	constexpr std::size_t kMost = 12;
	const auto figures = comparedFigures();
	std::vector<Change> changes;
	for (const GroupComparison& family : run.families)
		for (std::size_t i = 0; i < figures.size(); ++i)
			if (const auto& interval = family.figures[i].interval; interval && interval->low * interval->high > 0.0)
				changes.push_back({&family, &family.figures[i], figures[i].title});
	std::ranges::stable_sort(changes, [](const Change& a, const Change& b)
	                         { return std::abs(*a.difference->difference) > std::abs(*b.difference->difference); });
	TextTable table({"<family", "<robot", "<noise", "<figure", "base %", "other %", "points", "95 %"});
	for (std::size_t i = 0; i < std::min(kMost, changes.size()); ++i)
	{
		const auto& [family, difference, title] = changes[i];
		table.row({family->family, family->platform, family->noise, std::string(title), percent(difference->base),
		           percent(difference->other), points(difference->difference), points(difference->interval)});
	}
	if (table.empty()) return "";
	std::string text = run.run + ": families that changed most";
	if (changes.size() > kMost) text += ", of " + std::to_string(changes.size());
	return text + "\n" + table.text() + "\n";
}

Json differencesJson(const std::vector<Difference>& differences)
{
	Json result = Json::object();
	const auto figures = comparedFigures();
	for (std::size_t i = 0; i < figures.size(); ++i)
	{
		const Difference& difference = differences[i];
		if (!difference.base && !difference.other) continue;
		Json interval;
		if (difference.interval)
			interval = {jsonNumber(difference.interval->low), jsonNumber(difference.interval->high)};
		result[std::string(figures[i].name)] = {{"base", jsonOrNull(difference.base)},
		                                        {"other", jsonOrNull(difference.other)},
		                                        {"difference", jsonOrNull(difference.difference)},
		                                        {"interval", interval}};
	}
	return result;
}

CostLimit parseCostLimit(const std::string& part)
{
	constexpr double kNone = -1.0;
	const auto equals = part.find('=');
	CostLimit limit{part.substr(0, equals), false, kNone};
	limit.by_value = limit.name.ends_with(kValueSuffix);
	if (limit.by_value) limit.name.resize(limit.name.size() - kValueSuffix.size());
	if (equals != std::string::npos) limit.points = parseNumber(part.substr(equals + 1)).value_or(kNone);
	const auto figures = comparedFigures();
	const bool known = std::ranges::find(figures, limit.name, &ComparedFigure::name) != figures.end();
	if (!known || !(limit.points >= 0.0 && limit.points <= kPoints))
		throw ConfigError("--cost: \"" + part + "\"; accepted: NAME=POINTS with a number from 0 to 100 and a name of " +
		                  costLimitNames());
	return limit;
}

/** "" where it costs less. */
std::string excessText(const CostLimit& limit, const RunComparison& run)
{
	const auto figures = comparedFigures();
	const auto at = std::ranges::find(figures, limit.name, &ComparedFigure::name) - figures.begin();
	const Difference& difference = run.figures[static_cast<std::size_t>(at)];
	if (!difference.difference || !difference.interval) return "";
	const bool large = figures[static_cast<std::size_t>(at)].large;
	const double end = limit.by_value ? *difference.difference
	                   : large        ? difference.interval->low
	                                  : difference.interval->high;
	if (kPoints * (large ? -end : end) <= limit.points + kRounding_points) return "";
	return run.run + ": " + limit.name + ": " + points(difference.difference) + " points, 95 % interval " +
	       points(difference.interval) + "; accepted: worse by at most " + formatNumber(limit.points) +
	       (limit.by_value ? " points" : " points at the worse end of the interval");
}
}  // namespace

std::string comparisonText(const std::string& base, const std::vector<RunComparison>& comparisons)
{
	std::string text = overview(base, comparisons);
	for (const RunComparison& run : comparisons) text += figureTable(run) + changesTable(run);
	text.pop_back();  // the empty line after the last table
	return text;
}

std::string comparisonJson(const std::string& base, const std::vector<RunComparison>& comparisons)
{
	Json runs = Json::array();
	for (const RunComparison& run : comparisons)
	{
		Json families = Json::array();
		for (const GroupComparison& family : run.families)
			families.push_back({{"family", family.family},
			                    {"platform", family.platform},
			                    {"noise", family.noise},
			                    {"figures", differencesJson(family.figures)}});
		runs.push_back({{"run", run.run},
		                {"scenes", run.scenes},
		                {"unpaired", run.unpaired},
		                {"figures", differencesJson(run.figures)},
		                {"families", families}});
	}
	return jsonText({{"schema", 1}, {"base", base}, {"runs", runs}}, 1) + "\n";
}

std::string costLimitNames()
{
	std::string names;
	for (const ComparedFigure& figure : comparedFigures()) names.append(names.empty() ? "" : ", ").append(figure.name);
	return names + " (NAME.value: the measured difference instead of the worse end of its 95 % interval)";
}

std::vector<CostLimit> parseCostLimits(const std::string& text)
{
	std::vector<CostLimit> limits;
	std::istringstream parts(text);
	for (std::string part; std::getline(parts, part, ',');) limits.push_back(parseCostLimit(part));
	if (limits.empty() || text.ends_with(',')) limits.push_back(parseCostLimit(""));
	return limits;
}

std::vector<std::string> exceededLimits(const std::vector<CostLimit>& limits,
                                        const std::vector<RunComparison>& comparisons)
{
	std::vector<std::string> lines;
	for (const RunComparison& run : comparisons)
		for (const CostLimit& limit : limits)
			if (auto text = excessText(limit, run); !text.empty()) lines.push_back(std::move(text));
	return lines;
}
}  // namespace explore::evaluation

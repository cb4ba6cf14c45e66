#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/evaluation/requirements.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <sstream>

namespace explore::evaluation
{
namespace
{
constexpr std::string_view kValueSuffix = ".value";

struct Requirable
{
	std::string_view name;
	bool large;  ///< must be at least the bound, else at most
	std::optional<Rate> (*of)(const Results&);
};

template <std::optional<Rate> Figures::*Member>
std::optional<Rate> ofEverything(const Results& results)
{
	return results.everything ? (*results.everything).*Member : std::nullopt;
}

template <std::optional<Rate> Figures::*Member>
std::optional<Rate> ofNegatives(const Results& results)
{
	return results.negatives ? (*results.negatives).*Member : std::nullopt;
}

template <std::optional<Rate> DoorFigures::*Member>
std::optional<Rate> ofPositives(const Results& results)
{
	return results.positives ? results.positives->main().*Member : std::nullopt;
}

constexpr std::array<Requirable, 8> kRequirables{{
    {"precision", true, ofPositives<&DoorFigures::precision>},
    {"recall", true, ofPositives<&DoorFigures::recall>},
    {"false_alarms", false, ofNegatives<&Figures::false_alarm_frames>},
    {"reports", false, ofNegatives<&Figures::report_frames>},
    {"direction_given", true, ofEverything<&Figures::direction_given>},
    {"direction_null", true, ofEverything<&Figures::direction_null>},
    {"headings", true, ofEverything<&Figures::good_headings>},
    {"collisions", false, ofEverything<&Figures::collisions>},
}};

bool asksForValue(const std::string& name)
{
	return name.ends_with(kValueSuffix);
}

const Requirable* requirableNamed(std::string_view name)
{
	if (name.ends_with(kValueSuffix)) name.remove_suffix(kValueSuffix.size());
	const auto found = std::ranges::find(kRequirables, name, &Requirable::name);
	return found == kRequirables.end() ? nullptr : found;
}

Requirement parseRequirement(const std::string& part)
{
	const auto equals = part.find('=');
	const std::string name = part.substr(0, equals);
	const auto bound = equals == std::string::npos ? std::nullopt : parseNumber(part.substr(equals + 1));
	if (requirableNamed(name) == nullptr || !bound || *bound < 0.0 || *bound > 1.0)
		throw ConfigError("--require: \"" + part +
		                  "\"; accepted: NAME=NUMBER with a number from 0 to 1 and a name of " + requirementNames());
	return {name, *bound};
}

/** "" where it is met. */
std::string missText(const Requirement& requirement, const Results& results)
{
	const Requirable& figure = *requirableNamed(requirement.name);
	const bool by_value = asksForValue(requirement.name);
	const auto rate = figure.of(results);
	std::ostringstream text;
	text.precision(4);
	text << std::fixed << requirement.name << ": ";
	if (rate)
	{
		const double end = figure.large ? rate->low : rate->high;
		const double counts = by_value ? rate->value : end;
		if (figure.large ? counts >= requirement.bound : counts <= requirement.bound) return "";
		text << "measured " << rate->value << " (" << rate->good << " of " << rate->all << "), 95 % interval "
		     << rate->low << " to " << rate->high;
	}
	else
		text << "not measured: these logs have no case of it";
	text << "; required: " << (figure.large ? "at least " : "at most ") << formatNumber(requirement.bound);
	if (!by_value) text << " at the " << (figure.large ? "lower" : "upper") << " end of the interval";
	return text.str();
}
}  // namespace

std::string requirementNames()
{
	std::string names;
	for (const Requirable& figure : kRequirables) names.append(names.empty() ? "" : ", ").append(figure.name);
	return names + " (NAME.value: the measured value instead of the end of its 95 % interval)";
}

std::vector<Requirement> parseRequirements(const std::string& text)
{
	std::vector<Requirement> requirements;
	std::istringstream parts(text);
	for (std::string part; std::getline(parts, part, ',');) requirements.push_back(parseRequirement(part));
	if (requirements.empty() || text.ends_with(',')) requirements.push_back(parseRequirement(""));
	return requirements;
}

std::vector<std::string> missedRequirements(const std::vector<Requirement>& requirements, const Results& results)
{
	std::vector<std::string> missed;
	for (const Requirement& requirement : requirements)
		if (auto text = missText(requirement, results); !text.empty()) missed.push_back(std::move(text));
	return missed;
}
}  // namespace explore::evaluation

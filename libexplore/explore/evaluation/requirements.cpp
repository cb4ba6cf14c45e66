#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/evaluation/requirements.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

namespace explore::evaluation
{
namespace
{
constexpr std::string_view kValueSuffix = ".value", kEach = "each";

/** The logs that a figure is over. */
enum class Over
{
	positives,
	negatives,
	everything,
	corners,
	hazards,
};

struct Requirable
{
	std::string_view name;
	bool large;  ///< must be at least the bound, else at most
	Over over;
	std::optional<Rate> (*of)(const Figures&);
};

template <std::optional<Rate> Figures::*Member>
std::optional<Rate> rateIn(const Figures& figures)
{
	return figures.*Member;
}

template <std::optional<Rate> DoorFigures::*Member>
std::optional<Rate> doorRateIn(const Figures& figures)
{
	return figures.main().*Member;
}

/** A figure that is no share of counts. */
std::optional<Rate> measured(const std::optional<double>& value, const std::optional<Interval>& interval,
                             double factor = 1.0)
{
	if (!value || !interval) return std::nullopt;
	return Rate{factor * *value, factor * interval->low, factor * interval->high, 0, 0};
}

template <HitFigures Figures::*Hits, ErrorFigures HitFigures::*Error>
std::optional<Rate> medianIn(const Figures& figures)
{
	const ErrorFigures& error = (figures.*Hits).*Error;
	return measured(error.median, error.interval);
}

std::optional<Rate> directionMedianIn(const Figures& figures)
{
	return measured(figures.direction_rad.median, figures.direction_rad.interval, 180.0 / std::numbers::pi);
}

std::optional<Rate> calibrationIn(const Figures& figures)
{
	return measured(figures.confidence.calibration_error, figures.confidence.calibration_interval);
}

std::optional<Rate> aurocIn(const Figures& figures)
{
	return measured(figures.confidence.auroc, figures.confidence.auroc_interval);
}

constexpr std::array<Requirable, 22> kRequirables{{
    {"precision", true, Over::positives, doorRateIn<&DoorFigures::precision>},
    {"recall", true, Over::positives, doorRateIn<&DoorFigures::recall>},
    {"false_alarms", false, Over::negatives, rateIn<&Figures::false_alarm_frames>},
    {"reports", false, Over::negatives, rateIn<&Figures::report_frames>},
    {"direction_given", true, Over::everything, rateIn<&Figures::direction_given>},
    {"direction_null", true, Over::everything, rateIn<&Figures::direction_null>},
    {"headings", true, Over::everything, rateIn<&Figures::good_headings>},
    {"collisions", false, Over::everything, rateIn<&Figures::collisions>},
    {"overall_precision", true, Over::everything, doorRateIn<&DoorFigures::precision>},
    {"narrow_recall", true, Over::positives, rateIn<&Figures::narrow_recall>},
    {"corner_recall", true, Over::corners, doorRateIn<&DoorFigures::recall>},
    {"open_alarms", false, Over::negatives, rateIn<&Figures::open_frames>},
    {"hazard_open", false, Over::hazards, rateIn<&Figures::open_frames>},
    {"direction_close", true, Over::everything, rateIn<&Figures::direction_close>},
    {"direction_error", false, Over::everything, directionMedianIn},
    {"width_error", false, Over::positives, medianIn<&Figures::hits, &HitFigures::width_m>},
    {"center_error", false, Over::positives, medianIn<&Figures::hits, &HitFigures::center_m>},
    {"near_width_error", false, Over::positives, medianIn<&Figures::near_hits, &HitFigures::width_m>},
    {"near_center_error", false, Over::positives, medianIn<&Figures::near_hits, &HitFigures::center_m>},
    {"near_along_error", false, Over::positives, medianIn<&Figures::near_hits, &HitFigures::along_m>},
    {"calibration_error", false, Over::everything, calibrationIn},
    {"auroc", true, Over::everything, aurocIn},
}};

const Requirable* requirableNamed(std::string_view name)
{
	const auto found = std::ranges::find(kRequirables, name, &Requirable::name);
	return found == kRequirables.end() ? nullptr : found;
}

Requirement parseRequirement(const std::string& part)
{
	Requirement requirement;
	const auto equals = part.find('=');
	std::string name = part.substr(0, equals);
	requirement.by_value = name.ends_with(kValueSuffix);
	if (requirement.by_value) name.resize(name.size() - kValueSuffix.size());
	const auto at = name.find('@');
	const bool whole = at == std::string::npos;
	requirement.name = name.substr(0, at);
	if (!whole) requirement.family = name.substr(at + 1);
	constexpr double kNone = -1.0;
	const double bound = equals == std::string::npos ? kNone : parseNumber(part.substr(equals + 1)).value_or(kNone);
	const bool known = requirableNamed(requirement.name) != nullptr && (whole || !requirement.family.empty());
	if (!known || !(bound >= 0.0 && bound <= 1.0))
		throw ConfigError("--require: \"" + part +
		                  "\"; accepted: NAME=NUMBER with a number from 0 to 1 and a name of " + requirementNames());
	requirement.bound = bound;
	return requirement;
}

/** Figures with what they are of. */
struct Measurement
{
	std::string of;
	std::optional<Rate> rate;
};

bool belongs(const Group& group, const Requirable& figure, const std::string& family)
{
	if (family != kEach) return group.name == family;
	if (group.by_tracks) return false;
	if (figure.over == Over::positives) return !group.negative;
	return figure.over == Over::everything || (figure.over == Over::negatives && group.negative);
}

const Figures* wholeOf(const Results& results, Over over)
{
	const auto pointer = [](const auto& figures) { return figures ? &*figures : nullptr; };
	const auto last = [](const auto& groups) { return groups.empty() ? nullptr : &groups.back().figures; };
	switch (over)
	{
		case Over::positives:
			return pointer(results.positives);
		case Over::negatives:
			return pointer(results.negatives);
		case Over::everything:
			return pointer(results.everything);
		case Over::corners:
			return last(results.corners);
		case Over::hazards:
			return last(results.hazards);
	}
	return nullptr;
}

/** What the requirement asks for; of families those in which it was measured. */
std::vector<Measurement> measurementsFor(const Requirement& requirement, const Results& results)
{
	const Requirable& figure = *requirableNamed(requirement.name);
	std::vector<Measurement> found;
	if (requirement.family.empty())
	{
		const Figures* figures = wholeOf(results, figure.over);
		found.push_back({"", figures != nullptr ? figure.of(*figures) : std::nullopt});
		return found;
	}
	for (const Group& group : results.families)
		if (belongs(group, figure, requirement.family))
			if (auto rate = figure.of(group.figures))
				found.push_back({" of " + group.name + ", " + group.platform + ", " + group.noise, rate});
	if (found.empty()) found.push_back({"", std::nullopt});
	return found;
}

/** "" where it is met. */
std::string missText(const Requirement& requirement, const Measurement& measurement)
{
	const Requirable& figure = *requirableNamed(requirement.name);
	const auto& rate = measurement.rate;
	std::ostringstream text;
	text.precision(4);
	text << std::fixed << requirement.text() << measurement.of << ": ";
	if (rate)
	{
		const double end = figure.large ? rate->low : rate->high;
		const double counts = requirement.by_value ? rate->value : end;
		if (figure.large ? counts >= requirement.bound : counts <= requirement.bound) return "";
		text << "measured " << rate->value;
		if (rate->all > 0) text << " (" << rate->good << " of " << rate->all << ")";
		text << ", 95 % interval " << rate->low << " to " << rate->high;
	}
	else
		text << "not measured: these logs have no case of it";
	text << "; required: " << (figure.large ? "at least " : "at most ") << formatNumber(requirement.bound);
	if (!requirement.by_value) text << " at the " << (figure.large ? "lower" : "upper") << " end of the interval";
	return text.str();
}
}  // namespace

std::string Requirement::text() const
{
	std::string written = name;
	if (!family.empty()) written.append("@").append(family);
	return by_value ? written.append(kValueSuffix) : written;
}

std::string requirementNames()
{
	std::string names;
	for (const Requirable& figure : kRequirables) names.append(names.empty() ? "" : ", ").append(figure.name);
	return names +
	       " (NAME@FAMILY: that family alone, NAME@each: each family; with .value at the end: the measured value "
	       "instead of the end of its 95 % interval)";
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
		for (const Measurement& measurement : measurementsFor(requirement, results))
			if (auto text = missText(requirement, measurement); !text.empty()) missed.push_back(std::move(text));
	return missed;
}
}  // namespace explore::evaluation

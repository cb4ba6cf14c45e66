#include <explore/evaluation/tally.h>

#include <cmath>

namespace explore::evaluation
{
namespace
{
constexpr std::array kVerdictList{Verdict::open,    Verdict::ajar, Verdict::closed,  Verdict::blocked,
                                  Verdict::passage, Verdict::drop, Verdict::partial, Verdict::unknown};
static_assert(kVerdictList.size() == kVerdicts);

/** Counts of a tolerance, named after it in centimetres. */
constexpr std::array<std::array<std::string_view, 3>, kCenterTolerances_m.size()> kDoorNames{
    {{"hits_15", "false_alarms_15", "misses_15"},
     {"hits_30", "false_alarms_30", "misses_30"},
     {"hits_45", "false_alarms_45", "misses_45"}}};

/** Every plain count with its name. */
template <class SomeTally, class Visit>
void eachCount(SomeTally& tally, const Visit& visit)
{
	visit("frames", tally.frames);
	for (std::size_t i = 0; i < tally.doors.size(); ++i)
	{
		visit(kDoorNames[i][0], tally.doors[i].hits);
		visit(kDoorNames[i][1], tally.doors[i].false_alarms);
		visit(kDoorNames[i][2], tally.doors[i].misses);
	}
	visit("false_alarm_frames", tally.false_alarm_frames);
	visit("report_frames", tally.report_frames);
	visit("open_frames", tally.open_frames);
	visit("open_reports", tally.open_reports);
	visit("unscored_frames", tally.unscored_frames);
	visit("narrow_hits", tally.narrow_hits);
	visit("narrow_misses", tally.narrow_misses);
	visit("corridor_frames", tally.corridor_frames);
	visit("corridor_given", tally.corridor_given);
	visit("corridor_close", tally.corridor_close);
	visit("plain_frames", tally.plain_frames);
	visit("plain_null", tally.plain_null);
	visit("heading_frames", tally.heading_frames);
	visit("good_headings", tally.good_headings);
	visit("stops", tally.stops);
	visit("good_stops", tally.good_stops);
	visit("collisions", tally.collisions);
}

/** Every list of errors with its name. */
template <class SomeTally, class Visit>
void eachErrorList(SomeTally& tally, const Visit& visit)
{
	visit("width_errors", tally.width_errors_m);
	visit("center_errors", tally.center_errors_m);
	visit("along_errors", tally.along_errors_m);
	visit("across_errors", tally.across_errors_m);
	visit("hit_distances", tally.hit_distances_m);
	visit("direction_errors", tally.direction_errors_rad);
}

template <class SomeTally, class Visit>
void eachCauseList(SomeTally& tally, const Visit& visit)
{
	visit("false_alarm_causes", tally.false_alarm_causes);
	visit("miss_causes", tally.miss_causes);
}

Json confusionJson(const Confusion& confusion)
{
	Json rows = Json::array();
	for (const auto& row : confusion) rows.push_back(row);
	return rows;
}

Json candidatesJson(const std::vector<Candidate>& candidates)
{
	Json result = Json::array();
	for (const Candidate& candidate : candidates)
		result.push_back(Json::array({jsonNumber(candidate.confidence), candidate.right ? 1 : 0}));
	return result;
}

std::vector<Candidate> candidatesOf(const JsonPlace& place)
{
	std::vector<Candidate> candidates;
	for (const JsonPlace& item : place.items())
	{
		const auto pair = item.numbers(2, {0.0, 1.0});
		candidates.push_back({pair[0], pair[1] != 0.0});
	}
	return candidates;
}

/** Every hit has its value in each of the lists. */
void checkHits(const JsonPlace& place, const Tally& tally)
{
	const std::size_t hits = tally.width_errors_m.size();
	for (const auto* list :
	     {&tally.center_errors_m, &tally.along_errors_m, &tally.across_errors_m, &tally.hit_distances_m})
		if (list->size() != hits) place.refuse("as many errors and distances of each kind as there are hits");
}

void readConfusion(const JsonPlace& place, Confusion& confusion)
{
	const auto rows = place.items();
	if (rows.size() != confusion.size()) place.refuse("9 rows");
	for (std::size_t i = 0; i < rows.size(); ++i)
	{
		const auto cells = rows[i].items();
		if (cells.size() != confusion.size()) rows[i].refuse("9 counts");
		for (std::size_t j = 0; j < cells.size(); ++j) confusion[i][j] = cells[j].count();
	}
}
}  // namespace

std::string_view verdictName(std::size_t index)
{
	return index < kVerdicts ? nameOf(kVerdictList.at(index)) : "none";
}

void Tally::add(const Tally& other)
{
	std::vector<const Count*> counts;
	eachCount(other, [&](const auto& /*name*/, const Count& count) { counts.push_back(&count); });
	std::size_t next = 0;
	eachCount(*this, [&](const auto& /*name*/, Count& count) { count += *counts[next++]; });
	std::vector<const std::vector<double>*> lists;
	eachErrorList(other, [&](const auto& /*name*/, const auto& list) { lists.push_back(&list); });
	next = 0;
	eachErrorList(*this,
	              [&](const auto& /*name*/, auto& list)
	              {
		              const auto& more = *lists[next++];
		              list.insert(list.end(), more.begin(), more.end());
	              });
	candidates.insert(candidates.end(), other.candidates.begin(), other.candidates.end());
	for (const auto& [cause, count] : other.false_alarm_causes) false_alarm_causes[cause] += count;
	for (const auto& [cause, count] : other.miss_causes) miss_causes[cause] += count;
	for (std::size_t i = 0; i < confusion.size(); ++i)
		for (std::size_t j = 0; j < confusion.size(); ++j) confusion[i][j] += other.confusion[i][j];
}

double rounded(double error)
{
	constexpr double kSteps = 1e4;
	return std::round(error * kSteps) / kSteps;
}

Json tallyJson(const Tally& tally)
{
	Json result = Json::object();
	eachCount(tally,
	          [&](std::string_view name, Count count)
	          {
		          if (count > 0) result[std::string(name)] = count;
	          });
	eachErrorList(tally,
	              [&](std::string_view name, const std::vector<double>& errors)
	              {
		              if (errors.empty()) return;
		              Json& list = result[std::string(name)] = Json::array();
		              for (const double error : errors) list.push_back(jsonNumber(error));
	              });
	eachCauseList(tally,
	              [&](std::string_view name, const std::map<std::string, Count>& causes)
	              {
		              for (const auto& [cause, count] : causes) result[std::string(name)][cause] = count;
	              });
	if (!tally.candidates.empty()) result["candidates"] = candidatesJson(tally.candidates);
	if (tally.confusion != Confusion{}) result["confusion"] = confusionJson(tally.confusion);
	return result;
}

Tally tallyOf(const JsonPlace& place)
{
	Tally tally;
	for (const auto& [key, value] : place.entries())
	{
		bool known = false;
		const auto take = [&, &this_key = key](std::string_view name, const auto& read)
		{
			if (this_key != name) return;
			known = true;
			read();
		};
		const JsonPlace& at = value;
		eachCount(tally, [&](std::string_view name, Count& count) { take(name, [&] { count = at.count(); }); });
		eachErrorList(tally, [&](std::string_view name, std::vector<double>& errors)
		              { take(name, [&] { errors = at.numbers(); }); });
		eachCauseList(tally,
		              [&](std::string_view name, std::map<std::string, Count>& causes)
		              {
			              take(name,
			                   [&]
			                   {
				                   for (const auto& [cause, count] : at.entries()) causes[cause] = count.count();
			                   });
		              });
		take("candidates", [&] { tally.candidates = candidatesOf(at); });
		take("confusion", [&] { readConfusion(at, tally.confusion); });
		if (!known) at.refuse("no such key");
	}
	checkHits(place, tally);
	return tally;
}
}  // namespace explore::evaluation

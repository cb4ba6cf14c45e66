#include <explore/sinks/exploration_summary.h>
#include <explore/sinks/html_text.h>
#include <explore/sinks/report/plan_record.h>
#include <explore/sinks/report/short_numbers.h>

#include <utility>

namespace explore
{
namespace
{
Json doorMark(const DoorTrack& track)
{
	const DoorPlace& place = track.place;
	return {shortNumber(place.center_in_map.x(), 2),
	        shortNumber(place.center_in_map.y(), 2),
	        shortNumber(place.normal_rad, 2),
	        shortNumber(place.width_m, 2),
	        nameOf(verdictOf(track)),
	        shortNumber(confidenceOf(track), 2),
	        track.visited};
}

Json corridorMark(const CorridorTrack& track)
{
	const Eigen::Vector2d from = track.at(track.from_m), to = track.at(track.to_m);
	return {shortNumber(from.x(), 2), shortNumber(from.y(), 2), shortNumber(to.x(), 2), shortNumber(to.y(), 2),
	        track.width_m ? shortNumber(*track.width_m, 2) : Json()};
}

/** The confirmed ones. */
template <class Tracks, class Text>
std::map<int, Json> marksOf(const Tracks& tracks, Text text)
{
	std::map<int, Json> marks;
	for (const auto& track : tracks)
		if (track.existence.confirmed) marks.emplace(track.number, text(track));
	return marks;
}

/** Those of `to` that `from` has not, or has otherwise, each with its track before it. */
Json newMarks(const std::map<int, Json>& from, const std::map<int, Json>& to)
{
	Json list = Json::array();
	for (const auto& [track, mark] : to)
	{
		const auto before = from.find(track);
		if (before != from.end() && before->second == mark) continue;
		Json entry = Json::array({track});
		for (const Json& value : mark) entry.push_back(value);
		list.push_back(std::move(entry));
	}
	return list;
}

Json goneMarks(const std::map<int, Json>& from, const std::map<int, Json>& to)
{
	Json list = Json::array();
	for (const auto& [track, mark] : from)
		if (!to.contains(track)) list.push_back(track);
	return list;
}

void applyMarks(const Json& changed, const Json& gone, std::map<int, Json>& marks)
{
	for (const Json& track : gone) marks.erase(track.get<int>());
	for (const Json& entry : changed)
	{
		Json mark = entry;
		mark.erase(0);
		marks[entry.at(0).get<int>()] = std::move(mark);
	}
}
}  // namespace

PlanSnapshot planSnapshotOf(const FrontierMemory& memory)
{
	return {planGridOf(memory), marksOf(memory.doors.tracks, doorMark), marksOf(memory.corridors.tracks, corridorMark),
	        knownFreeArea(memory), std::nullopt};
}

std::string planRecord(const PlanSnapshot& from, const PlanSnapshot& to, const PlanTime& time)
{
	const PlanGrid& grid = to.grid;
	return jsonText({{"i", time.frame},
	                 {"t", shortNumber(time.t_s, 3)},
	                 {"free", shortNumber(to.known_free_m2, 2)},
	                 {"cover", to.coverage ? shortNumber(*to.coverage, 4) : Json()},
	                 {"at", {grid.first_x, grid.first_y, grid.columns, grid.rows, jsonNumber(grid.cell_m)}},
	                 {"cells", base64(planChanges(from.grid, grid))},
	                 {"doors", newMarks(from.doors, to.doors)},
	                 {"gone", goneMarks(from.doors, to.doors)},
	                 {"corridors", newMarks(from.corridors, to.corridors)},
	                 {"ended", goneMarks(from.corridors, to.corridors)}});
}

PlanTime applyPlanRecord(const std::string& record, PlanSnapshot& snapshot)
{
	const Json line = Json::parse(record);
	const Json& at = line.at("at");
	PlanGrid grid{at.at(4), at.at(0), at.at(1), at.at(2), at.at(3), {}};
	applyPlanChanges(snapshot.grid, bytesOfBase64(line.at("cells").get<std::string>()), grid);
	snapshot.grid = std::move(grid);
	applyMarks(line.at("doors"), line.at("gone"), snapshot.doors);
	applyMarks(line.at("corridors"), line.at("ended"), snapshot.corridors);
	snapshot.known_free_m2 = line.at("free");
	snapshot.coverage.reset();
	if (!line.at("cover").is_null()) snapshot.coverage = line.at("cover").get<double>();
	return {line.at("i"), line.at("t")};
}
}  // namespace explore

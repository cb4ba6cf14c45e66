#include <explore/evaluation/worst_frames.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace explore::evaluation
{
namespace
{
constexpr std::size_t kMostOfAKind = 2, kMost = 96;
constexpr double kCollision = 4.0, kFalseAlarm = 3.0, kMiss = 2.0, kBadHeading = 0.5;

std::string doorText(const ScoreInput& input, const TruthDoor& door)
{
	const Eigen::Vector3d camera =
	    isometryOf(input.truth_frame.map_from_robot + mountOf(input.truth, input.truth_frame)).translation();
	const double distance_m = (door.center_in_map.head<2>() - camera.head<2>()).norm();
	return mrpt::format("%s, %s, %.2f m wide, %.1f m away, %.0f %% in view", door.id.c_str(),
	                    std::string(nameOf(door.verdict)).c_str(), door.width_m, distance_m,
	                    100.0 * door.visible_share);
}

std::string remarkOn(const ScoreInput& input, const FrameScore& score, const Mistake& mistake)
{
	const bool miss = mistake.pair.outcome == Outcome::miss;
	std::string text = miss
	                       ? "missed: " + doorText(input, input.truth_frame.doors[*mistake.pair.truth])
	                       : mrpt::format("false alarm: %.2f m wide", score.reports[*mistake.pair.report].door.width_m);
	return text.append("; ").append(nameOf(mistake.cause)).append(": ").append(sentenceOf(mistake.cause));
}

std::string headingRemark(const HeadingScore& heading)
{
	if (!heading.chosen) return mrpt::format("heading: stops, though a way scores %.2f m", heading.best);
	return mrpt::format("heading: scores %.2f m of %.2f m%s", *heading.chosen, heading.best,
	                    heading.collision ? ", and meets something within the stopping distance" : "");
}

std::string sceneryOf(const LogScore& log)
{
	return log.family + '\n' + log.world + '\n' + log.platform + '\n' + log.noise;
}

void sortByBadness(std::vector<Selected>& frames)
{
	std::ranges::stable_sort(frames,
	                         [](const Selected& a, const Selected& b)
	                         {
		                         if (a.frame.badness != b.frame.badness) return a.frame.badness > b.frame.badness;
		                         return a.log != b.log ? a.log < b.log : a.frame.frame < b.frame.frame;
	                         });
}
}  // namespace

std::optional<WorstFrame> badFrame(const ScoreInput& input, const FrameScore& score)
{
	WorstFrame frame;
	frame.frame = input.frame.index;
	frame.scene = input.truth_frame.scene;
	for (const Mistake& mistake : score.mistakes)
	{
		frame.badness += mistake.pair.outcome == Outcome::miss ? kMiss : kFalseAlarm;
		if (frame.kind.empty()) frame.kind = nameOf(mistake.cause);
		frame.remarks.push_back(remarkOn(input, score, mistake));
	}
	if (score.heading && (!score.heading->good || score.heading->collision))
	{
		frame.badness += score.heading->collision ? kCollision : kBadHeading;
		if (frame.kind.empty()) frame.kind = score.heading->collision ? "collision" : "heading";
		frame.remarks.push_back(headingRemark(*score.heading));
	}
	return frame.remarks.empty() ? std::nullopt : std::optional(frame);
}

std::vector<Selected> selectWorst(const std::vector<LogScore>& logs)
{
	std::vector<Selected> candidates;
	for (std::size_t i = 0; i < logs.size(); ++i)
		for (const WorstFrame& frame : logs[i].worst) candidates.push_back({i, frame});
	sortByBadness(candidates);

	// By their rank within their scenery: the worst of each, then the second worst of each, ...
	std::map<std::size_t, std::vector<Selected>> by_rank;
	std::map<std::string, std::size_t> of_a_kind, of_a_scenery;
	for (Selected& candidate : candidates)
	{
		const std::string scenery = sceneryOf(logs[candidate.log]);
		if (of_a_kind[scenery + '\n' + candidate.frame.kind]++ < kMostOfAKind)
			by_rank[of_a_scenery[scenery]++].push_back(std::move(candidate));
	}
	std::vector<Selected> chosen;
	for (auto& [rank, frames] : by_rank)
		for (Selected& frame : frames)
			if (chosen.size() < kMost) chosen.push_back(std::move(frame));
	sortByBadness(chosen);
	return chosen;
}

void keepWorst(LogScore& log)
{
	LogScore alone = log;
	alone.scenes.clear();
	std::vector<WorstFrame> kept;
	for (Selected& selected : selectWorst({alone})) kept.push_back(std::move(selected.frame));
	log.worst = std::move(kept);
}

std::filesystem::path pictureName(const std::string& log, std::size_t frame)
{
	constexpr std::size_t kLongest = 80;
	std::string name = std::filesystem::path(log).replace_extension().string();
	if (name.size() > kLongest) name = name.substr(name.size() - kLongest);
	for (char& c : name)
		if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
	std::uint32_t hash = 2166136261U;  // FNV-1a, so that paths that look alike get names of their own
	for (const char c : log) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
	return mrpt::format("%s-%08x-%06zu.jpg", name.c_str(), hash, frame);
}
}  // namespace explore::evaluation

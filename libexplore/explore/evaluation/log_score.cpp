#include <explore/evaluation/log_score.h>

#include <climits>

namespace explore::evaluation
{
namespace
{
Json textsJson(const std::vector<std::string>& texts)
{
	Json result = Json::array();
	for (const std::string& text : texts) result.push_back(text);
	return result;
}

std::vector<std::string> textsOf(const JsonPlace& place)
{
	std::vector<std::string> texts;
	for (const JsonPlace& item : place.items()) texts.push_back(item.text());
	return texts;
}

Json reportsJson(const ReportCounts& counts)
{
	return {{"frames", counts.frames},
	        {"report_frames", counts.report_frames},
	        {"reports", counts.reports},
	        {"positives", counts.positives}};
}

ReportCounts reportsOf(const JsonPlace& place)
{
	return {place.at("frames").count(), place.at("report_frames").count(), place.at("reports").count(),
	        place.at("positives").count()};
}

Json worstJson(const WorstFrame& frame)
{
	return {{"frame", frame.frame},
	        {"scene", frame.scene},
	        {"badness", jsonNumber(frame.badness)},
	        {"kind", frame.kind},
	        {"remarks", textsJson(frame.remarks)}};
}

int sceneOf(const JsonPlace& place)
{
	return static_cast<int>(place.at("scene").count(INT_MAX));
}

WorstFrame worstOf(const JsonPlace& place)
{
	return {place.at("frame").count(), sceneOf(place), place.at("badness").number(), place.at("kind").text(),
	        textsOf(place.at("remarks"))};
}
}  // namespace

void add(LogScore& log, const TruthFrame& truth, const FrameScore& score)
{
	if (log.scenes.empty() || log.scenes.back().scene != truth.scene) log.scenes.push_back({truth.scene, {}});
	log.scenes.back().tally.add(score.tally);
}

Json logJson(const LogScore& log)
{
	Json scenes = Json::array(), worst = Json::array();
	for (const SceneScore& scene : log.scenes)
		scenes.push_back({{"scene", scene.scene}, {"tally", tallyJson(scene.tally)}});
	for (const WorstFrame& frame : log.worst) worst.push_back(worstJson(frame));
	return {{"log", log.log},
	        {"has_truth", log.has_truth},
	        {"world", log.world},
	        {"family", log.family},
	        {"configuration", log.configuration},
	        {"platform", log.platform},
	        {"noise", log.noise},
	        {"negative", log.negative},
	        {"reports", reportsJson(log.reports)},
	        {"unmatched_frames", log.unmatched_frames},
	        {"unread_frames", log.unread_frames},
	        {"damage", log.damage},
	        {"error", log.error},
	        {"remarks", textsJson(log.remarks)},
	        {"frame_rows", log.frame_rows},
	        {"door_rows", log.door_rows},
	        {"worst", worst},
	        {"scenes", scenes}};
}

LogScore logOf(const JsonPlace& place)
{
	LogScore log;
	log.log = place.at("log").text();
	log.has_truth = place.at("has_truth").boolean();
	log.world = place.at("world").text();
	log.family = place.at("family").text();
	log.configuration = place.at("configuration").text();
	log.platform = place.at("platform").text();
	log.noise = place.at("noise").text();
	log.negative = place.at("negative").boolean();
	log.reports = reportsOf(place.at("reports"));
	log.unmatched_frames = place.at("unmatched_frames").count();
	log.unread_frames = place.at("unread_frames").count();
	log.damage = place.at("damage").text();
	log.error = place.at("error").text();
	log.remarks = textsOf(place.at("remarks"));
	log.frame_rows = place.at("frame_rows").count();
	log.door_rows = place.at("door_rows").count();
	for (const JsonPlace& item : place.at("worst").items()) log.worst.push_back(worstOf(item));
	for (const JsonPlace& item : place.at("scenes").items())
		log.scenes.push_back({sceneOf(item), tallyOf(item.at("tally"))});
	return log;
}
}  // namespace explore::evaluation

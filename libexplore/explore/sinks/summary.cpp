#include <explore/sinks/json_values.h>
#include <explore/sinks/summary.h>
#include <mrpt/core/format.h>

#include <algorithm>

namespace explore
{
namespace
{
constexpr int kSchema = 1;

Json sourceJson(const InputSummary& input, std::size_t frames)
{
	return {{"kind", input.kind},
	        {"path", input.path},
	        {"frames", frames},
	        {"lost_bytes", input.lost_bytes},
	        {"lost_objects", input.lost_objects},
	        {"skipped_frames", input.skipped_frames},
	        {"dropped_frames", input.dropped_frames},
	        {"oldest_frame_ms", jsonOrNull(input.oldest_frame_ms)},
	        {"away_frames", input.away_frames},
	        {"damage", jsonOrNull(input.damage)},
	        {"sensor", jsonOrNull(input.sensor)},
	        {"sensors_found", input.sensors_found},
	        {"pose_from", nameOf(input.pose_origin)},
	        {"identity_mount", input.identity_mount}};
}

Json doorsJson(const std::vector<DoorSummary>& doors)
{
	Json list = Json::array();
	for (const DoorSummary& door : doors)
		list.push_back({{"track", door.track},
		                {"center_in_map", jsonVector(door.center_in_map)},
		                {"width", jsonNumber(door.width_m)},
		                {"height", jsonOrNull(door.height_m)},
		                {"verdict", nameOf(door.verdict)},
		                {"confidence", jsonNumber(door.confidence)},
		                {"seen", door.seen},
		                {"visited", door.visited}});
	return list;
}

Json corridorsJson(const std::vector<CorridorSummary>& corridors)
{
	Json list = Json::array();
	for (const CorridorSummary& corridor : corridors)
		list.push_back({{"track", corridor.track},
		                {"point_in_map", jsonVector(corridor.point_in_map)},
		                {"direction_in_map", jsonVector(corridor.direction_in_map)},
		                {"seen", corridor.seen}});
	return list;
}

Json leftOverJson(const std::vector<LeftOver>& left_over)
{
	Json list = Json::array();
	for (const LeftOver& left : left_over)
	{
		list.push_back({{"center_in_map", jsonVector(left.center_in_map)},
		                {"area_m2", jsonNumber(left.area_m2)},
		                {"why", nameOf(left.why)}});
		if (left.passed_by) list.back()["passed_by"] = true;
	}
	return list;
}

Json explorationJson(const RunSummary& summary)
{
	const ExplorationSummary& exploration = summary.exploration;
	return {{"complete", exploration.complete},
	        {"reason", summary.reason},
	        {"known_free_m2", jsonOrNull(exploration.known_free_m2)},
	        {"path_m", jsonOrNull(summary.tally.path_m())},
	        {"time_s", jsonOrNull(summary.tally.time_s())},
	        {"home_error_m", jsonOrNull(exploration.home_error_m)},
	        {"left_over", leftOverJson(exploration.left_over)}};
}

Json truthJson(const TruthSummary& truth)
{
	Json contacts = Json::array();
	for (const Contact& contact : truth.contacts)
		contacts.push_back({{"t", jsonNumber(contact.t_s)}, {"position_in_map", jsonVector(contact.position_in_map)}});
	return {{"collisions", truth.contacts.size()},
	        {"contacts", contacts},
	        {"min_clearance_m", jsonOrNull(truth.min_clearance_m)},
	        {"path_m", jsonNumber(truth.path_m)},
	        {"from_start_m", jsonNumber(truth.from_start_m)},
	        {"goal_flips", truth.goal_flips},
	        {"reachable_m2", jsonNumber(truth.reachable_m2)},
	        {"coverage", jsonOrNull(truth.coverage)}};
}

Json timingJson(const std::map<std::string, StageStatistics>& timing)
{
	Json result = Json::object();
	for (const auto& [stage, statistics] : timing)
		result[stage] = {{"median", jsonNumber(statistics.median_ms)}, {"p99", jsonNumber(statistics.p99_ms)}};
	return result;
}

std::string pathText(const RunTally& tally)
{
	const double time_s = tally.time_s().value_or(0.0);
	if (!tally.path_m()) return mrpt::format("%.1f s, no pose in the input", time_s);
	return mrpt::format("%.1f m in %.1f s", *tally.path_m(), time_s);
}

/** What is known of the building, where there is a memory. */
std::string knownText(const ExplorationSummary& exploration)
{
	if (!exploration.known_free_m2) return "";
	const auto visited = std::count_if(exploration.doors.begin(), exploration.doors.end(),
	                                   [](const DoorSummary& door) { return door.visited; });
	std::string text = mrpt::format("  %.1f m2 of free floor, %zu doors (%d driven through), %zu corridors",
	                                *exploration.known_free_m2, exploration.doors.size(), static_cast<int>(visited),
	                                exploration.corridors.size());
	if (exploration.complete) text += ", nothing left to see";
	return text + '\n';
}

std::string truthText(const TruthSummary& truth)
{
	std::string text = mrpt::format("  truth: %zu collisions, %zu goal flips, %.1f m driven, %.2f m from the start",
	                                truth.contacts.size(), truth.goal_flips, truth.path_m, truth.from_start_m);
	if (truth.min_clearance_m) text += mrpt::format(", nearest to anything %.2f m", *truth.min_clearance_m);
	if (truth.coverage)
		text += mrpt::format("\n  coverage %.1f %% of %.1f m2", 100.0 * *truth.coverage, truth.reachable_m2);
	return text + '\n';
}

std::string lossText(const InputSummary& input)
{
	std::string text;
	if (input.skipped_frames > 0) text += mrpt::format("  unusable frames: %zu\n", input.skipped_frames);
	if (input.dropped_frames > 0)
		text += mrpt::format("  frames passed over for later ones: %zu; the oldest one used was %.0f ms old\n",
		                     input.dropped_frames, input.oldest_frame_ms.value_or(0.0));
	if (input.away_frames > 0)
		text += mrpt::format("  frames without an image, the camera away: %zu\n", input.away_frames);
	if (!input.damage.empty())
		text += mrpt::format("  DAMAGED: %s (lost: %llu bytes, %zu objects)\n", input.damage.c_str(),
		                     static_cast<unsigned long long>(input.lost_bytes), input.lost_objects);
	return text;
}
}  // namespace

void RunTally::add(const DepthFrame& frame, const StepResult& result)
{
	++frames;
	if (result.percepts.ground && result.percepts.ground->seen) ++frames_with_ground;
	if (!result.percepts.doors.empty()) ++frames_with_door;
	if (result.decision.stop) ++frames_stopped;
	doors_in_view = result.percepts.doors.size();
	goal = result.decision.goal.kind;

	if (!m_first) m_first = frame.timestamp;
	m_last = frame.timestamp;
	if (frame.pose_origin == PoseOrigin::none) return;
	const auto& pose = frame.map_from_robot;
	const Eigen::Vector3d position_in_map(pose.x(), pose.y(), pose.z());
	if (m_position_in_map)
		*m_path_m += (position_in_map - *m_position_in_map).norm();
	else
		m_path_m = 0.0;
	m_position_in_map = position_in_map;
}

std::optional<double> RunTally::time_s() const
{
	if (!m_first) return std::nullopt;
	return mrpt::Clock::toDouble(*m_last) - mrpt::Clock::toDouble(*m_first);
}

std::string summaryJson(const RunSummary& summary)
{
	const RunTally& tally = summary.tally;
	Json document{
	    {"schema", kSchema},
	    {"version", summary.version},
	    {"config", jsonOrNull(summary.config)},
	    {"source", sourceJson(summary.input, tally.frames)},
	    {"frames_with_ground", tally.frames_with_ground},
	    {"frames_with_door", tally.frames_with_door},
	    {"frames_stopped", tally.frames_stopped},
	    {"warnings", summary.warnings},
	    {"doors", doorsJson(summary.exploration.doors)},
	    {"corridors", corridorsJson(summary.exploration.corridors)},
	    {"exploration", explorationJson(summary)},
	    {"timing_ms", timingJson(summary.timing)},
	    {"peak_rss_mb", jsonNumber(summary.peak_rss_mb)},
	    {"processor",
	     {{"cpu_s", jsonNumber(summary.processor.cpu_s)}, {"wall_s", jsonNumber(summary.processor.wall_s)}}},
	};
	if (summary.truth) document["truth"] = truthJson(*summary.truth);
	return jsonText(document, 2) + '\n';
}

std::string summaryText(const RunSummary& summary)
{
	const RunTally& tally = summary.tally;
	std::string text = mrpt::format("%zu frames of %s (sensor \"%s\"): %s\n", tally.frames, summary.input.path.c_str(),
	                                summary.input.sensor.c_str(), summary.reason.c_str());
	text += mrpt::format("  floor in %zu, doors in %zu, stop in %zu frames; %s\n", tally.frames_with_ground,
	                     tally.frames_with_door, tally.frames_stopped, pathText(tally).c_str());
	if (const auto total = summary.timing.find(std::string(kTotalStage)); total != summary.timing.end())
		text += mrpt::format("  %.1f ms a frame (median; p99 %.1f), %.0f MB\n", total->second.median_ms,
		                     total->second.p99_ms, summary.peak_rss_mb);
	text += knownText(summary.exploration);
	if (summary.truth) text += truthText(*summary.truth);
	return text + lossText(summary.input);
}
}  // namespace explore

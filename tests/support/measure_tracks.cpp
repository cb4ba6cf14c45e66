// Replays logs with truth through perception, map and door tracks, and prints how many tracks are right.
#include <explore/evaluation/door_pairs.h>
#include <explore/evaluation/statistics.h>
#include <explore/evaluation/truth_file.h>
#include <explore/memory/corridor_sight.h>
#include <explore/memory/corridor_tracks.h>
#include <explore/memory/door_tracks.h>
#include <explore/memory/occupancy.h>
#include <explore/navigation/goal_choice.h>
#include <explore/perception/perceive.h>
#include <explore/sources/source.h>
#include <mrpt/core/Clock.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace explore::test
{
namespace
{
struct Options
{
	bool odometry = false;   ///< the log's poses instead of the true ones
	bool no_map = false;     ///< no objections of the map
	bool no_reveal = false;  ///< walls are not asked for their thickness
	std::vector<std::string> logs;
};

using evaluation::SceneRatio;

void add(SceneRatio& ratio, bool is_good)
{
	++ratio.all;
	ratio.good += is_good ? 1U : 0U;
}

/** One scene's figures, as doc/definitions.md has them. */
struct Score
{
	SceneRatio at_five, at_end;  ///< tracks that can be passed, at their fifth look (or the end), and at the end
	SceneRatio found_at_five;    ///< of the doors that can be passed and had five looks
	SceneRatio reports;          ///< of single frames, that can be passed
	SceneRatio doubles;          ///< tracks beyond the first, and doors that have one
	SceneRatio corridors;        ///< confirmed tracks; along a true corridor
};

/** What the truth says of one door over a scene. */
struct KnownDoor
{
	TruthDoor door;
	bool was_visible = false;
	int looks = 0;
	Viewpoint last_look;
};

/** One scene's memory and what is known about it. */
struct Scene
{
	PerceptionMemory perception;
	std::unique_ptr<Occupancy> map = std::make_unique<Occupancy>(OccupancyConfig());
	DoorTracks doors;
	CorridorTracks corridors;
	std::map<std::string, KnownDoor> known;
	std::vector<double> corridor_directions_rad;
	std::vector<DoorTrack> due;  ///< as they were at their fifth look
};

bool isPositiveTrack(const DoorTrack& track, const RobotConfig& robot)
{
	return track.existence.confirmed && fitsThrough(doorOf(track, Eigen::Isometry3d::Identity()), robot);
}

bool isAt(const DoorPlace& place, double clear_width_m, const TruthDoor& door)
{
	const double error_m =
	    door.verdict == Verdict::ajar ? clear_width_m - door.clear_width_m : place.width_m - door.width_m;
	return (place.center_in_map - door.center_in_map.head<2>()).norm() <= 0.30 && std::abs(error_m) <= 0.25;
}

bool isAtPositive(const Scene& scene, const DoorPlace& place, double clear_width_m)
{
	return std::ranges::any_of(scene.known,
	                           [&](const auto& entry)
	                           {
		                           const TruthDoor& door = entry.second.door;
		                           return (evaluation::isPositive(door) || evaluation::countsNeitherWay(door)) &&
		                                  isAt(place, clear_width_m, door);
	                           });
}

void learnTruth(Scene& scene, const TruthFrame& truth, const Viewpoint& now, const RobotConfig& robot, Score& score)
{
	if (truth.corridor.state != CorridorState::none)
		scene.corridor_directions_rad.push_back(azimuthOf(truth.corridor.direction_in_map));
	for (const TruthDoor& door : truth.doors)
	{
		KnownDoor& known = scene.known[door.id];
		known.door = door;
		if (door.visibility != Visibility::visible || !evaluation::isPositive(door)) continue;
		known.was_visible = true;
		if (known.looks > 0 && !isNewLook(known.last_look, now)) continue;
		known.last_look = now;
		if (++known.looks != 5) continue;
		const bool found = std::ranges::any_of(
		    scene.doors.tracks, [&](const DoorTrack& track)
		    { return isPositiveTrack(track, robot) && isAt(track.place, clearWidthOf(track.belief), door); });
		add(score.found_at_five, found);
		if (!found)
		{
			std::printf("  missed %s at %.2f %.2f %s w %.2f:", door.id.c_str(), door.center_in_map.x(),
			            door.center_in_map.y(), std::string(nameOf(door.verdict)).c_str(), door.width_m);
			for (const DoorTrack& track : scene.doors.tracks)
				if ((track.place.center_in_map - door.center_in_map.head<2>()).norm() < 0.6)
					std::printf(" [%d at %.2f %.2f w %.2f %s %d/%d L %.2f%s]", track.number,
					            track.place.center_in_map.x(), track.place.center_in_map.y(), track.place.width_m,
					            std::string(nameOf(verdictOf(track))).c_str(), track.existence.hits,
					            track.existence.looks, track.existence.log_odds, track.objection ? " objected" : "");
			std::printf("\n");
		}
	}
}

void addFrame(Scene& scene, const DepthFrame& frame, const TruthLog& log, const TruthFrame& truth,
              const Options& options, Score& score)
{
	const Percepts percepts = perceive(frame, {}, log.robot, scene.perception);
	scene.map->insert(frame);
	DoorLook look;
	look.doors_in_robot = percepts.doors;
	look.map_from_robot = isometryOf(frame.map_from_robot);
	look.robot_from_camera = isometryOf(frame.robot_from_camera);
	look.t_s = mrpt::Clock::toDouble(frame.timestamp);
	look.view = doorQuery(frame, {}, {});
	if (!options.no_reveal) look.reveal = revealQuery(frame);
	if (!options.no_map) look.occupancy = [&](const Eigen::Vector3d& point) { return scene.map->stateAt(point); };
	std::map<int, int> looks_before;
	for (const DoorTrack& track : scene.doors.tracks) looks_before[track.number] = track.existence.looks;
	update(scene.doors, look, log.robot, {});
	for (const DoorTrack& track : scene.doors.tracks)
		if (track.existence.looks == 5 && looks_before[track.number] == 4) scene.due.push_back(track);

	CorridorLook corridor_look{percepts.vanishing_points, percepts.walls, look.map_from_robot,
	                           look.robot_from_camera,    look.t_s,       clearAhead(frame)};
	update(scene.corridors, corridor_look, {});
	learnTruth(scene, truth, {look.map_from_robot * look.robot_from_camera, look.t_s}, log.robot, score);
	for (const Door& door : percepts.doors)
		if (fitsThrough(door, log.robot))
			add(score.reports, isAtPositive(scene, placeOf(door, look.map_from_robot), door.clear_width_m));
}

void printWrong(const char* when, const DoorTrack& track)
{
	std::printf(
	    "  wrong %s: track %d at %.2f %.2f, %.2f wide, %s %.2f, %d of %d looks, log-odds %.2f, wall flat in %d and "
	    "thick in %d "
	    "rows\n",
	    when, track.number, track.place.center_in_map.x(), track.place.center_in_map.y(), track.place.width_m,
	    std::string(nameOf(verdictOf(track))).c_str(), confidenceOf(track), track.existence.hits, track.existence.looks,
	    track.existence.log_odds, track.reveal.flat, track.reveal.thick);
}

void scoreTracks(const Scene& scene, const std::vector<DoorTrack>& tracks, const RobotConfig& robot, const char* when,
                 SceneRatio& ratio)
{
	for (const DoorTrack& track : tracks)
	{
		if (!isPositiveTrack(track, robot)) continue;
		const bool right = isAtPositive(scene, track.place, clearWidthOf(track.belief));
		add(ratio, right);
		if (!right) printWrong(when, track);
	}
}

void finishScene(const Scene& scene, const RobotConfig& robot, Score& score)
{
	std::vector<DoorTrack> due = scene.due;
	for (const DoorTrack& track : scene.doors.tracks)
		if (track.existence.looks < 5) due.push_back(track);
	scoreTracks(scene, due, robot, "at five looks", score.at_five);
	scoreTracks(scene, scene.doors.tracks, robot, "at the end", score.at_end);
	for (const auto& entry : scene.known)
	{
		const TruthDoor& door = entry.second.door;
		int near = 0;
		for (const DoorTrack& track : scene.doors.tracks)
			near += track.existence.confirmed && (track.place.center_in_map - door.center_in_map.head<2>()).norm() < 0.5
			            ? 1
			            : 0;
		score.doubles.all += near > 0 ? 1U : 0U;
		score.doubles.good += static_cast<evaluation::Count>(std::max(0, near - 1));
	}
	for (const CorridorTrack& track : scene.corridors.tracks)
		if (track.existence.confirmed)
			add(score.corridors,
			    std::ranges::any_of(scene.corridor_directions_rad, [&](double direction_rad)
			                        { return std::abs(axisDifference(direction_rad, track.direction_rad)) < 0.035; }));
}

/** A score a scene; `robot` becomes that of the log. */
std::vector<Score> scoresOf(const std::string& path, const Options& options, RobotKind& robot)
{
	const TruthLog log = evaluation::readTruth(evaluation::truthPathOf(path));
	robot = log.robot.kind;
	mrpt::system::COutputLogger logger;
	logger.logging_enable_console_output = false;
	SourceConfig config;
	config.rawlog = path;
	const auto source = makeSource(config, logger);
	std::vector<Score> scores;
	std::optional<Scene> scene;
	int number = 0;
	while (auto frame = source->next())
	{
		const auto truth = std::ranges::find(log.frames, frame->index, &TruthFrame::index);
		if (truth == log.frames.end()) continue;
		frame->robot_from_camera = mountOf(log, *truth);
		if (!options.odometry) frame->map_from_robot = truth->map_from_robot;
		if (!scene || truth->scene != number)
		{
			if (scene) finishScene(*scene, log.robot, scores.back());
			number = truth->scene;
			scene.emplace();
			scores.emplace_back();
		}
		addFrame(*scene, *frame, log, *truth, options, scores.back());
	}
	if (scene) finishScene(*scene, log.robot, scores.back());
	return scores;
}

std::string text(const std::vector<Score>& scores, SceneRatio Score::*which)
{
	std::vector<SceneRatio> ratios;
	ratios.reserve(scores.size());
	for (const Score& score : scores) ratios.push_back(score.*which);
	const auto rate = evaluation::rateOf(ratios);
	if (!rate) return "none";
	return mrpt::format("%.2f %% (%.2f-%.2f, %llu of %llu)", 100 * rate->value, 100 * rate->low, 100 * rate->high,
	                    static_cast<unsigned long long>(rate->good), static_cast<unsigned long long>(rate->all));
}

/** Rates with their 95 % interval over scenes. */
void print(const std::string& name, const std::vector<Score>& scores)
{
	if (scores.empty()) return;
	std::printf("%s, %zu scenes\n", name.c_str(), scores.size());
	std::printf("    tracks right at five looks %s, at the end %s\n", text(scores, &Score::at_five).c_str(),
	            text(scores, &Score::at_end).c_str());
	std::printf("    doors found at five looks %s; single reports right %s\n",
	            text(scores, &Score::found_at_five).c_str(), text(scores, &Score::reports).c_str());
	std::printf("    second tracks of a door %s; corridors right %s\n", text(scores, &Score::doubles).c_str(),
	            text(scores, &Score::corridors).c_str());
}

void measure(const Options& options)
{
	std::map<RobotKind, std::vector<Score>> all;
	for (const std::string& log : options.logs)
	{
		RobotKind robot{};
		const std::vector<Score> scores = scoresOf(log, options, robot);
		print(log, scores);
		all[robot].insert(all[robot].end(), scores.begin(), scores.end());
	}
	for (const auto& [robot, scores] : all) print("all logs, " + std::string(nameOf(robot)), scores);
}

Options optionsOf(int argc, char** argv)
{
	Options options;
	for (int i = 1; i < argc; ++i)
	{
		const std::string_view argument = argv[i];
		if (argument == "--odometry")
			options.odometry = true;
		else if (argument == "--no-map")
			options.no_map = true;
		else if (argument == "--no-reveal")
			options.no_reveal = true;
		else
			options.logs.emplace_back(argument);
	}
	return options;
}
}  // namespace
}  // namespace explore::test

int main(int argc, char** argv)
{
	using namespace explore::test;
	const Options options = optionsOf(argc, argv);
	if (options.logs.empty())
	{
		std::fputs("measure_tracks [--odometry] [--no-map] [--no-reveal] LOG.rawlog...\n", stderr);
		return 2;
	}
	try
	{
		measure(options);
	}
	catch (const std::exception& error)
	{
		std::fprintf(stderr, "%s\n", error.what());
		return 3;
	}
	return 0;
}

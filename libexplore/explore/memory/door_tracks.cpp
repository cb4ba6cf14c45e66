#include <explore/memory/door_objections.h>
#include <explore/memory/door_tracks.h>
#include <explore/memory/door_upkeep.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
/** A report of something shut tells this surely that there is a door of some kind; one with a jamb out of view, or with
 *  nothing to see behind, tells less. */
constexpr double kShutIsThere = 0.7, kUnclearIsThere = 0.55;
/** A robot that gets through has the best look at a door: it weighs as much as so many from afar. */
constexpr double kPassed = 3.0, kSureOfPassing = 0.99;
/** Reports of openings that can be passed tell as much as their confidence, within these. */
constexpr double kLeastThere = 0.55, kMostThere = 0.95;
/** More of the rays than this ending in a door's opening, and none but a few going through, is a shut door. */
constexpr double kShut = 0.8, kFewThrough = 0.05;

using Assignment = std::vector<std::optional<std::size_t>>;

struct Now
{
	Viewpoint from;
	double travelled_m = 0;
};

double thereByReport(const DoorSighting& sighting)
{
	const bool unclear = sighting.verdict == Verdict::partial || sighting.verdict == Verdict::unknown;
	if (unclear) return logOdds(kUnclearIsThere);
	if (!isPassable(sighting.verdict)) return logOdds(kShutIsThere);
	return logOdds(std::clamp(sighting.confidence, kLeastThere, kMostThere));
}

DoorOpinion opinionOf(const DoorSighting& sighting, double weight)
{
	return {sighting.verdict, sighting.clear_width_m, sighting.confidence, weight * sighting.quality};
}

/** What that look weighs beside the last one. */
double weightOf(const DoorTrack& track, const Now& now, const DoorTrackConfig& config)
{
	if (track.existence.looks == 0) return 1.0;
	return novelty(track.existence.last_look, now.from, config.existence.same_place_weight);
}

/** Where most looks have the floor behind out of view, those that saw it count. */
void addFloor(DoorTrack& track, const DoorSighting& sighting, double weight)
{
	if (!sighting.floor_beyond) return;
	(*sighting.floor_beyond ? track.floor_seen : track.floor_missing) += weight * sighting.quality;
}

void addReport(DoorTrack& track, const DoorSighting& sighting, const Now& now, const DoorTrackConfig& config)
{
	const double weight = weightOf(track, now, config);
	// Errors of looks from one place are shared: such a look is worth less than one from elsewhere.
	fuse(track, lessSure(sighting, weight), now.travelled_m, config.fusion);
	addOpinion(track.belief, opinionOf(sighting, weight), config.fading);
	addFloor(track, sighting, weight);
	addLook(track.existence, {now.from, true, thereByReport(sighting)}, config.existence);
}

/** A door in plain view of which there is no report. */
void addMiss(DoorTrack& track, const DoorView& view, const Now& now, const DoorTrackConfig& config)
{
	const Eigen::Vector2d sight = track.place.center_in_map - now.from.map_from_camera.translation().head<2>();
	const double cosine = std::min(1.0, std::abs(sight.normalized().dot(track.place.normal())));
	const double quality = lookQuality(sight.norm(), std::acos(cosine));
	const double detected =
	    config.detect_probability * std::sqrt(quality) * (1 - config.through_doubt * view.through_share);
	if (view.shut_share > kShut && view.through_share < kFewThrough)
		addOpinion(track.belief, {Verdict::closed, 0, 1 - kShut, weightOf(track, now, config) * quality},
		           config.fading);
	addLook(track.existence, {now.from, false, std::log(1 - detected)}, config.existence);
}

DoorTrack newTrack(int number, const DoorSighting& sighting, const Now& now, const DoorTrackConfig& config)
{
	DoorTrack track;
	track.number = number;
	track.place = sighting.place;
	track.center_covariance = sighting.center_covariance;
	track.normal_variance = sighting.normal_variance;
	track.width_variance = sighting.width_variance;
	track.fused_at_m = now.travelled_m;
	addOpinion(track.belief, opinionOf(sighting, 1), config.fading);
	addFloor(track, sighting, 1);
	addLook(track.existence, {now.from, true, thereByReport(sighting)}, config.existence);
	return track;
}

/** The robot went through: it is open. */
void pass(DoorTrack& track, const RobotConfig& robot, const DoorTrackConfig& config)
{
	track.visited = true;
	const Verdict said = verdictOf(track.belief);
	const DoorOpinion passed{isPassable(said) ? said : Verdict::open,
	                         std::max(clearWidthOf(track.belief), 2 * robot.radius_m), kSureOfPassing, kPassed};
	addOpinion(track.belief, passed, config.fading);
}

/** The robot's way since the last frame: marks what it went through. */
void drive(DoorTracks& tracks, const Eigen::Vector2d& robot_in_map, const RobotConfig& robot,
           const DoorTrackConfig& config)
{
	if (tracks.robot_in_map)
	{
		tracks.travelled_m += (robot_in_map - *tracks.robot_in_map).norm();
		for (DoorTrack& track : tracks.tracks)
			if (leadsThrough(track.place, *tracks.robot_in_map, robot_in_map)) pass(track, robot, config);
	}
	tracks.robot_in_map = robot_in_map;
}

void lookAtTracks(DoorTracks& tracks, const std::vector<DoorSighting>& sightings, const Assignment& sighting_of,
                  const DoorQuery& query, const Now& now, const DoorTrackConfig& config)
{
	for (std::size_t i = 0; i < tracks.tracks.size(); ++i)
	{
		DoorTrack& track = tracks.tracks[i];
		if (!isNewLook(track.existence.last_look, now.from)) continue;
		if (sighting_of[i])
			addReport(track, sightings[*sighting_of[i]], now, config);
		else if (const auto view = query ? query(track.place) : std::nullopt)
			addMiss(track, *view, now, config);
	}
}

/** The numbers of the sightings' tracks, those that were new included. */
std::vector<int> numberSightings(DoorTracks& tracks, const std::vector<DoorSighting>& sightings,
                                 const Assignment& sighting_of, const Now& now, const DoorTrackConfig& config)
{
	std::vector<int> numbers(sightings.size(), 0);
	for (std::size_t i = 0; i < sighting_of.size(); ++i)
		if (sighting_of[i]) numbers[*sighting_of[i]] = tracks.tracks[i].number;
	for (std::size_t j = 0; j < sightings.size(); ++j)
	{
		if (numbers[j] != 0) continue;
		numbers[j] = tracks.next_number++;
		tracks.tracks.push_back(newTrack(numbers[j], sightings[j], now, config));
	}
	return numbers;
}

}  // namespace

void describe(FieldVisitor& fields, DoorTrackConfig& config)
{
	fields.section("door_tracks", "Doors that are remembered across frames.");
	describe(fields, config.existence);
	describe(fields, config.noise);
	describe(fields, config.fusion);
	describe(fields, config.map_check);
	fields.real("fading", config.fading, {0.1, 0.99}, "",
	            "What remains of a verdict's weight after another look: lower changes sooner.");
	fields.real("detect_probability", config.detect_probability, {0.05, 0.99}, "",
	            "How surely a door in plain view is reported, near and from the front.");
	fields.real("through_doubt", config.through_doubt, {0.0, 1.0}, "",
	            "How much less a missing report tells where rays go through the opening.");
	fields.integer("flat_rows", config.flat_rows, {1, 1000}, "",
	               "Rows of pixels in which the wall beside an opening has no inner face, for a mirror ...");
	fields.real("flat_share", config.flat_share, {0.0, 1.0}, "",
	            "... and their share of all rows that tell, until the robot went through; 0 = no mirrors.");
	fields.real("forget_time", config.forget_s, {0.1, 1e6}, "s",
	            "An unconfirmed track without a report is forgotten after this time ...");
	fields.real("forget_way", config.forget_m, {0.1, 1e6}, "m", "... or this much way.");
	fields.integer("max_tracks", config.max_tracks, {1, 100000}, "",
	               "Of more tracks than this the least sure are forgotten.");
}

std::vector<int> update(DoorTracks& tracks, const DoorLook& look, const RobotConfig& robot,
                        const DoorTrackConfig& config)
{
	drive(tracks, look.map_from_robot.translation().head<2>(), robot, config);
	const Now now{{look.map_from_robot * look.robot_from_camera, look.t_s}, tracks.travelled_m};
	std::vector<DoorSighting> sightings;
	sightings.reserve(look.doors_in_robot.size());
	for (const Door& door : look.doors_in_robot)
		sightings.push_back(
		    sightingOf(door, look.map_from_robot, now.from.map_from_camera.translation(), config.noise));

	const Assignment sighting_of = associate(tracks.tracks, sightings, now.travelled_m, config.fusion);
	lookAtTracks(tracks, sightings, sighting_of, look.view, now, config);
	std::vector<int> numbers = numberSightings(tracks, sightings, sighting_of, now, config);
	noteSeenBeside(tracks, sightings, numbers, config.fusion);
	for (const JoinedTrack& joined : joinDoubles(tracks, config.fusion))
		std::ranges::replace(numbers, joined.number, joined.into);
	objectToTracks(tracks, look, robot, config);
	forget(tracks, look.t_s, config);
	return numbers;
}

void correct(DoorTracks& tracks, const Eigen::Isometry3d& new_map_from_map)
{
	const Eigen::Matrix2d turn = Eigen::Rotation2Dd(turnOf(new_map_from_map)).toRotationMatrix();
	for (DoorTrack& track : tracks.tracks)
	{
		track.place = moved(track.place, new_map_from_map);
		track.center_covariance = turn * track.center_covariance * turn.transpose();
		for (Viewpoint* view : {&track.existence.last_look, &track.existence.last_hit})
			view->map_from_camera = new_map_from_map * view->map_from_camera;
	}
	if (tracks.robot_in_map)
		tracks.robot_in_map =
		    (new_map_from_map * Eigen::Vector3d(tracks.robot_in_map->x(), tracks.robot_in_map->y(), 0)).head<2>();
}
}  // namespace explore

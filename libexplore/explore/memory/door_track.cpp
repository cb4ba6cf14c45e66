#include <explore/memory/door_sighting.h>
#include <explore/memory/door_track.h>

#include <algorithm>

namespace explore
{
Verdict verdictOf(const DoorTrack& track)
{
	const Verdict said = verdictOf(track.belief);
	return isPassable(said) ? track.objection.value_or(said) : said;
}

double confidenceOf(const DoorTrack& track)
{
	constexpr double kObjected = 0.05;
	const double said = confidenceOf(track.belief);
	return track.objection ? std::min(said, kObjected) : said;
}

Door doorOf(const DoorTrack& track, const Eigen::Isometry3d& robot_from_map)
{
	const DoorPlace& place = track.place;
	Door door;
	door.center = robot_from_map * place.point(0, 0.5 * place.height_m.value_or(kUsualDoorHeight_m));
	const Eigen::Vector2d normal = place.normal();
	door.normal = robot_from_map.linear() * Eigen::Vector3d(normal.x(), normal.y(), 0);
	if (door.normal.dot(door.center) > 0) door.normal = -door.normal;
	door.width_m = place.width_m;
	door.height_m = place.height_m;
	door.verdict = verdictOf(track);
	door.clear_width_m = clearWidthOf(track.belief);
	door.confidence = confidenceOf(track);
	door.track = track.number;
	return door;
}

std::vector<Door> confirmedDoors(const DoorTracks& tracks, const Eigen::Isometry3d& robot_from_map)
{
	std::vector<Door> doors;
	doors.reserve(tracks.tracks.size());
	for (const DoorTrack& track : tracks.tracks)
		if (track.existence.confirmed) doors.push_back(doorOf(track, robot_from_map));
	return doors;
}
}  // namespace explore

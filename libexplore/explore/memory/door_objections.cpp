#include <explore/memory/door_objections.h>

#include <optional>

namespace explore
{
namespace
{
bool isFlat(const DoorTrack& track, const DoorTrackConfig& config)
{
	return !track.visited && config.flat_share > 0 && track.reveal.flat >= config.flat_rows &&
	       track.reveal.flatShare() >= config.flat_share;
}

std::optional<Verdict> objectionTo(const DoorTrack& track, const DoorLook& look, const RobotConfig& robot,
                                   const DoorTrackConfig& config)
{
	if (!isPassable(verdictOf(track.belief))) return std::nullopt;
	if (!track.visited && track.floor_missing > track.floor_seen) return Verdict::drop;
	if (isFlat(track, config)) return Verdict::unknown;
	if (!look.occupancy) return std::nullopt;
	const auto objection =
	    objectionTo(track.place, clearWidthOf(track.belief), look.occupancy, robot, config.map_check);
	const bool was_a_mirror = track.visited && objection == Verdict::unknown;
	return was_a_mirror ? std::nullopt : objection;
}

/** Whether what the map said against the track may not hold any more: it changes where the camera looks, not only in
 *  looks at the door. */
bool mayLapse(const DoorTrack& track, const DoorLook& look)
{
	constexpr double kNear_m = 6.0;
	return track.objection &&
	       (track.place.center_in_map - look.map_from_robot.translation().head<2>()).norm() < kNear_m;
}
}  // namespace

void objectToTracks(DoorTracks& tracks, const DoorLook& look, const RobotConfig& robot, const DoorTrackConfig& config)
{
	constexpr int kFullMemory = 400;  // rows; of more, half are forgotten
	for (DoorTrack& track : tracks.tracks)
	{
		const bool is_looked_at = track.existence.last_look.t_s == look.t_s;
		if (!is_looked_at && !mayLapse(track, look)) continue;
		if (is_looked_at && look.reveal) track.reveal += look.reveal(track.place);
		if (track.reveal.flat + track.reveal.thick > kFullMemory)
			track.reveal = {track.reveal.flat / 2, track.reveal.thick / 2};
		track.objection = objectionTo(track, look, robot, config);
	}
}
}  // namespace explore

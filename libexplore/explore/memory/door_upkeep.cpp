#include <explore/memory/door_upkeep.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace explore
{
namespace
{
constexpr std::size_t kMostBeside = 16;
/** Only tracks this near each other could ever be taken for one. */
constexpr double kNear_m = 3.0;

std::optional<std::pair<std::size_t, std::size_t>> firstDouble(const std::vector<DoorTrack>& tracks,
                                                               const DoorFusionConfig& config)
{
	for (std::size_t i = 0; i < tracks.size(); ++i)
		for (std::size_t j = i + 1; j < tracks.size(); ++j)
			if (areOneDoor(tracks[i], tracks[j], config)) return std::pair(i, j);
	return std::nullopt;
}

void noteBeside(DoorTrack& track, int number)
{
	auto& beside = track.seen_beside;
	if (std::ranges::find(beside, number) != beside.end()) return;
	if (beside.size() == kMostBeside) beside.erase(beside.begin());
	beside.push_back(number);
}

bool isFaded(const DoorTrack& track, const DoorTracks& tracks, double now_s, const DoorTrackConfig& config)
{
	if (track.existence.confirmed) return false;
	return now_s - track.existence.last_hit.t_s > config.forget_s ||
	       tracks.travelled_m - track.fused_at_m > config.forget_m;
}

/** Unconfirmed before confirmed, then by how sure they are. */
bool isLessSure(const DoorTrack& a, const DoorTrack& b)
{
	return std::tuple(a.existence.confirmed, a.visited, a.existence.log_odds, -a.number) <
	       std::tuple(b.existence.confirmed, b.visited, b.existence.log_odds, -b.number);
}
}  // namespace

std::vector<JoinedTrack> joinDoubles(DoorTracks& tracks, const DoorFusionConfig& config)
{
	std::vector<JoinedTrack> done;
	while (const auto found = firstDouble(tracks.tracks, config))
	{
		DoorTrack& first = tracks.tracks[found->first];
		const DoorTrack& second = tracks.tracks[found->second];
		done.push_back({second.number, first.number});
		first = joined(first, second, config);
		tracks.tracks.erase(tracks.tracks.begin() + static_cast<std::ptrdiff_t>(found->second));
	}
	return done;
}

void forget(DoorTracks& tracks, double now_s, const DoorTrackConfig& config)
{
	std::erase_if(tracks.tracks, [&](const DoorTrack& track)
	              { return isDead(track.existence, config.existence) || isFaded(track, tracks, now_s, config); });
	while (tracks.tracks.size() > static_cast<std::size_t>(config.max_tracks))
		tracks.tracks.erase(std::ranges::min_element(tracks.tracks, isLessSure));
}

void noteSeenBeside(DoorTracks& tracks, const std::vector<DoorSighting>& sightings,
                    const std::vector<int>& number_of_sighting, const DoorFusionConfig& config)
{
	for (std::size_t i = 0; i < sightings.size(); ++i)
		for (std::size_t j = 0; j < sightings.size(); ++j)
		{
			const DoorPlace &one = sightings[i].place, &other = sightings[j].place;
			if (i == j || overlapOf(one, other).distance_m > kNear_m || areOnePlace(one, other, config)) continue;
			const auto track = std::ranges::find(tracks.tracks, number_of_sighting[i], &DoorTrack::number);
			if (track != tracks.tracks.end()) noteBeside(*track, number_of_sighting[j]);
		}
}
}  // namespace explore

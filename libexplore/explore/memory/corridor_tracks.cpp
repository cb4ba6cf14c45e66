#include <explore/core/matching.h>
#include <explore/memory/corridor_fusion.h>
#include <explore/memory/corridor_tracks.h>
#include <explore/memory/door_place.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace explore
{
namespace
{
constexpr double kReported = 0.75;        // how surely a vanishing point is one of a corridor
constexpr double kLooksAlong_rad = 0.35;  // 20°: the robot looks along a corridor
constexpr double kExpected_m = 4.0;       // of corridor ahead, from which on it should be found

/** Whether the camera stands in the corridor and looks along it, with enough of it ahead. */
bool shouldBeSeen(const CorridorTrack& track, const CorridorLook& look, const Eigen::Isometry3d& map_from_camera,
                  const CorridorTrackConfig& config)
{
	const Eigen::Vector2d camera = map_from_camera.translation().head<2>();
	const Eigen::Vector3d ahead = map_from_camera.linear().col(0);
	if (look.clear_ahead_m < kExpected_m) return false;
	const Eigen::Vector2d direction = track.direction(), offset = camera - track.point_in_map;
	const double across_m = std::abs(direction.x() * offset.y() - direction.y() * offset.x());
	if (across_m > 0.5 * track.width_m.value_or(config.usual_width_m)) return false;
	if (std::abs(axisDifference(azimuthOf(ahead), track.direction_rad)) > kLooksAlong_rad) return false;
	const double along_m = direction.dot(offset);
	const bool forward = direction.dot(ahead.head<2>()) > 0;
	const double left_m = forward ? track.to_m - along_m : along_m - track.from_m;
	return left_m > kExpected_m && along_m > track.from_m && along_m < track.to_m;
}

std::vector<std::optional<std::size_t>> associate(const std::vector<CorridorTrack>& tracks,
                                                  const std::vector<CorridorSighting>& sightings,
                                                  const CorridorTrackConfig& config)
{
	DistanceTable distances(tracks.size(), sightings.size());
	for (std::size_t i = 0; i < tracks.size(); ++i)
		for (std::size_t j = 0; j < sightings.size(); ++j)
			if (const auto distance = distanceOf(tracks[i], sightings[j], config)) distances.allow(i, j, *distance);
	return bestMatching(distances, config.gate);
}

/** Joins the first two that are one corridor; false: there are none. */
bool joinOne(std::vector<CorridorTrack>& tracks, std::vector<int>& numbers, const CorridorTrackConfig& config)
{
	for (std::size_t i = 0; i < tracks.size(); ++i)
		for (std::size_t j = i + 1; j < tracks.size(); ++j)
		{
			if (!distanceOf(tracks[i], asSighting(tracks[j]), config)) continue;
			std::ranges::replace(numbers, tracks[j].number, tracks[i].number);
			tracks[i] = joined(tracks[i], tracks[j]);
			tracks.erase(tracks.begin() + static_cast<std::ptrdiff_t>(j));
			return true;
		}
	return false;
}

void forget(std::vector<CorridorTrack>& tracks, double now_s, const CorridorTrackConfig& config)
{
	std::erase_if(tracks,
	              [&](const CorridorTrack& track)
	              {
		              const Existence& existence = track.existence;
		              const bool old = now_s - existence.last_hit.t_s > config.forget_s;
		              return isDead(existence, config.existence) || (old && !existence.confirmed);
	              });
	while (tracks.size() > static_cast<std::size_t>(config.max_tracks))
		tracks.erase(std::ranges::min_element(
		    tracks, {},
		    [](const CorridorTrack& track)
		    { return std::tuple(track.existence.confirmed, track.existence.log_odds, -track.number); }));
}
}  // namespace

void describe(FieldVisitor& fields, CorridorTrackConfig& config)
{
	fields.section("corridor_tracks", "Corridors that are remembered across frames.");
	describe(fields, config.existence);
	fields.degrees("noise_direction_deg", config.direction_rad, {0.01, 45.0},
	               "Standard deviation of a corridor's direction in one frame.");
	fields.real("noise_middle", config.middle_m, {0.001, 5.0}, "m", "Of its middle, with walls on both sides.");
	fields.real("noise_one_sided", config.one_sided_m, {0.001, 5.0}, "m", "Of its middle, with walls on one side.");
	fields.real("gate", config.gate, {1.0, 100.0}, "",
	            "Vanishing points belong to a track up to this squared Mahalanobis distance.");
	fields.real("max_gap", config.max_gap_m, {0.0, 50.0}, "m",
	            "Pieces of one line that are farther apart are two corridors.");
	fields.real("usual_width", config.usual_width_m, {0.3, 20.0}, "m", "Width where only one wall was seen.");
	fields.real("detect_probability", config.detect_probability, {0.05, 0.99}, "",
	            "How surely a corridor is found along which the robot looks.");
	fields.real("forget_time", config.forget_s, {0.1, 1e6}, "s",
	            "An unconfirmed track that was not seen for this time is forgotten.");
	fields.integer("max_tracks", config.max_tracks, {1, 100000}, "",
	               "Of more tracks than this the least sure are forgotten.");
}

std::vector<int> update(CorridorTracks& tracks, const CorridorLook& look, const CorridorTrackConfig& config)
{
	const Viewpoint now{look.map_from_robot * look.robot_from_camera, look.t_s};
	std::vector<CorridorSighting> sightings;
	sightings.reserve(look.vanishing_points_in_robot.size());
	for (const VanishingPoint& point : look.vanishing_points_in_robot)
		sightings.push_back(sightingOf(point, look, config));

	const auto sighting_of = associate(tracks.tracks, sightings, config);
	std::vector<int> numbers(sightings.size(), 0);
	for (std::size_t i = 0; i < sighting_of.size(); ++i)
	{
		CorridorTrack& track = tracks.tracks[i];
		if (sighting_of[i]) numbers[*sighting_of[i]] = track.number;
		if (!isNewLook(track.existence.last_look, now)) continue;
		if (sighting_of[i])
		{
			fuse(track, sightings[*sighting_of[i]]);
			addLook(track.existence, {now, true, logOdds(kReported)}, config.existence);
		}
		else if (shouldBeSeen(track, look, now.map_from_camera, config))
			addLook(track.existence, {now, false, std::log(1 - config.detect_probability)}, config.existence);
	}
	for (std::size_t j = 0; j < sightings.size(); ++j)
	{
		if (numbers[j] != 0) continue;
		numbers[j] = tracks.next_number++;
		CorridorTrack track = newCorridor(numbers[j], sightings[j]);
		addLook(track.existence, {now, true, logOdds(kReported)}, config.existence);
		tracks.tracks.push_back(track);
	}
	while (joinOne(tracks.tracks, numbers, config))
	{
	}
	forget(tracks.tracks, look.t_s, config);
	return numbers;
}

void correct(CorridorTracks& tracks, const Eigen::Isometry3d& new_map_from_map)
{
	for (CorridorTrack& track : tracks.tracks)
	{
		const Eigen::Vector3d point =
		    new_map_from_map * Eigen::Vector3d(track.point_in_map.x(), track.point_in_map.y(), track.point_height_m);
		track.point_in_map = point.head<2>();
		track.point_height_m = point.z();
		track.direction_rad = wrapToPi(track.direction_rad + turnOf(new_map_from_map));
		for (Viewpoint* view : {&track.existence.last_look, &track.existence.last_hit})
			view->map_from_camera = new_map_from_map * view->map_from_camera;
	}
}

std::vector<VanishingPoint> confirmedCorridors(const CorridorTracks& tracks, const Eigen::Isometry3d& robot_from_map)
{
	const Eigen::Vector2d robot = robot_from_map.inverse(Eigen::Isometry).translation().head<2>();
	std::vector<VanishingPoint> points;
	for (const CorridorTrack& track : tracks.tracks)
	{
		if (!track.existence.confirmed) continue;
		const Eigen::Vector2d direction = track.direction(), offset = robot - track.point_in_map;
		const double along_m = direction.dot(offset), width_m = track.width_m.value_or(0.0);
		if ((offset - along_m * direction).norm() > 0.5 * std::max(width_m, CorridorTrackConfig().usual_width_m))
			continue;
		for (const double end_m : {track.from_m, track.to_m})
		{
			if (std::abs(end_m - along_m) < std::max(width_m, 1.0)) continue;
			const Eigen::Vector2d end = track.at(end_m),
			                      way = end_m > along_m ? direction : Eigen::Vector2d(-direction);
			VanishingPoint point;
			point.point = robot_from_map * Eigen::Vector3d(end.x(), end.y(), track.point_height_m);
			point.direction = robot_from_map.linear() * Eigen::Vector3d(way.x(), way.y(), 0);
			point.track = track.number;
			points.push_back(point);
		}
	}
	return points;
}
}  // namespace explore

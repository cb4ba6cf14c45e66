#include <explore/sinks/doors_geojson.h>
#include <explore/sinks/json_values.h>

namespace explore
{
namespace
{
Json pointJson(const Eigen::Vector2d& point_in_map)
{
	return {jsonNumber(point_in_map.x()), jsonNumber(point_in_map.y())};
}

Json lineFeature(const Eigen::Vector2d& from_in_map, const Eigen::Vector2d& to_in_map, const Json& properties)
{
	return {
	    {"type", "Feature"},
	    {"geometry",
	     {{"type", "LineString"}, {"coordinates", Json::array({pointJson(from_in_map), pointJson(to_in_map)})}}},
	    {"properties", properties},
	};
}

Json doorFeature(const DoorTrack& track)
{
	const DoorPlace& place = track.place;
	const Eigen::Vector2d half = 0.5 * place.width_m * place.along();
	return lineFeature(place.center_in_map - half, place.center_in_map + half,
	                   {{"kind", "door"},
	                    {"track", track.number},
	                    {"verdict", nameOf(verdictOf(track))},
	                    {"width", jsonNumber(place.width_m)},
	                    {"height", jsonOrNull(place.height_m)},
	                    {"confidence", jsonNumber(confidenceOf(track))},
	                    {"seen", track.existence.hits},
	                    {"visited", track.visited}});
}

Json corridorFeature(const CorridorTrack& track)
{
	return lineFeature(track.at(track.from_m), track.at(track.to_m),
	                   {{"kind", "corridor"},
	                    {"track", track.number},
	                    {"width", jsonOrNull(track.width_m)},
	                    {"seen", track.existence.hits}});
}
}  // namespace

std::string doorsGeoJson(const FrontierMemory& memory)
{
	Json features = Json::array();
	for (const DoorTrack& track : memory.doors.tracks)
		if (track.existence.confirmed) features.push_back(doorFeature(track));
	for (const CorridorTrack& track : memory.corridors.tracks)
		if (track.existence.confirmed) features.push_back(corridorFeature(track));
	return jsonText({{"type", "FeatureCollection"},
	                 {"frame", "map: x, y in metres, not longitude and latitude"},
	                 {"features", features}},
	                1) +
	       '\n';
}
}  // namespace explore

#include <explore/memory/door_sighting.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kHalfQuality_m = 3.5;   // at this range a look counts half
constexpr double kGrazingQuality = 0.2;  // of a look along the wall

/** What a report whose other jamb is out of view does not say [m]. */
constexpr double kPartialWidth_m = 0.6, kPartialAlong_m = 0.5;

/** Turns diag(along², across²) into the map's axes. */
Eigen::Matrix2d inMap(const DoorPlace& place, double along_m, double across_m)
{
	Eigen::Matrix2d axes;
	axes << place.along(), place.normal();
	return axes * Eigen::Vector2d(along_m * along_m, across_m * across_m).asDiagonal() * axes.transpose();
}
/** As the verdict has it, or the rays that should have met a floor there. */
std::optional<bool> floorBeyond(const Door& door)
{
	constexpr double kMostly = 0.5;
	if (door.verdict == Verdict::drop) return false;
	if (!door.evidence || !door.evidence->floor_beyond) return std::nullopt;
	return *door.evidence->floor_beyond > kMostly ? std::optional(true) : std::nullopt;
}
}  // namespace

void describe(FieldVisitor& fields, SightingNoiseConfig& config)
{
	fields.real("noise_along", config.along_m, {0.001, 1.0}, "m",
	            "Standard deviation of a reported door's middle along its wall, seen from nearby.");
	fields.real("noise_across", config.across_m, {0.001, 1.0}, "m", "The same across the wall.");
	fields.degrees("noise_direction_deg", config.lateral_rad, {0.01, 10.0}, "Of the direction in which it is seen.");
	fields.degrees("noise_normal_deg", config.normal_rad, {0.1, 45.0}, "Of its wall's direction.");
	fields.real("noise_width", config.width_m, {0.001, 1.0}, "m", "Of its width.");
}

bool isPassable(Verdict verdict)
{
	return verdict == Verdict::open || verdict == Verdict::ajar || verdict == Verdict::passage;
}

double lookQuality(double range_m, double incidence_rad)
{
	const double far = range_m / kHalfQuality_m;
	return std::max(std::cos(incidence_rad), kGrazingQuality) / (1 + far * far);
}

DoorSighting lessSure(DoorSighting sighting, double weight)
{
	sighting.center_covariance /= weight;
	sighting.normal_variance /= weight;
	sighting.width_variance /= weight;
	return sighting;
}

DoorSighting sightingOf(const Door& door_in_robot, const Eigen::Isometry3d& map_from_robot,
                        const Eigen::Vector3d& camera_in_map, const SightingNoiseConfig& config)
{
	DoorSighting sighting;
	sighting.place = placeOf(door_in_robot, map_from_robot);
	const Eigen::Vector2d sight = sighting.place.center_in_map - camera_in_map.head<2>();
	sighting.range_m = sight.norm();
	const double sine = std::abs(sight.normalized().dot(sighting.place.along()));
	sighting.incidence_rad = std::asin(std::min(sine, 1.0));
	const double cosine = std::cos(sighting.incidence_rad);

	const double depth_m = depthSigma(sighting.range_m, config.depth);
	const double lateral_m = config.lateral_rad * sighting.range_m;
	double along_m = std::hypot(config.along_m, depth_m * sine, lateral_m * cosine);
	const double across_m = std::hypot(config.across_m, depth_m * cosine, lateral_m * sine);
	double width_m = std::hypot(config.width_m, depth_m * sine, lateral_m * cosine);
	if (door_in_robot.verdict == Verdict::partial)
	{
		along_m = std::hypot(along_m, kPartialAlong_m);
		width_m = std::hypot(width_m, kPartialWidth_m);
	}
	sighting.center_covariance = inMap(sighting.place, along_m, across_m);
	const double turn_rad = depth_m / std::max(sighting.place.width_m, 0.5);
	sighting.normal_variance = config.normal_rad * config.normal_rad + turn_rad * turn_rad;
	sighting.width_variance = width_m * width_m;
	sighting.verdict = door_in_robot.verdict;
	sighting.clear_width_m = door_in_robot.clear_width_m;
	const double usual = isPassable(door_in_robot.verdict) ? kPassableByDefault : 1 - kPassableByDefault;
	sighting.confidence = door_in_robot.confidence.value_or(usual);
	sighting.floor_beyond = floorBeyond(door_in_robot);
	sighting.quality = lookQuality(sighting.range_m, sighting.incidence_rad);
	return sighting;
}
}  // namespace explore

#include <explore/core/matching.h>
#include <explore/memory/door_fusion.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore
{
namespace
{
/** What is added to a variance before each look [m², rad²], so that a mean of many never stops listening. */
constexpr double kPerLook = 0.003 * 0.003;

/** A mean and its variance after another measurement. */
struct Estimate
{
	double mean = 0, variance = 0;
};

Estimate weightedMean(const Estimate& a, const Estimate& b)
{
	const double gain = a.variance / (a.variance + b.variance);
	return {a.mean + gain * (b.mean - a.mean), (1 - gain) * a.variance};
}

/** How far the robot's pose has wandered since the track was last fused [m²]. */
double driftVariance(const DoorTrack& track, double travelled_m, const DoorFusionConfig& config)
{
	return config.drift_m * config.drift_m * std::max(0.0, travelled_m - track.fused_at_m);
}

/** What the looks at one door share, along the axes: never known better. */
Eigen::Matrix2d sharedError(const DoorFusionConfig& config)
{
	return config.shared_error_m * config.shared_error_m * Eigen::Matrix2d::Identity();
}

/** Measurements that cover the same stretch of wall, whatever they think of its middle. */
bool coverEachOther(const DoorPlace& a, const DoorPlace& b, const DoorFusionConfig& config)
{
	const DoorOverlap overlap = overlapOf(a, b);
	return overlap.share > config.merge_overlap && overlap.across_m < config.merge_across_m &&
	       overlap.angle_rad < config.max_angle_rad;
}

/** By how much the variances of a report grow that lies too far off: Huber's weights, so that an outlier pulls no more
 *  than a report at the limit would. */
double outlierFactor(const DoorTrack& track, const DoorSighting& sighting, double added_m2)
{
	constexpr double kLimit = 2.5;  // standard deviations
	const Eigen::Matrix2d spread =
	    track.center_covariance + sighting.center_covariance + added_m2 * Eigen::Matrix2d::Identity();
	const Eigen::Vector2d offset = sighting.place.center_in_map - track.place.center_in_map;
	return std::max(1.0, offset.dot(spread.inverse() * offset) / (kLimit * kLimit));
}

/** A floor or lintel that another look saw as well. */
std::optional<double> meanHeight(const std::optional<double>& a_m, const std::optional<double>& b_m, double share_of_b)
{
	if (!a_m || !b_m) return a_m ? a_m : b_m;
	return *a_m + share_of_b * (*b_m - *a_m);
}

/** `added_m2` to the variance of the track's middle before the look. */
void fusePlace(DoorTrack& track, const DoorSighting& sighting, double added_m2)
{
	DoorPlace& place = track.place;
	const Eigen::Matrix2d predicted = track.center_covariance + added_m2 * Eigen::Matrix2d::Identity();
	const Eigen::Matrix2d gain = predicted * (predicted + sighting.center_covariance).inverse();
	place.center_in_map += gain * (sighting.place.center_in_map - place.center_in_map);
	// Joseph's form stays symmetric and positive definite.
	const Eigen::Matrix2d rest = Eigen::Matrix2d::Identity() - gain;
	track.center_covariance =
	    rest * predicted * rest.transpose() + gain * sighting.center_covariance * gain.transpose();

	const double turn = axisDifference(sighting.place.normal_rad, place.normal_rad);
	const Estimate normal = weightedMean({0, track.normal_variance + kPerLook}, {turn, sighting.normal_variance});
	place.normal_rad = wrapToPi(place.normal_rad + normal.mean);
	track.normal_variance = normal.variance;

	const Estimate known{place.width_m, track.width_variance + kPerLook};
	const Estimate width = weightedMean(known, {sighting.place.width_m, sighting.width_variance});
	const double share = 1 - width.variance / known.variance;
	place.floor_m += share * (sighting.place.floor_m - place.floor_m);
	place.height_m = meanHeight(place.height_m, sighting.place.height_m, share);
	place.width_m = width.mean;
	track.width_variance = width.variance;
}
}  // namespace

void describe(FieldVisitor& fields, DoorFusionConfig& config)
{
	fields.real("gate", config.gate, {1.0, 100.0}, "",
	            "Reports belong to a track up to this squared Mahalanobis distance.");
	fields.degrees("max_angle_deg", config.max_angle_rad, {5.0, 90.0},
	               "Reports of walls that differ by more are not the same door.");
	fields.real("drift", config.drift_m, {0.0, 1.0}, "m",
	            "Standard deviation of the robot's pose after one metre; it grows with the root of the way.");
	fields.real("shared_error", config.shared_error_m, {0.0, 1.0}, "m",
	            "What looks at one door have in common: a track's place is never surer.");
	fields.degrees("shared_error_deg", config.shared_error_rad, {0.0, 45.0}, "The same of its wall's direction.");
	fields.real("width_spread", config.width_spread_m, {0.01, 5.0}, "m",
	            "How far the reported widths of one door spread.");
	fields.real("merge_overlap", config.merge_overlap, {0.1, 1.0}, "",
	            "Tracks that share more than this of the narrower opening are one door ...");
	fields.real("merge_across", config.merge_across_m, {0.05, 2.0}, "m",
	            "... when their walls are no farther from each other than this.");
	fields.real("merge_distance", config.merge_distance_m, {0.0, 2.0}, "m",
	            "Tracks whose middles are nearer than this are one door, whatever their walls.");
}

std::optional<double> distanceOf(const DoorTrack& track, const DoorSighting& sighting, double travelled_m,
                                 const DoorFusionConfig& config)
{
	const double turn = axisDifference(sighting.place.normal_rad, track.place.normal_rad);
	if (std::abs(turn) > config.max_angle_rad) return std::nullopt;
	const double drift_m2 = driftVariance(track, travelled_m, config);
	const Eigen::Matrix2d spread = track.center_covariance + sighting.center_covariance + sharedError(config) +
	                               drift_m2 * Eigen::Matrix2d::Identity();
	const Eigen::Vector2d offset = sighting.place.center_in_map - track.place.center_in_map;
	const double turn_variance =
	    track.normal_variance + sighting.normal_variance + config.shared_error_rad * config.shared_error_rad;
	const double widths_m = sighting.place.width_m - track.place.width_m;
	const double width_variance =
	    track.width_variance + sighting.width_variance + config.width_spread_m * config.width_spread_m;
	const double distance =
	    offset.dot(spread.inverse() * offset) + turn * turn / turn_variance + widths_m * widths_m / width_variance;
	constexpr double kLastChoice = 0.99;  // of the gate
	if (coverEachOther(track.place, sighting.place, config)) return std::min(distance, kLastChoice * config.gate);
	return distance < config.gate ? std::optional(distance) : std::nullopt;
}

std::vector<std::optional<std::size_t>> associate(const std::vector<DoorTrack>& tracks,
                                                  const std::vector<DoorSighting>& sightings, double travelled_m,
                                                  const DoorFusionConfig& config)
{
	DistanceTable distances(tracks.size(), sightings.size());
	for (std::size_t i = 0; i < tracks.size(); ++i)
		for (std::size_t j = 0; j < sightings.size(); ++j)
			if (const auto distance = distanceOf(tracks[i], sightings[j], travelled_m, config))
				distances.allow(i, j, *distance);
	return bestMatching(distances, config.gate);
}

void fuse(DoorTrack& track, const DoorSighting& sighting, double travelled_m, const DoorFusionConfig& config)
{
	const double added_m2 = driftVariance(track, travelled_m, config) + kPerLook;
	fusePlace(track, lessSure(sighting, 1 / outlierFactor(track, sighting, added_m2)), added_m2);
	track.fused_at_m = travelled_m;
}

bool areOnePlace(const DoorPlace& a, const DoorPlace& b, const DoorFusionConfig& config)
{
	return (a.center_in_map - b.center_in_map).norm() < config.merge_distance_m || coverEachOther(a, b, config);
}

bool areOneDoor(const DoorTrack& a, const DoorTrack& b, const DoorFusionConfig& config)
{
	if (std::ranges::find(a.seen_beside, b.number) != a.seen_beside.end()) return false;
	if (std::ranges::find(b.seen_beside, a.number) != b.seen_beside.end()) return false;
	return areOnePlace(a.place, b.place, config);
}

DoorTrack joined(const DoorTrack& a, const DoorTrack& b, const DoorFusionConfig& config)
{
	const bool a_surer = a.existence.log_odds >= b.existence.log_odds;
	DoorTrack result = a_surer ? a : b;
	const DoorTrack& other = a_surer ? b : a;
	if (coverEachOther(result.place, other.place, config))
	{
		const DoorSighting as_seen{.place = other.place,
		                           .center_covariance = other.center_covariance,
		                           .normal_variance = other.normal_variance,
		                           .width_variance = other.width_variance};
		fusePlace(result, as_seen, 0);
	}
	result.number = std::min(a.number, b.number);
	result.fused_at_m = std::max(a.fused_at_m, b.fused_at_m);
	result.existence = joined(a.existence, b.existence);
	result.belief = joined(a.belief, b.belief);
	result.visited = a.visited || b.visited;
	result.reveal += other.reveal;
	result.floor_seen += other.floor_seen;
	result.floor_missing += other.floor_missing;
	for (const int number : other.seen_beside)
		if (std::ranges::find(result.seen_beside, number) == result.seen_beside.end())
			result.seen_beside.push_back(number);
	return result;
}
}  // namespace explore

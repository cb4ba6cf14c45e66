// One report of a door, placed in the map with how sure its place is.
#pragma once

#include <explore/memory/door_place.h>
#include <explore/memory/track_existence.h>
#include <explore/perception/sensor_noise.h>

#include <optional>

namespace explore
{
/** Standard deviations of what a report says, for one look; how they grow with range and incidence is depthSigma()'s
 *  matter. They hold what the looks do not share; see DoorFusionConfig for what they do. */
struct SightingNoiseConfig
{
	SensorNoiseConfig depth;
	double along_m = 0.025, across_m = 0.025;  ///< of the middle, along and across the wall, nearby
	double lateral_rad = 0.004;                ///< of directions: what pixels and the robot's pose leave
	double normal_rad = 0.035;                 ///< 2°
	double width_m = 0.04;
};
/** Field list of the above; without a section of its own. */
void describe(FieldVisitor& fields, SightingNoiseConfig& config);

struct DoorSighting
{
	DoorPlace place;
	Eigen::Matrix2d center_covariance = Eigen::Matrix2d::Identity();  ///< [m²], map axes
	double normal_variance = 0, width_variance = 0;                   ///< rad², m²
	double range_m = 0;                                               ///< from the camera, on the plan
	double incidence_rad = 0;                                         ///< of the line of sight to the wall's normal
	Verdict verdict = Verdict::open;
	double clear_width_m = 0;
	double confidence = 0;  ///< P(the robot can pass)
	/** Whether there is a floor behind the opening; no value: it was not in view. */
	std::optional<bool> floor_beyond{};
	double quality = 0;  ///< how much this look counts beside others, 0–1: near and frontal is 1
};

/** P(pass) of reports of methods that give none. */
inline constexpr double kPassableByDefault = 0.7;

DoorSighting sightingOf(const Door& door_in_robot, const Eigen::Isometry3d& map_from_robot,
                        const Eigen::Vector3d& camera_in_map, const SightingNoiseConfig& config);

/** The same with variances 1 / `weight` times as large. */
[[nodiscard]] DoorSighting lessSure(DoorSighting sighting, double weight);

/** Whether that verdict says that the robot can go through. */
[[nodiscard]] bool isPassable(Verdict verdict);

/** The weight of a look from that far at that angle, 0–1. */
[[nodiscard]] double lookQuality(double range_m, double incidence_rad);
}  // namespace explore

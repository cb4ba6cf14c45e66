// The memory of corridors: their axes on the floor plan, confirmed over looks like doors.
#pragma once

#include <explore/core/results.h>
#include <explore/memory/track_existence.h>

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

namespace explore
{
/** A piece of a corridor's axis as one frame shows it. */
struct CorridorSighting
{
	Eigen::Vector2d point_in_map = Eigen::Vector2d::Zero();  ///< on the axis, beside the camera
	double direction_rad = 0;                                ///< azimuth in the map, the way the camera looks
	double offset_variance = 0;                              ///< of the point, across [m²]
	double direction_variance = 0;                           ///< [rad²]
	double length_m = 0;                                     ///< from the point to where its walls were last seen
	std::optional<double> width_m;                           ///< between its walls; no value: walls on one side alone
	double height_m = 0;                                     ///< of the vanishing point, in the map
};

struct CorridorTrack
{
	int number = 0;                                          ///< from 1, never used again
	Eigen::Vector2d point_in_map = Eigen::Vector2d::Zero();  ///< on the axis, where it was last looked at from
	double direction_rad = 0;                                ///< azimuth in the map, the way it was first seen
	/** Of the offset across the axis at the point [m] and the direction [rad]. */
	Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
	double from_m = 0, to_m = 0;  ///< where it was seen, along the direction from the point
	std::optional<double> width_m;
	double point_height_m = 0;  ///< of its vanishing points, in the map
	Existence existence;

	[[nodiscard]] Eigen::Vector2d direction() const;
	/** On the axis, `along_m` from the point. */
	[[nodiscard]] Eigen::Vector2d at(double along_m) const;
};

struct CorridorTracks
{
	std::vector<CorridorTrack> tracks;  ///< by number
	int next_number = 1;
};

struct CorridorTrackConfig
{
	ExistenceConfig existence;
	double direction_rad = 0.026;              ///< 1.5°: standard deviation of a look's direction
	double middle_m = 0.1, one_sided_m = 0.7;  ///< of the axis, with walls on both sides and on one side
	double gate = 13.8;                        ///< of the squared Mahalanobis distance: 99.9 %, two degrees of freedom
	double max_gap_m = 3.0;                    ///< pieces of one line that are farther apart are two corridors
	double usual_width_m = 2.0;                ///< where only one wall was seen
	double detect_probability = 0.6;           ///< of a corridor along which the robot looks
	double forget_s = 60;                      ///< an unconfirmed track is kept for so long without a look
	int max_tracks = 200;
};
/** [corridor_tracks] */
void describe(FieldVisitor& fields, CorridorTrackConfig& config);

/** What one frame has to say about corridors. */
struct CorridorLook
{
	std::span<const VanishingPoint> vanishing_points_in_robot;
	std::span<const Wall> walls_in_robot;  ///< that the vanishing points' indices are of
	Eigen::Isometry3d map_from_robot = Eigen::Isometry3d::Identity();
	Eigen::Isometry3d robot_from_camera = Eigen::Isometry3d::Identity();
	double t_s = 0;            ///< mrpt::Clock::toDouble
	double clear_ahead_m = 0;  ///< depth in the middle of the image: with less, no corridor is missed; 0 = nothing is
};

/** The axis is the middle between the nearest of the vanishing point's walls on either side, else the line through the
 *  camera. */
CorridorSighting sightingOf(const VanishingPoint& vanishing_point_in_robot, const CorridorLook& look,
                            const CorridorTrackConfig& config);

/** Adds one frame; times must not go back. Returns the track of each of its vanishing points. Same looks, same tracks.
 */
std::vector<int> update(CorridorTracks& tracks, const CorridorLook& look, const CorridorTrackConfig& config);

/** As door_tracks.h has it. */
void correct(CorridorTracks& tracks, const Eigen::Isometry3d& new_map_from_map);

/** Confirmed corridors whose axis passes within half their width of the robot, as vanishing points in the robot frame:
 *  one per end that is at least a width away. */
std::vector<VanishingPoint> confirmedCorridors(const CorridorTracks& tracks, const Eigen::Isometry3d& robot_from_map);
}  // namespace explore

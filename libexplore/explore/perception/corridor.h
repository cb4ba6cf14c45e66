// Which way a corridor leads: a vote of all walls that run along with it, with abstention where there is none.
#pragma once

#include <explore/config/fields.h>
#include <explore/core/results.h>
#include <explore/perception/corridor_pairs.h>

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace explore
{
struct CorridorConfig
{
	CorridorPairConfig pairs;
	double min_width_m = 0.8, max_width_m = 4.0;
	double min_overlap_widths = 2.0;  ///< of facing walls that end in view
	double min_open_widths = 0.6;     ///< the same where they are not seen to end: the sensor's range ends them
	double min_wall_share = 0.33;     ///< of the overlap that has to be wall, on either side
	bool vote = true;                 ///< remedy 12; else the paper's way: the walls with the most samples, always
	double paper_parallel_rad = 0.17453292519943295;  ///< 10°: lines that lead to the same point in the paper's way
};

/** Field list of the above; without a section of its own. */
void describe(FieldVisitor& fields, CorridorConfig& config);

/** A corridor in the level frame. */
struct CorridorSeen
{
	Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit, to the side the camera looks to
	double sigma_rad = 0;                                  ///< of the direction; 0 in the paper's way
	Eigen::Vector2d point =
	    Eigen::Vector2d::Zero();     ///< on the line through the camera, where the walls were last seen
	std::vector<std::size_t> walls;  ///< that agree, ascending
	std::size_t samples = 0;         ///< of those
	double width_m = 0;              ///< between the facing walls; 0 in the paper's way
	double offset_m = 0;             ///< of the camera from the middle, positive to the left
	double from_m = 0, to_m = 0;     ///< where both facing walls are seen, along the direction, 0 = the camera
};

/** The corridor of which the longest stretch is in view; no value where no two walls 0.8–4 m apart face each other far
 *  enough. */
std::optional<CorridorSeen> findCorridor(const CorridorPairs& pairs, const CorridorConfig& config);

/** The same in the robot frame, at the camera's height as findVanishingPoints has it; `inliers` are samples. */
VanishingPoint vanishingPointOf(const CorridorSeen& corridor, const LevelPose& pose);
}  // namespace explore

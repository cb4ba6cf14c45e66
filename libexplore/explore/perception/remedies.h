// The remedies of method = full by name, so that each can be left out to see what it buys.
#pragma once

#include <array>
#include <string_view>

namespace explore
{
/** See doc/method.md; the numbers there count from 1 (tangent) on. */
enum class Remedy
{
	none,
	ray_evidence,     ///< 2: on, front, behind, no return for each ray through a gap
	height_profile,   ///< 3: floor to lintel
	depth_behind,     ///< 4: free depth beyond the wall
	corner_jambs,     ///< 5: the second jamb may stand on another plane
	leaf,             ///< 6: clear width
	jamb_fit,         ///< 7: jambs in the full-resolution image
	range_tolerance,  ///< 8: tolerance grows with range, coplanar pieces merged
	gravity_prior,    ///< 9: up from IMU, pose or the last ground; the floor need not be seen
	direction_vote,   ///< 12: abstains where there is no corridor
	robot_size,       ///< 14: any opening the robot fits
	floor_beyond,     ///< 15: no floor beyond is a drop
};
inline constexpr std::array<std::string_view, 12> kRemedyNames{
    "none",     "ray_evidence",    "height_profile", "depth_behind",   "corner_jambs", "leaf",
    "jamb_fit", "range_tolerance", "gravity_prior",  "direction_vote", "robot_size",   "floor_beyond"};

struct PerceptionConfig;

/** The configuration with one remedy switched off. */
PerceptionConfig without(Remedy remedy, PerceptionConfig config);
}  // namespace explore

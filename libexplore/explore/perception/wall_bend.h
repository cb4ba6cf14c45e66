// Miscalibrated depth, seen from walls: those that should be parallel or at right angles are not, and the more so the
// further to the side they stand.
#pragma once

#include <explore/perception/upright_walls.h>

#include <optional>
#include <span>
#include <string>

namespace explore
{
/** Sums over the frames so far. A depth measured as z + k z² has inverse depth 1/z − k to first order, and a constant
 *  in inverse depth leaves planes plane but turns each by k times its lateral distance: what looks bent is the room. */
struct WallBend
{
	std::size_t frames = 0;  ///< that showed walls to compare
	double weight = 0, weighted = 0, weighted_squares = 0;

	[[nodiscard]] double curvaturePerM() const { return weight > 0 ? weighted / weight : 0.0; }  ///< k
	/** Standard deviation of curvaturePerM(): the scatter between frames, and that rooms are not quite square. */
	[[nodiscard]] double sigmaPerM() const;
};

/** `bend` and what the walls of one more view say: pairs of long walls within 8° of parallel or of a right angle. Views
 *  that look up or down by more than 15° are left out. */
WallBend withFrame(const WallBend& bend, std::span<const UprightWall> walls, const LevelPose& pose);

/** One sentence for the user with the correction to set, where the walls of at least 20 frames say so clearly. */
std::optional<std::string> bentWallRemark(const WallBend& bend);
}  // namespace explore

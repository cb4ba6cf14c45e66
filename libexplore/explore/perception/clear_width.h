// How wide a disc gets through an opening past what stands in it, seen from above.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace explore
{
/** The diameter [m] of the widest upright disc that passes between the jambs (0, 0) and (width, 0), past `obstacles`
 *  (x along the opening, y through it). The wall goes on beyond both jambs.
 *
 *  The disc is stopped exactly when obstacles form a chain from jamb to jamb with every hop shorter than its diameter;
 *  so the answer is the least, over all chains, of the longest hop: the bottleneck path from one jamb to the other. */
double clearWidth(double width_m, const std::vector<Eigen::Vector2d>& obstacles);
}  // namespace explore

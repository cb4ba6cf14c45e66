// Notices an obstacle that slips under the sensor's minimum range, where it turns into pixels without return.
#pragma once

#include <explore/config/fields.h>
#include <explore/core/results.h>

namespace explore
{
struct NearFieldGuardConfig
{
	double warn_distance_m = 0.3;  ///< beyond the minimum range: an obstacle this near is watched
	double no_return_rise = 0.3;   ///< rise of a strip's no-return share that counts as "slipped under"
};
/** [heading] */
void describe(FieldVisitor& fields, NearFieldGuardConfig& config);

/** What is remembered of each image strip; no value = nothing. */
struct NearFieldGuard
{
	using Shares = std::array<std::optional<float>, NearField::kSectors>;
	Shares watched;  ///< the least no-return share while a near obstacle was in view
	Shares lost;     ///< the greatest no-return share since its obstacle slipped under the minimum range
};

/** The guard after this frame. A strip is watched while something nearer than min_range + warn_distance is in it. It is
 *  lost when its no-return share then rises by no_return_rise above the least it was: the obstacle still stands there,
 *  too near to be measured. It is found when the share has fallen by as much again: what stands behind is seen, or the
 *  obstacle itself. Unorganised clouds have no strips: the guard is empty. */
NearFieldGuard updateGuard(const NearFieldGuard& before, const NearField& now, double min_range_m,
                           const NearFieldGuardConfig& config);

/** True when a strip is lost. Whatever is in view and nearer than the minimum range is within the hull's reach, or all
 * but: there is no direction to drive around it by what one frame shows. */
bool obstacleLost(const NearFieldGuard& guard);
}  // namespace explore

#include <explore/navigation/near_field_guard.h>

#include <algorithm>

namespace explore
{
namespace
{
/** What the guard knows of one strip. */
struct Strip
{
	std::optional<float> watched, lost;
};

Strip updated(const Strip& before, const NearField::Sector& now, double near_m, double rise)
{
	const float share = now.no_return_share;
	if (before.lost && share > *before.lost - rise) return {before.watched, std::max(*before.lost, share)};
	if (!before.lost && before.watched && share >= *before.watched + rise) return {before.watched, share};
	const bool near = now.nearest_m > 0.0F && now.nearest_m < near_m;
	if (!near) return {};
	const float least = before.lost ? share : std::min(share, before.watched.value_or(share));
	return {least, std::nullopt};
}
}  // namespace

void describe(FieldVisitor& fields, NearFieldGuardConfig& config)
{
	fields.section("heading", "Speed and stop");
	fields.real("near_warn_distance", config.warn_distance_m, {0.0, 5.0}, "m",
	            "an obstacle within this beyond the sensor's minimum range is watched, lest it slips under");
	fields.real("no_return_rise", config.no_return_rise, {0.01, 1.0}, "",
	            "rise of an image strip's share of pixels without return that counts as slipped under");
}

NearFieldGuard updateGuard(const NearFieldGuard& before, const NearField& now, double min_range_m,
                           const NearFieldGuardConfig& config)
{
	NearFieldGuard after;
	if (!now.organised) return after;
	const double near_m = min_range_m + config.warn_distance_m;
	for (std::size_t i = 0; i < NearField::kSectors; ++i)
	{
		const Strip strip = updated({before.watched[i], before.lost[i]}, now.sectors[i], near_m, config.no_return_rise);
		after.watched[i] = strip.watched;
		after.lost[i] = strip.lost;
	}
	return after;
}

bool obstacleLost(const NearFieldGuard& guard)
{
	return std::ranges::any_of(guard.lost, [](const auto& lost) { return lost.has_value(); });
}
}  // namespace explore

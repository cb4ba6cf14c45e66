#include <explore/perception/corridor_companion.h>
#include <explore/perception/corridor_sides.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kLayer_m = 0.04, kStrip_m = 0.1;
constexpr std::size_t kLayers = 128, kStrips = 96;
constexpr std::size_t kFewestStrips = 6, kFewestOfLayer = 40;

/** Points at one distance, and which strips along the wall they are in. */
struct Layer
{
	std::size_t points = 0;
	std::bitset<kStrips> strips;
};

/** Two neighbouring layers as one: a plane may lie on their border. */
Layer together(const Layer& a, const Layer& b)
{
	return {a.points + b.points, a.strips | b.strips};
}
}  // namespace

std::optional<UprightWall> companionOf(const UprightWall& wall, const PlanPoints& points, double spacing_rad,
                                       const FacingConfig& facing)
{
	// Turned so that `wall` is at the right: its companion has positive distances across.
	const Eigen::Vector2d direction(wall.normal.y(), -wall.normal.x());
	const double forward = direction.x() < 0 ? -1.0 : 1.0;
	const TurnedPoints turned = turnedTo(direction, points);
	const double nearest = std::max(0.0, facing.min_width_m - wall.offset_m);
	std::array<Layer, kLayers> layers;
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const double layer = (turned.across[i] - nearest) / kLayer_m, strip = forward * turned.along[i] / kStrip_m;
		if (layer < 0 || layer >= static_cast<double>(kLayers) || strip < 0 || strip >= static_cast<double>(kStrips))
			continue;
		if (turned.across[i] > facing.max_width_m - wall.offset_m || !runsAlong(i, points, turned, spacing_rad))
			continue;
		Layer& here = layers[static_cast<std::size_t>(layer)];
		++here.points;
		here.strips.set(static_cast<std::size_t>(strip));
	}
	Layer best;
	double best_across_m = 0;
	for (std::size_t k = 0; k + 1 < kLayers; ++k)
	{
		const Layer layer = together(layers[k], layers[k + 1]);
		if (layer.points < kFewestOfLayer || layer.strips.count() <= best.strips.count()) continue;
		best = layer;
		best_across_m = nearest + static_cast<double>(k + 1) * kLayer_m;
	}
	if (best.strips.count() < kFewestStrips) return std::nullopt;
	std::size_t first = 0, end = kStrips;
	while (!best.strips.test(first)) ++first;
	while (!best.strips.test(end - 1)) --end;
	UprightWall companion;
	companion.normal = -wall.normal;
	companion.offset_m = best_across_m;
	companion.samples = best.points;
	const auto place = [&](std::size_t strip)
	{ return companion.along_m(forward * static_cast<double>(strip) * kStrip_m * direction); };
	companion.from_m = std::min(place(first), place(end));
	companion.to_m = std::max(place(first), place(end));
	return companion;
}
}  // namespace explore

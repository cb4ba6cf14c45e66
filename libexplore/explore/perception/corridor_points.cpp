#include <explore/perception/corridor_points.h>

namespace explore
{
namespace
{
constexpr float kHighest_m = 2.4F;  ///< of what is taken for wall: doors and windows are lower, ceilings are not
/** Floor is what lies lower than this, with so much more per metre of depth. */
constexpr float kFloor_m = 0.06F, kFloorPerMetre = 0.015F;

template <class Wanted>
PlanPoints pointsWhere(const LevelView& view, const SensorNoiseConfig& noise, Wanted wanted)
{
	const LevelSamples& samples = view.samples;
	PlanPoints points;
	points.x.reserve(samples.size());
	points.y.reserve(samples.size());
	points.sigma_per_m.reserve(samples.size());
	points.sample.reserve(samples.size());
	points.row.reserve(samples.size());
	for (std::size_t i = 0; i < samples.size(); ++i)
	{
		const float depth = samples.depth_m[i];
		if (!wanted(samples.z[i], kFloor_m + kFloorPerMetre * depth)) continue;
		points.x.push_back(samples.x[i]);
		points.y.push_back(samples.y[i]);
		points.sigma_per_m.push_back(static_cast<float>(depthSigma(depth, noise)) / depth);
		points.sample.push_back(static_cast<std::uint32_t>(i));
		points.row.push_back(samples.v[i]);
	}
	return points;
}
}  // namespace

PlanPoints uprightPoints(const LevelView& view, const SensorNoiseConfig& noise)
{
	return pointsWhere(view, noise, [](float z, float floor_m) { return z > floor_m && z <= kHighest_m; });
}

PlanPoints floorPoints(const LevelView& view, const SensorNoiseConfig& noise)
{
	return pointsWhere(view, noise, [](float z, float floor_m) { return std::abs(z) <= floor_m; });
}

TurnedPoints turnedTo(const Eigen::Vector2d& direction, const PlanPoints& points)
{
	const auto cosine = static_cast<float>(direction.x()), sine = static_cast<float>(direction.y());
	TurnedPoints turned{std::vector<float>(points.size()), std::vector<float>(points.size())};
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		turned.along[i] = cosine * points.x[i] + sine * points.y[i];
		turned.across[i] = cosine * points.y[i] - sine * points.x[i];
	}
	return turned;
}
}  // namespace explore

#include <explore/perception/corridor_walls.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace explore
{
namespace
{
/** How much wider than the walls' tolerance the rounds look: the first direction may be off by a degree or two. */
constexpr std::array<double, 3> kRounds{3.0, 1.5, 1.0};
/** Plaster, skirting and the sensor's own bow: no wall says more of its direction than this [rad]. */
constexpr double kStraightness_rad = 0.005;
/** Noise is alike among neighbouring pixels: this many samples count as one. */
constexpr double kSamplesAlike = 16.0;
constexpr double kPointFloor_m = 0.005;  ///< σ of a point across its wall without any depth noise
constexpr double kContradiction_rad = 0.035;
constexpr double kContradictionSigmas = 3.0;
constexpr double kMargin_m = 0.05;  ///< around a wall as it was found

/** Weighted moments of the points of one wall, seen along the corridor. */
struct Moments
{
	double weight = 0, along = 0, across = 0, along2 = 0, product = 0;

	void add(double w, double a, double c)
	{
		weight += w;
		along += w * a;
		across += w * c;
		along2 += w * a * a;
		product += w * a * c;
	}
	[[nodiscard]] double spread() const { return along2 - along * along / weight; }
	[[nodiscard]] double covariance() const { return product - along * across / weight; }
	/** σ of the wall's own slope [rad]. */
	[[nodiscard]] double slopeSigma() const
	{
		return std::hypot(std::sqrt(kSamplesAlike / spread()), kStraightness_rad);
	}
};

/** What a wall as it was found says of its direction: the longer and the better sampled, the more. */
double axisWeight(const UprightWall& wall)
{
	const double length = wall.to_m - wall.from_m;
	return static_cast<double>(wall.samples) * length * length;
}

/** One of the walls that are fitted together. */
struct FittedWall
{
	std::size_t index;
	double across_m;    ///< where it stands across the corridor
	PlanPoints points;  ///< that may be its own
	Moments moments;
};

/** The points near `wall`, as far from it as the first round looks. */
PlanPoints pointsNear(const UprightWall& wall, const PlanPoints& points, const UprightWallConfig& config)
{
	const auto nx = static_cast<float>(wall.normal.x()), ny = static_cast<float>(wall.normal.y());
	const auto offset = static_cast<float>(wall.offset_m), from = static_cast<float>(wall.from_m - kMargin_m),
	           to = static_cast<float>(wall.to_m + kMargin_m);
	const auto base = static_cast<float>(kRounds.front() * config.tolerance_m + kMargin_m),
	           per_sigma = static_cast<float>(kRounds.front() * config.tolerance_sigmas);
	PlanPoints near;
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const float toward = nx * points.x[i] + ny * points.y[i], along = nx * points.y[i] - ny * points.x[i];
		if (std::abs(toward + offset) > base + per_sigma * points.sigma_per_m[i] * std::abs(toward)) continue;
		if (along < from || along > to) continue;
		near.x.push_back(points.x[i]);
		near.y.push_back(points.y[i]);
		near.sigma_per_m.push_back(points.sigma_per_m[i]);
	}
	return near;
}

Moments momentsOf(const FittedWall& wall, const Eigen::Vector2d& direction, const UprightWallConfig& config)
{
	const TurnedPoints turned = turnedTo(direction, wall.points);
	const auto center = static_cast<float>(wall.across_m), per_sigma = static_cast<float>(config.tolerance_sigmas);
	const auto base = static_cast<float>(config.tolerance_m);
	Moments moments;
	for (std::size_t i = 0; i < turned.along.size(); ++i)
	{
		const float off = turned.across[i] - center;
		const float sigma = wall.points.sigma_per_m[i] * std::abs(turned.across[i]);
		if (std::abs(off) > base + per_sigma * sigma) continue;
		moments.add(1.0 / (sigma * sigma + kPointFloor_m * kPointFloor_m), turned.along[i], off);
	}
	return moments;
}

struct Slope
{
	double value = 0, sigma = 0;
};

Slope commonSlope(const std::vector<FittedWall>& walls)
{
	double sum = 0, weights = 0;
	for (const FittedWall& fitted : walls)
	{
		const Moments& wall = fitted.moments;
		if (wall.weight <= 0 || wall.spread() <= 0) continue;
		const double sigma = wall.slopeSigma(), weight = 1.0 / (sigma * sigma);
		sum += weight * wall.covariance() / wall.spread();
		weights += weight;
	}
	return weights > 0 ? Slope{sum / weights, 1.0 / std::sqrt(weights)} : Slope{};
}

bool contradicts(const Moments& wall, const Slope& slope)
{
	if (wall.weight <= 0 || wall.spread() <= 0) return true;
	return std::abs(wall.covariance() / wall.spread() - slope.value) >
	       std::max(kContradiction_rad, kContradictionSigmas * wall.slopeSigma());
}

/** The walls that run along the pair, the pair itself included; ascending. */
std::vector<std::size_t> wallsAlong(const FacingWalls& pair, const std::vector<UprightWall>& walls, double parallel_rad)
{
	std::vector<std::size_t> along;
	for (std::size_t i = 0; i < walls.size(); ++i)
		if (i == pair.left || i == pair.right || angleBetween(walls[i].tangent(), pair.direction) <= parallel_rad)
			along.push_back(i);
	return along;
}

/** The distance across at `along` = 0 for a wall of that slope, relative to where it was looked for. */
double shiftOf(const Moments& wall, double slope)
{
	return wall.weight > 0 ? (wall.across - slope * wall.along) / wall.weight : 0.0;
}
}  // namespace

Eigen::Vector2d forwardAxis(const UprightWall& wall)
{
	const Eigen::Vector2d axis = wall.tangent();
	return axis.x() < 0 ? Eigen::Vector2d(-axis) : axis;
}

double angleBetween(const Eigen::Vector2d& axis_a, const Eigen::Vector2d& axis_b)
{
	return std::atan2(std::abs(axis_a.x() * axis_b.y() - axis_a.y() * axis_b.x()), std::abs(axis_a.dot(axis_b)));
}

WallExtent extentAlong(const UprightWall& wall, const Eigen::Vector2d& direction)
{
	const double a = direction.dot(wall.at(wall.from_m)), b = direction.dot(wall.at(wall.to_m));
	return {std::min(a, b), std::max(a, b)};
}

std::vector<FacingWalls> facingWalls(const std::vector<UprightWall>& walls, const FacingConfig& config)
{
	std::vector<FacingWalls> pairs;
	for (std::size_t left = 0; left < walls.size(); ++left)
		for (std::size_t right = 0; right < walls.size(); ++right)
		{
			const UprightWall &left_wall = walls[left], &right_wall = walls[right];
			if (left_wall.normal.dot(right_wall.normal) > -std::cos(config.parallel_rad)) continue;
			// The normal of a wall at the left turns to the right.
			const Eigen::Vector2d left_axis = forwardAxis(left_wall), right_axis = forwardAxis(right_wall);
			if (leftOf(left_axis).dot(left_wall.normal) > 0) continue;
			const double width = left_wall.offset_m + right_wall.offset_m;
			if (width < config.min_width_m || width > config.max_width_m) continue;
			const double sign = left_axis.dot(right_axis) < 0 ? -1.0 : 1.0;
			const Eigen::Vector2d mean = axisWeight(left_wall) * left_axis + sign * axisWeight(right_wall) * right_axis;
			FacingWalls pair{mean.normalized(), 0.0, left_wall.offset_m, right_wall.offset_m, left, right, {}};
			pair.agreeing = wallsAlong(pair, walls, config.parallel_rad);
			pairs.push_back(std::move(pair));
		}
	return pairs;
}

void fitJointly(FacingWalls& pair, const std::vector<UprightWall>& walls, const PlanPoints& points,
                const UprightWallConfig& config)
{
	std::vector<FittedWall> fitted;
	fitted.reserve(pair.agreeing.size());
	// Each stands where its middle is: turning moves it least there.
	const Eigen::Vector2d left = leftOf(pair.direction);
	for (const std::size_t i : pair.agreeing)
		fitted.push_back({i,
		                  left.dot(walls[i].at(0.5 * (walls[i].from_m + walls[i].to_m))),
		                  pointsNear(walls[i], points, config),
		                  {}});
	for (const double widened : kRounds)
	{
		UprightWallConfig tolerance = config;
		tolerance.tolerance_m *= widened;
		tolerance.tolerance_sigmas *= widened;
		for (FittedWall& wall : fitted) wall.moments = momentsOf(wall, pair.direction, tolerance);
		const Slope first = commonSlope(fitted);
		std::erase_if(
		    fitted, [&](const FittedWall& wall)
		    { return wall.index != pair.left && wall.index != pair.right && contradicts(wall.moments, first); });
		const Slope slope = commonSlope(fitted);
		for (FittedWall& wall : fitted) wall.across_m += shiftOf(wall.moments, slope.value);
		pair.direction = (pair.direction + slope.value * leftOf(pair.direction)).normalized();
		pair.sigma_rad = slope.sigma;
	}
	pair.agreeing.clear();
	for (const FittedWall& wall : fitted)
	{
		pair.agreeing.push_back(wall.index);
		if (wall.index == pair.left) pair.left_m = wall.across_m;
		if (wall.index == pair.right) pair.right_m = -wall.across_m;
	}
}
}  // namespace explore

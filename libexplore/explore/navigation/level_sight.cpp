#include <explore/navigation/level_sight.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace explore
{
namespace
{
constexpr float kUnbounded = std::numeric_limits<float>::infinity();

/** Of each ray the nearest one with a return in each direction of the grid, itself included; kNobody without one. */
struct Neighbours
{
	static constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();
	std::vector<std::size_t> left, right, above, below;

	explicit Neighbours(const SightLines& lines) : left(lines.size(), kNobody), right(left), above(left), below(left)
	{
		const std::size_t columns = lines.columns, count = lines.size();
		const auto next = [&](std::vector<std::size_t>& of, std::size_t i, bool inside, std::size_t before)
		{
			if (lines.depth_m[i] > 0.0F)
				of[i] = i;
			else if (inside)
				of[i] = of[before];
		};
		for (std::size_t i = 0; i < count; ++i)
		{
			next(left, i, i % columns > 0, i - 1);
			next(above, i, i >= columns, i - columns);
		}
		for (std::size_t i = count; i-- > 0;)
		{
			next(right, i, i % columns + 1 < columns, i + 1);
			next(below, i, i + columns < count, i + columns);
		}
	}
};

/** Judges the rays without return by what surrounds them in the grid. */
class Surroundings
{
public:
	Surroundings(const SightLines& lines, const LevelFrame& level)
	    : m_lines(lines),
	      m_up(level.level_from_robot.row(2).cast<float>()),
	      m_camera_m(static_cast<float>(m_up.dot(lines.origin_in_robot.cast<float>()) + level.altitude_m)),
	      m_near(lines)
	{
	}
	/** Depth up to which ray i is held to be clear. */
	[[nodiscard]] float clearDepth(std::size_t i) const
	{
		if (m_lines.depth_m[i] > 0.0F) return m_lines.depth_m[i];
		const std::size_t left = m_near.left[i], right = m_near.right[i], above = m_near.above[i],
		                  below = m_near.below[i];
		if (isNear(left, right, 1)) return std::min(depth(left), depth(right));
		if (right == Neighbours::kNobody && isNear(left, i, 1)) return depth(left);
		if (left == Neighbours::kNobody && isNear(i, right, 1)) return depth(right);
		const auto columns = static_cast<std::ptrdiff_t>(m_lines.columns);
		const float across = std::max(bound(left, -1), bound(right, 1)), over = bound(above, -columns);
		if (below == Neighbours::kNobody)
		{
			if (isNear(above, i, m_lines.columns)) return depth(above);
			return std::isinf(across) && std::isinf(over) ? kUnbounded : 0.0F;
		}
		const float under = bound(below, columns);
		return std::min(across, isFloor(below) ? under : std::max(over, under));
	}

private:
	[[nodiscard]] float depth(std::size_t i) const { return m_lines.depth_m[i]; }
	/** How far away what begins next to a ray with a return is held to be, `outward` being the way on in the grid: as
	 * far as that return. Unbounded where it lies on a surface that falls back so steeply that it is no wonder when it
	 * does not answer further on. 0 without a ray. */
	[[nodiscard]] float bound(std::size_t i, std::ptrdiff_t outward) const
	{
		// From one ray to the next, 0.8° on. What is seen at an angle of 73° does so sideways; the floor, which tells
		// where dark things stand, may be seen more flatly.
		constexpr float kWallFallsBack = 1.045F, kFloorFallsBack = 1.06F, kJumps = 1.35F;
		if (i == Neighbours::kNobody) return 0.0F;
		const float falls = outward <= 1 ? kWallFallsBack : kFloorFallsBack;
		float here = depth(i);
		auto next = static_cast<std::ptrdiff_t>(i);
		for (int pair = 0; pair < 2; ++pair)  // the outermost ray may be a stray
		{
			next += outward;
			const bool inside = next >= 0 && next < static_cast<std::ptrdiff_t>(m_lines.size());
			const float before = inside ? depth(static_cast<std::size_t>(next)) : 0.0F;
			if (before > 0.0F && here > falls * before && here < kJumps * before) return kUnbounded;
			here = before;
		}
		return depth(i);
	}
	/** Whether no more than a speck lies between two rays. */
	static bool isNear(std::size_t first, std::size_t second, std::size_t stride)
	{
		constexpr std::size_t kSpeck = 3;
		return first != Neighbours::kNobody && second != Neighbours::kNobody && second - first <= (kSpeck + 1) * stride;
	}
	[[nodiscard]] bool isFloor(std::size_t i) const
	{
		constexpr float kFloor_m = 0.1F;
		return m_camera_m + m_up.dot(m_lines.ray_in_robot[i]) * m_lines.depth_m[i] < kFloor_m;
	}

	const SightLines& m_lines;
	Eigen::Vector3f m_up;
	float m_camera_m;  ///< height above the floor
	Neighbours m_near;
};
}  // namespace

bool LevelSight::sees(double azimuth_rad, double elevation_rad) const
{
	const double level_cosine = std::cos(elevation_rad);
	const Eigen::Vector3d direction(level_cosine * std::cos(azimuth_rad), level_cosine * std::sin(azimuth_rad),
	                                std::sin(elevation_rad));
	return lines->sees(level.level_from_robot.transpose() * direction);
}

LevelSight sightInLevel(const SightLines& lines, const LevelFrame& level)
{
	LevelSight sight{&lines, level, level.level_from_robot * lines.origin_in_robot, {}};
	const Eigen::Matrix3f turn = level.level_from_robot.cast<float>();
	const Surroundings surroundings(lines, level);
	sight.rays.reserve(lines.size());
	for (std::size_t i = 0; i < lines.size(); ++i)
	{
		const Eigen::Vector3f ray = turn * lines.ray_in_robot[i];
		const float flat = std::max(ray.head<2>().norm(), 1e-6F);
		sight.rays.push_back(
		    {std::atan2(ray.y(), ray.x()), ray.z() / flat, lines.depth_m[i] * flat, surroundings.clearDepth(i) * flat});
	}
	return sight;
}
}  // namespace explore

// Floor-plan geometry of made-up buildings: spans, wall frames, convex outlines, and what part of the floor is taken.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace explore::simulation
{
struct Span
{
	double low = 0, high = 0;

	[[nodiscard]] double length() const { return high - low; }
	[[nodiscard]] double middle() const { return 0.5 * (low + high); }
	[[nodiscard]] Span grown(double by) const { return {low - by, high + by}; }
	[[nodiscard]] bool overlaps(const Span& other) const { return low < other.high && other.low < high; }
};
[[nodiscard]] inline Span around(double middle, double length)
{
	return {middle - 0.5 * length, middle + 0.5 * length};
}

/** A vertical face on the plan, seen from in front of it: x runs along it to the right, y goes behind it, z is up. */
struct WallFrame
{
	Eigen::Vector2d origin = Eigen::Vector2d::Zero();
	double angle_rad = 0;  ///< of its x axis in the building

	[[nodiscard]] Eigen::Vector2d at(double along_m, double behind_m) const;
	/** building_from_thing for a thing at that place, turned by `turn_rad` about z. */
	[[nodiscard]] Eigen::Isometry3d pose(double along_m, double behind_m, double z_m = 0, double turn_rad = 0) const;
	/** The point's along (x) and behind (y). */
	[[nodiscard]] Eigen::Vector2d coordinatesOf(const Eigen::Vector2d& point) const;
	/** The direction from behind the face to its front. */
	[[nodiscard]] Eigen::Vector2d outward() const { return at(0, -1) - origin; }
};

/** A convex polygon, in either sense of rotation. */
using Outline = std::vector<Eigen::Vector2d>;
Outline rectangleOutline(const WallFrame& frame, const Span& along, const Span& behind);
/** Footprint of `size` around a thing's origin. */
Outline footprint(const Eigen::Isometry3d& building_from_thing, const Eigen::Vector2d& size_m);
/** An octagon around the disc. */
Outline discOutline(const Eigen::Vector2d& center, double radius_m);

bool overlap(const Outline& a, const Outline& b);
/** 0 where they overlap. */
double distanceBetween(const Outline& a, const Outline& b);

/** Which parts of the floor may still be stood on. */
class FloorUse
{
public:
	/** Nothing may stand there. */
	void take(Outline outline) { m_taken.push_back(std::move(outline)); }
	/** Only things lower than `height_m` may stand there. */
	void keepLow(Outline outline, double height_m) { m_low.push_back({std::move(outline), height_m}); }
	[[nodiscard]] bool isFree(const Outline& outline, double height_m) const;

private:
	struct Low
	{
		Outline outline;
		double height_m;
	};
	std::vector<Outline> m_taken;
	std::vector<Low> m_low;
};
}  // namespace explore::simulation

#include "support/building_leaves.h"

#include <algorithm>
#include <cmath>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;

/** A leaf of that length, turned about its hinge at (0, v). */
Footprint hinged(const LeafAxes& axes, double length_m, double v, double angle_rad)
{
	const double c = std::cos(angle_rad), s = std::sin(angle_rad);
	const auto turned = [&](double u, double w) { return axes.at({c * u - s * w, v + s * u + c * w}); };
	return {turned(kSlit_m, -kLeaf_m), turned(length_m, -kLeaf_m), turned(length_m, 0), turned(kSlit_m, 0)};
}

Footprint slid(const Opening& opening, double thickness_m)
{
	const LeafAxes axes = axesOf(opening, opening.hinge_left);
	const double covered = opening.width_m - opening.slid_m;
	if (opening.filling == Filling::sliding_wall)
		return rectangle(axes, {-0.05, -0.5 * kLeaf_m}, {covered, 0.5 * kLeaf_m});
	const double v = 0.5 * thickness_m + 0.015 + opening.casing_proud_m;
	return rectangle(axes, {covered - opening.width_m - 0.1, v}, {covered, v + kLeaf_m});
}

double segmentDistance(const Vector2d& point, const Vector2d& from, const Vector2d& to)
{
	const Vector2d along = to - from;
	const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
	return (point - from - share * along).norm();
}

bool separated(const Footprint& a, const Footprint& b)
{
	for (const Footprint* footprint : {&a, &b})
		for (std::size_t i = 0; i < 4; ++i)
		{
			const Vector2d edge = (*footprint)[(i + 1) % 4] - (*footprint)[i], normal(-edge.y(), edge.x());
			std::array<double, 2> low{1e9, 1e9}, high{-1e9, -1e9};
			std::size_t which = 0;
			for (const Footprint* other : {&a, &b})
			{
				for (const Vector2d& corner : *other)
				{
					low.at(which) = std::min(low.at(which), normal.dot(corner));
					high.at(which) = std::max(high.at(which), normal.dot(corner));
				}
				++which;
			}
			if (high[0] < low[1] || high[1] < low[0]) return true;
		}
	return false;
}

/** What stands at one jamb: wall, stop, casings and the leaf that is hinged (or slides) there. */
std::vector<Footprint> solidsAt(const Opening& opening, double thickness_m, bool at_start)
{
	const LeafAxes axes = axesOf(opening, at_start);
	const double half = 0.5 * thickness_m;
	std::vector<Footprint> solids{rectangle(axes, {-1, -half}, {0, half})};
	if (opening.stop_m > 0)
	{
		const double v = half - opening.recess_m - kLeaf_m;
		solids.push_back(rectangle(axes, {-0.1, v - 0.03}, {opening.stop_m, v}));
	}
	if (opening.casing_m > 0 && opening.casing_at[at_start ? 0 : 1])
		for (const double face : {-1.0, 1.0})
			solids.push_back(
			    rectangle(axes, {-opening.casing_m, face * half}, {-0.005, face * (half + opening.casing_proud_m)}));
	// A wall across, as far as a leaf reaches.
	const double across = opening.corner_m[at_start ? 0 : 1];
	if (across < 1) solids.push_back(rectangle(axes, {-across - 0.1, 0}, {-across, half + 1.5}));
	const std::vector<Footprint> leaves = leavesOf(opening, thickness_m);
	if (opening.filling == Filling::two_leaves)
		solids.push_back(leaves[at_start ? 0 : 1]);
	else if (!leaves.empty() && at_start == opening.hinge_left)
		solids.push_back(leaves[0]);
	return solids;
}
}  // namespace

LeafAxes axesOf(const Opening& opening, bool at_start)
{
	const double half = 0.5 * opening.width_m;
	return {opening.middle_m + (at_start ? -half : half), at_start ? 1.0 : -1.0, static_cast<double>(opening.side)};
}

Footprint rectangle(const LeafAxes& axes, const Vector2d& low, const Vector2d& high)
{
	return {axes.at(low), axes.at({high.x(), low.y()}), axes.at(high), axes.at({low.x(), high.y()})};
}

double distanceOf(const Footprint& a, const Footprint& b)
{
	if (!separated(a, b)) return 0;
	double nearest = 1e9;
	for (std::size_t i = 0; i < 4; ++i)
		for (std::size_t k = 0; k < 4; ++k)
			nearest = std::min(
			    {nearest, segmentDistance(a[i], b[k], b[(k + 1) % 4]), segmentDistance(b[i], a[k], a[(k + 1) % 4])});
	return nearest;
}

Opening movingPartOf(const Opening& opening)
{
	Opening part = opening;
	if (opening.filling != Filling::fixed_leaf) return part;
	part.filling = Filling::leaf;
	part.width_m = 0.5 * opening.width_m;
	part.middle_m += opening.hinge_left ? -0.5 * part.width_m : 0.5 * part.width_m;
	part.stop_m = 0;
	part.corner_m[opening.hinge_left ? 1 : 0] = 10;
	part.casing_at[opening.hinge_left ? 1 : 0] = false;
	return part;
}

std::vector<Footprint> leavesOf(const Opening& opening, double thickness_m)
{
	const double v = 0.5 * thickness_m - opening.recess_m, width = opening.width_m;
	switch (opening.filling)
	{
		case Filling::leaf:
			return {hinged(axesOf(opening, opening.hinge_left), width - kSlit_m, v, opening.angle_rad)};
		case Filling::two_leaves:
			return {hinged(axesOf(opening, true), 0.5 * width - kSlit_m, v, opening.angle_rad),
			        hinged(axesOf(opening, false), 0.5 * width - kSlit_m, v, opening.angle_rad)};
		case Filling::sliding_face:
		case Filling::sliding_wall:
			return {slid(opening, thickness_m)};
		default:
			return {};
	}
}

double clearWidthOf(const Opening& opening, double thickness_m)
{
	double clear = opening.width_m;
	for (const Footprint& a : solidsAt(opening, thickness_m, true))
		for (const Footprint& b : solidsAt(opening, thickness_m, false)) clear = std::min(clear, distanceOf(a, b));
	return clear;
}
}  // namespace explore::test

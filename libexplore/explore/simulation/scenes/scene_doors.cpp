#include "scene_doors.h"

#include <explore/core/geometry.h>
#include <explore/simulation/shapes.h>

#include <algorithm>
#include <cmath>

namespace explore::simulation
{
namespace
{
constexpr double kLeafThickness_m = 0.04, kLeafGap_m = 0.006;
const Eigen::Vector3f kLeafColor(0.6F, 0.5F, 0.4F);

/** The leaf's own frame: x from the hinge to its free edge, y through it, in the wall's along and behind. */
struct Hinge
{
	Eigen::Vector2d pin, toward_edge, through;
};

Hinge hingeOf(const DoorPlan& door, double wall_thickness_m)
{
	const Span span = door.along();
	const double side = door.leaf.hinge_low ? 1.0 : -1.0, into = door.leaf.toward_robot ? -1.0 : 1.0;
	const double angle_rad = door.leaf.angle_rad;
	Hinge hinge;
	// A leaf that is folded back to the wall hangs on hinges that stand off from it.
	const double stand_off_m = angle_rad > 120 * kDegree_rad ? kLeafThickness_m + 0.02 : 0.0;
	hinge.pin = {(door.leaf.hinge_low ? span.low : span.high) - side * (stand_off_m > 0 ? 0.01 : 0.0),
	             (door.leaf.toward_robot ? 0.0 : wall_thickness_m) + into * stand_off_m};
	hinge.toward_edge = {side * std::cos(angle_rad), into * std::sin(angle_rad)};
	hinge.through = {-side * std::sin(angle_rad), into * std::cos(angle_rad)};
	return hinge;
}

double leafWidth(const DoorPlan& door)
{
	return door.width_m - 2 * kLeafGap_m;
}

/** On both faces of a leaf, near its free edge; the leaf's frame is in its middle. */
void addHandles(Sketch& sketch, const DoorPlan& door, const Eigen::Isometry3d& building_from_leaf)
{
	const std::size_t steel = sketch.material("handle", {0.6F, 0.6F, 0.62F});
	const double x_m = 0.5 * leafWidth(door) - 0.05, y_m = 0.5 * kLeafThickness_m + 0.03, z_m = 1.03;
	for (const double side_m : {-y_m, y_m})
		sketch.place(door.id + "_leaf", boxMesh({0.12, 0.06, 0.025}),
		             building_from_leaf * Eigen::Translation3d(x_m, side_m, z_m), steel);
}

void hangLeaf(Sketch& sketch, const WallPlan& wall, const DoorPlan& door)
{
	const Hinge hinge = hingeOf(door, wall.thickness_m);
	const Eigen::Vector2d middle =
	    hinge.pin + 0.5 * leafWidth(door) * hinge.toward_edge + 0.5 * kLeafThickness_m * hinge.through;
	const double turn_rad = std::atan2(hinge.toward_edge.y(), hinge.toward_edge.x());
	const double top_m = topOf(door, wall) - 2 * kLeafGap_m, bottom_m = kLeafGap_m;
	const std::size_t color = sketch.material("leaf", kLeafColor);
	sketch.place(door.id + "_leaf", boxMesh({leafWidth(door), kLeafThickness_m, top_m - bottom_m}),
	             wall.frame.pose(middle.x(), middle.y(), 0.5 * (top_m + bottom_m), turn_rad), color);
	if (door.leaf.angle_rad > 120 * kDegree_rad) return;
	addHandles(sketch, door, wall.frame.pose(middle.x(), middle.y(), 0, turn_rad));
	sketch.floor_use.take(footprint(wall.frame.pose(middle.x(), middle.y(), 0, turn_rad),
	                                {leafWidth(door) + 0.1, kLeafThickness_m + 0.2}));
}

void shut(Sketch& sketch, const WallPlan& wall, const DoorPlan& door)
{
	const Span behind{door.leaf.recess_m, door.leaf.recess_m + kLeafThickness_m};
	sketch.block(door.id + "_leaf", wall.frame, door.along(), behind, {0, topOf(door, wall)},
	             sketch.material("leaf", kLeafColor));
	addHandles(sketch, door, wall.frame.pose(door.along_m, behind.middle()));
}

void addLabel(Sketch& sketch, const WallPlan& wall, const DoorPlan& door)
{
	DoorLabel label;
	label.id = door.id;
	const Eigen::Vector2d center = wall.frame.at(door.along_m, 0.5 * wall.thickness_m);
	label.floor_center_in_map << center, 0.0;
	label.normal_in_map << wall.frame.outward(), 0.0;
	label.width_m = door.width_m;
	if (const double top_m = topOf(door, wall); top_m < wall.height_m) label.height_m = top_m;
	label.depth_m = wall.thickness_m;
	label.clear_width_m = door.clear_width_m > 0 ? door.clear_width_m : clearWidth(door, wall.thickness_m);
	if (!door.hole || door.leaf.kind == LeafKind::recessed) label.clear_width_m = 0;
	label.sill_m = door.sill_m;
	label.verdict = door.verdict;
	sketch.world.doors.push_back(label);
}
}  // namespace

DoorPlan drawDoor(Sketch& sketch, const Span& width_m)
{
	Random& random = sketch.random;
	DoorPlan door;
	door.width_m = sketch.draw(width_m);
	door.top_m = random.uniform(1.9, 2.1);
	door.leaf.hinge_low = random.chance(0.5);
	const int kind = random.integer(0, 2);
	if (kind > 0) door.leaf.kind = LeafKind::hinged;
	door.leaf.angle_rad = sketch.drawAngle(kind == 1 ? Span{165, 176} : Span{80, 110});
	return door;
}

double topOf(const DoorPlan& door, const WallPlan& wall)
{
	return std::min(door.top_m.value_or(wall.height_m), wall.height_m);
}

Opening openingOf(const DoorPlan& door, const WallPlan& wall)
{
	return {door.along(), {0.0, topOf(door, wall)}};
}

Outline leafOutline(const DoorPlan& door, double wall_thickness_m)
{
	if (door.leaf.kind != LeafKind::hinged) return {};
	const Hinge hinge = hingeOf(door, wall_thickness_m);
	const Eigen::Vector2d edge = leafWidth(door) * hinge.toward_edge, through = kLeafThickness_m * hinge.through;
	return {hinge.pin, hinge.pin + edge, hinge.pin + edge + through, hinge.pin + through};
}

double clearWidth(const DoorPlan& door, double wall_thickness_m)
{
	if (door.leaf.kind != LeafKind::hinged) return door.width_m;
	const Span span = door.along();
	const double other_m = door.leaf.hinge_low ? span.high : span.low;
	const double beside_m = other_m + (door.leaf.hinge_low ? 1.0 : -1.0);
	const Outline other_side = {{other_m, 0}, {beside_m, 0}, {beside_m, wall_thickness_m}, {other_m, wall_thickness_m}};
	return std::min(door.width_m, distanceBetween(leafOutline(door, wall_thickness_m), other_side));
}

void buildDoor(Sketch& sketch, const WallPlan& wall, const DoorPlan& door)
{
	if (door.leaf.kind == LeafKind::hinged) hangLeaf(sketch, wall, door);
	if (door.leaf.kind == LeafKind::recessed) shut(sketch, wall, door);
	if (door.sill_m > 0)
		sketch.block(door.id + "_sill", wall.frame, door.along(), {0, wall.thickness_m}, {0, door.sill_m},
		             sketch.material("sill", kLeafColor));
	addLabel(sketch, wall, door);
	sketch.floor_use.take(rectangleOutline(wall.frame, door.freeAlong(), {-kFreeBeforeDoor_m, wall.thickness_m}));
}

TriangleMesh curtainMesh(double width_m, double height_m, double fold_depth_m, int folds)
{
	constexpr int kStepsAFold = 8;
	TriangleMesh mesh;
	const int steps = folds * kStepsAFold;
	for (int i = 0; i <= steps; ++i)
	{
		const double x_m = width_m * (static_cast<double>(i) / steps - 0.5);
		const double y_m = 0.5 * fold_depth_m * std::sin(2 * std::numbers::pi * i / kStepsAFold);
		for (const double z_m : {0.0, height_m})
			mesh.vertices.emplace_back(Eigen::Vector3d(x_m, y_m, z_m).cast<float>());
	}
	for (int i = 0; i < steps; ++i)
	{
		const auto first = static_cast<std::uint32_t>(2 * i);
		mesh.triangles.push_back({first, first + 2, first + 3});
		mesh.triangles.push_back({first, first + 3, first + 1});
	}
	return mesh;
}
}  // namespace explore::simulation

// Doorways of made-up buildings: their size, leaf and filling, and the label that says what they are.
#pragma once

#include <explore/simulation/scenes/scene_walls.h>

#include <optional>
#include <string>

namespace explore::simulation
{
/** What stays free of furniture before and behind a doorway. */
constexpr double kFreeBeforeDoor_m = 1.0, kFreeBehindDoor_m = 1.3;
/** And beside one with a leaf half open. */
constexpr double kFreeBesideAjar_m = 0.9;

enum class LeafKind
{
	none,
	hinged,    ///< turned about a jamb's edge by the leaf's angle
	recessed,  ///< shut, somewhat behind the wall's face
};

struct Leaf
{
	LeafKind kind = LeafKind::none;
	double angle_rad = 0;       ///< 0 = shut
	bool hinge_low = true;      ///< hangs at the jamb of smaller along
	bool toward_robot = false;  ///< opens to the robot's side
	double recess_m = 0;
};

/** What is behind a doorway. */
enum class Beyond
{
	space,      ///< a room or corridor
	dark,       ///< one of which nothing returns
	stairwell,  ///< stairs or a shaft downward
	nothing,    ///< never to be seen
};

struct DoorPlan
{
	std::string id = "door_1";
	double along_m = 0;  ///< its middle
	double width_m = 0.9;
	std::optional<double> top_m = 2.0;  ///< no value = no lintel
	double sill_m = 0;
	Verdict verdict = Verdict::open;
	Leaf leaf;
	Beyond beyond = Beyond::space;
	bool hole = true;          ///< false: something on the wall that looks like a doorway
	double clear_width_m = 0;  ///< 0 = what the leaf leaves

	/** Half shut: the way leads past the leaf's edge, aside. */
	[[nodiscard]] bool isAjar() const { return verdict == Verdict::ajar; }
	[[nodiscard]] Span along() const { return around(along_m, width_m); }
	/** What stays free of furniture and walls along the wall. */
	[[nodiscard]] Span freeAlong() const { return along().grown(isAjar() ? kFreeBesideAjar_m : 0.05); }
};

/** An open doorway of 0.7–1.3 m × 1.9–2.1 m with one of the leaves that open doors have: none, folded back to the wall
 *  behind, or opened into the room behind by 80–110°. */
DoorPlan drawDoor(Sketch& sketch, const Span& width_m = {0.7, 1.3});
/** The doorway's top in a wall of that height, and its hole. */
double topOf(const DoorPlan& door, const WallPlan& wall);
Opening openingOf(const DoorPlan& door, const WallPlan& wall);

/** The leaf's outline on the plan, in the wall's along and behind; empty without a hinged leaf. */
Outline leafOutline(const DoorPlan& door, double wall_thickness_m);
/** The widest disc that gets past a hinged leaf; the opening's width without one. */
double clearWidth(const DoorPlan& door, double wall_thickness_m);

/** Adds leaf, threshold and label, and keeps the way through free of furniture. The hole itself is the wall's. */
void buildDoor(Sketch& sketch, const WallPlan& wall, const DoorPlan& door);

/** A thin sheet with vertical folds, as a curtain hangs. */
TriangleMesh curtainMesh(double width_m, double height_m, double fold_depth_m, int folds);
}  // namespace explore::simulation

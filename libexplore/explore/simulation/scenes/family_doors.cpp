#include <explore/simulation/scenes/family_parts.h>
#include <explore/simulation/scenes/scene_furniture.h>
#include <explore/simulation/scenes/scene_rooms.h>

#include <algorithm>
#include <array>

namespace explore::simulation
{
namespace
{
const ViewRange kDoorViews{{1.0, 4.9}, {0, 60}};

void frontal(Sketch& sketch)
{
	drawDoorway(sketch, drawDoor(sketch), {{1.0, 4.9}, {0, 15}});
}

void oblique(Sketch& sketch)
{
	drawDoorway(sketch, drawDoor(sketch), {{1.0, 4.9}, {45, 75}});
}

void farAway(Sketch& sketch)
{
	drawDoorway(sketch, drawDoor(sketch), {{4.4, 4.9}, {0, 60}});
}

void narrow(Sketch& sketch)
{
	drawDoorway(sketch, drawDoor(sketch, {0.70, 0.85}), kDoorViews);
}

/** One jamb is the room's corner, or nearly so. */
void inTheCorner(Sketch& sketch)
{
	const DoorPlan door = drawDoor(sketch);
	const double to_corner_m = sketch.random.uniform(0.0, 0.08), side = sketch.random.sign();
	FrontPlan front;
	if (side > 0)
		front.low_m = door.along().low - to_corner_m;
	else
		front.high_m = door.along().high + to_corner_m;
	drawDoorway(sketch, door, {{1.0, 4.9}, {0, 60}, side}, front);
}

/** Rolled up to 20° and looking up to 20° upward. */
void tilted(Sketch& sketch)
{
	Random& random = sketch.random;
	const int kind = random.integer(0, 2);
	const double side = random.sign(), roll_rad = kind == 1 ? 0.0 : side * sketch.drawAngle({10, 20});
	const double pitch_rad = kind == 0 ? sketch.drawAngle({-5, 5}) : -sketch.drawAngle({10, 20});
	Viewpoint& view = sketch.view;
	(sketch.flies() ? view.body_roll_rad : view.mount_roll_rad) = roll_rad;
	(sketch.flies() ? view.body_pitch_rad : view.mount_pitch_rad) = pitch_rad;
	drawDoorway(sketch, drawDoor(sketch), {{1.3, 4.7}, {0, 60}});
}

void floorUnseen(Sketch& sketch)
{
	Viewpoint& view = sketch.view;
	(sketch.flies() ? view.body_pitch_rad : view.mount_pitch_rad) =
	    -sketch.drawAngle(sketch.flies() ? Span{4, 10} : Span{14, 24});
	sketch.promise.floor_unseen = true;
	drawDoorway(sketch, drawDoor(sketch), {{1.0, 4.0}, {0, 60}});
}

void lowThreshold(Sketch& sketch)
{
	DoorPlan door = drawDoor(sketch);
	door.sill_m = sketch.random.uniform(0.02, 0.04);
	drawDoorway(sketch, door, kDoorViews);
}

void withoutLintel(Sketch& sketch)
{
	DoorPlan door = drawDoor(sketch, {1.1, 1.7});
	door.top_m.reset();
	door.leaf.kind = LeafKind::none;
	door.verdict = Verdict::passage;
	drawDoorway(sketch, door, {{1.6, 4.8}, {0, 60}});
}

void wide(Sketch& sketch)
{
	DoorPlan door = drawDoor(sketch, {2.3, 3.4});
	door.top_m.reset();
	if (sketch.random.chance(0.5)) door.top_m = sketch.random.uniform(2.0, 2.25);
	door.leaf.kind = LeafKind::none;
	door.verdict = Verdict::passage;
	drawDoorway(sketch, door, {{2.4, 4.7}, {0, 60}});
}

/** Pilasters or wardrobes beside the doorway, or two parts of the wall that do not lie in one plane. */
void splitWall(Sketch& sketch)
{
	Random& random = sketch.random;
	const DoorPlan door = drawDoor(sketch);
	FrontPlan front;
	const int kind = random.integer(0, 2);
	const double first_side = random.sign();
	if (kind == 0) front.step_m = first_side * random.uniform(0.02, 0.08);
	front.extent = door.along().grown(kind == 0 ? 0.3 : 1.2);
	if (!lookAt(sketch, {WallFrame{}, door.along()}, kDoorViews)) return;
	for (const double side : {-1.0, 1.0})
	{
		const double from_m = side > 0 ? door.along().high : door.along().low;
		const double gap_m = random.uniform(0.1, 0.5);
		if (kind == 1)
		{
			const Span along = around(from_m + side * (gap_m + 0.15), random.uniform(0.15, 0.4));
			const Span before{-random.uniform(0.05, 0.3), 0}, z{0, sketch.style.wall_height_m};
			sketch.block("pilaster", {}, along, before, z, sketch.material("plaster"));
			sketch.floor_use.take(rectangleOutline({}, along, {-0.4, 0}));
		}
		Piece wardrobe = drawPiece(random, "wardrobe");
		wardrobe.size_m.x() = std::min(wardrobe.size_m.x(), 0.8);
		if (kind == 2)
			putPiece(sketch, wardrobe,
			         WallFrame{}.pose(from_m + side * (gap_m + 0.5 * wardrobe.size_m.x()),
			                          -0.5 * wardrobe.size_m.y() - 0.03));
	}
	sketch.promise.visible_doors.push_back(door.id);
	front.side.doors.push_back(door);
	buildFront(sketch, std::move(front));
}

/** The camera sees one jamb only. */
void jambOutOfView(Sketch& sketch)
{
	const DoorPlan door = drawDoor(sketch);
	const Subject subject{WallFrame{}, door.along()};
	if (!lookPast(sketch, subject, {{1.0, 4.0}, {0, 55}})) return;
	sketch.promise.regions.push_back(regionOf(subject, {0.2, 1.8}, {0.15, 0.85}));
	sketch.promise.one_jamb = door.id;
	FrontPlan front;
	front.side.doors.push_back(door);
	buildFront(sketch, std::move(front));
}

/** A low box before one jamb, beside the way through. */
void boxHidingJamb(Sketch& sketch)
{
	Random& random = sketch.random;
	DoorPlan door = drawDoor(sketch, {0.8, 1.3});
	const Subject subject{WallFrame{}, door.along()};
	if (!lookAt(sketch, subject, {{1.8, 4.8}, {0, 55}})) return;
	Piece box = drawPiece(random, "box");
	box.size_m.z() = random.uniform(0.3, 0.6);
	const double side = random.sign();
	const double jamb_m = side > 0 ? door.along().high : door.along().low;
	const double before_m = random.uniform(0.25, 0.7) + 0.5 * box.size_m.y();
	// On the line of sight to the jamb, but at most so far in the way.
	const double robot_x = sketch.view.camera.x(), robot_y = sketch.view.camera.y();
	const double sight_m = jamb_m + (robot_x - jamb_m) * before_m / -robot_y;
	const double outermost_m = jamb_m + side * (0.5 * box.size_m.x() - 0.12);
	const double along_m = side > 0 ? std::max(sight_m, outermost_m) : std::min(sight_m, outermost_m);
	putPiece(sketch, box, WallFrame{}.pose(along_m, -before_m, 0, random.uniform(-0.1, 0.1)));
	sketch.promise.visible_doors.push_back(door.id);
	sketch.promise.regions.push_back(regionOf({{}, around(jamb_m, 0.1)}, {0.05, 0.25}, {0.0, 0.6}));
	FrontPlan front;
	front.extent = around(along_m, box.size_m.x() + 0.3);
	front.side.doors.push_back(door);
	buildFront(sketch, std::move(front));
}

void twoDoors(Sketch& sketch)
{
	FrontPlan front;
	double from_m = 0;
	for (const char* id : {"door_1", "door_2"})
	{
		DoorPlan door = drawDoor(sketch);
		door.id = id;
		door.along_m = from_m + 0.5 * door.width_m;
		from_m += door.width_m + sketch.random.uniform(0.3, 1.5);
		front.side.doors.push_back(door);
		sketch.promise.visible_doors.emplace_back(id);
	}
	const Subject subject{{}, {front.side.doors.front().along().low, front.side.doors.back().along().high}};
	if (lookAt(sketch, subject, {{1.5, 4.6}, {0, 70}})) buildFront(sketch, std::move(front));
}

const std::array kDoorFamilies = {
    SceneFamily{"frontal_door", "one open door, seen from 0-15 degrees off its wall's normal", frontal},
    SceneFamily{"oblique_door", "one open door, seen from 45-75 degrees off its wall's normal", oblique},
    SceneFamily{"two_doors", "two open doors in one wall", twoDoors},
    SceneFamily{"far_door", "one open door 4.4-4.9 m away", farAway},
    SceneFamily{"corner_door", "an open door of which one jamb is the room's corner", inTheCorner},
    SceneFamily{"tilted_view", "an open door, the camera rolled up to 20 degrees or looking up as far", tilted},
    SceneFamily{"floor_unseen", "an open door, no floor in the image", floorUnseen},
    SceneFamily{"narrow_door", "an open door 0.70-0.85 m wide", narrow},
    SceneFamily{"box_hiding_jamb", "an open door, the foot of one jamb behind a low box", boxHidingJamb},
    SceneFamily{"jamb_out_of_view", "an open door of which one jamb is out of the image", jambOutOfView},
    SceneFamily{"passage_no_lintel", "a passage of 1.1-1.7 m up to the ceiling", withoutLintel},
    SceneFamily{"wide_passage", "a passage of 2.3-3.4 m", wide},
    SceneFamily{"threshold_low", "an open door with a threshold of 2-4 cm", lowThreshold},
    SceneFamily{"split_wall_door", "one open door between parts of a wall that are apart", splitWall},
};
}  // namespace

std::span<const SceneFamily> doorFamilies()
{
	return kDoorFamilies;
}
}  // namespace explore::simulation

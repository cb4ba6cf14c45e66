// Doorways with a leaf in them.
#include <explore/simulation/scenes/family_parts.h>
#include <explore/simulation/scenes/scene_rooms.h>

#include <array>

namespace explore::simulation
{
namespace
{
/** A leaf that opens to our side is seen from its free edge's side; else it would hide how far it is open. */
void ajar(Sketch& sketch, const Span& angle_deg)
{
	Random& random = sketch.random;
	DoorPlan door = drawDoor(sketch);
	door.verdict = Verdict::ajar;
	door.leaf = {LeafKind::hinged, sketch.drawAngle(angle_deg), random.chance(0.5), random.chance(0.3), 0};
	ViewRange range{{1.2, 4.8}, {0, 60}};
	if (door.leaf.toward_robot) range = {{1.6, 4.8}, {0, 40}, door.leaf.hinge_low ? 1.0 : -1.0};
	FrontPlan front;
	front.extent = door.freeAlong();
	drawDoorway(sketch, door, range, front);
}

void ajar30(Sketch& sketch)
{
	ajar(sketch, {20, 40});
}

void ajar60(Sketch& sketch)
{
	ajar(sketch, {50, 70});
}

void leafTowardUs(Sketch& sketch)
{
	DoorPlan door = drawDoor(sketch);
	door.leaf = {LeafKind::hinged, sketch.drawAngle({80, 105}), sketch.random.chance(0.5), true, 0};
	const Subject subject{{}, door.along()};
	if (!lookAt(sketch, subject, {{1.7, 4.8}, {0, 50}})) return;
	sketch.promise.visible_doors.push_back(door.id);
	sketch.promise.regions.push_back(regionOf(subject, {0.1, 1.9}));
	FrontPlan front;
	front.extent = door.along().grown(kFreeBesideAjar_m);
	front.side.doors.push_back(door);
	buildFront(sketch, std::move(front));
}

void recessed(Sketch& sketch)
{
	Random& random = sketch.random;
	sketch.style.wall_thickness_m = random.uniform(0.16, 0.25);
	DoorPlan door = drawDoor(sketch);
	door.verdict = Verdict::closed;
	door.beyond = Beyond::nothing;
	door.leaf = {LeafKind::recessed, 0, random.chance(0.5), false, random.uniform(0.05, 0.10)};
	drawDoorway(sketch, door, {{1.0, 4.9}, {0, 60}});
}

const std::array kLeafFamilies = {
    SceneFamily{"ajar_30", "a leaf opened by 20-40 degrees", ajar30},
    SceneFamily{"ajar_60", "a leaf opened by 50-70 degrees", ajar60},
    SceneFamily{"leaf_toward_us", "a leaf opened by 80-105 degrees to the robot's side", leafTowardUs},
    SceneFamily{"recessed_closed_door", "a closed leaf 5-10 cm behind the wall's face", recessed, Negative::yes, true},
};
}  // namespace

std::span<const SceneFamily> leafFamilies()
{
	return kLeafFamilies;
}
}  // namespace explore::simulation

// Doorways with something across them, and those behind which there is no floor.
#include <explore/core/geometry.h>
#include <explore/simulation/scenes/family_parts.h>
#include <explore/simulation/scenes/scene_furniture.h>
#include <explore/simulation/scenes/scene_rooms.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore::simulation
{
namespace
{
const ViewRange kBlockedViews{{1.0, 4.9}, {0, 60}};
const Eigen::Vector3f kCurtain(0.5F, 0.25F, 0.3F);

DoorPlan blockedDoor(Sketch& sketch)
{
	DoorPlan door = drawDoor(sketch);
	door.verdict = Verdict::blocked;
	// An opened leaf would stand where the thing does.
	if (door.leaf.angle_rad < 120 * kDegree_rad) door.leaf.kind = LeafKind::none;
	return door;
}

/** On neither side of the person is room for a robot. */
void personInDoorway(Sketch& sketch)
{
	constexpr double kWidestGap_m = 0.5;
	Random& random = sketch.random;
	DoorPlan door = blockedDoor(sketch);
	const Piece person = drawPiece(random, "pedestrian");
	// Most room is beside the legs, which stand less far out than the shoulders (see personMesh).
	const double off_rad = sketch.drawAngle({-30, 30});
	const double turn_rad = random.chance(0.5) ? off_rad + std::numbers::pi : off_rad;
	const double legs_m = 0.5 * person.size_m.x() * (0.5 * std::abs(std::cos(turn_rad)) + 0.36);
	const double beside_m = 0.5 * door.width_m - legs_m;
	const double off_m = std::clamp(kWidestGap_m - beside_m, 0.0, beside_m) * random.uniform(-1, 1);
	door.clear_width_m = beside_m + std::abs(off_m);
	if (!lookAt(sketch, {{}, door.along()}, {{1.2, 4.9}, {0, 50}})) return;
	const double behind_m = random.uniform(0.0, sketch.style.wall_thickness_m);
	putPiece(sketch, person, WallFrame{}.pose(off_m, behind_m, 0, turn_rad), door.id + "_person");
	sketch.promise.visible_doors.push_back(door.id);
	FrontPlan front;
	front.side.doors.push_back(door);
	buildFront(sketch, std::move(front));
}

void counter(Sketch& sketch)
{
	Random& random = sketch.random;
	DoorPlan door = blockedDoor(sketch);
	door.leaf.kind = LeafKind::none;
	const double top_m = random.uniform(0.85, 1.1), thickness_m = sketch.style.wall_thickness_m;
	const Span behind = around(0.5 * thickness_m, random.uniform(0.3, 0.6));
	door.clear_width_m = door.width_m;
	const bool panelled = random.chance(0.7);
	const Span body = panelled ? behind.grown(-0.05) : around(behind.middle(), 0.04);
	if (!lookAt(sketch, {{}, door.along()}, kBlockedViews)) return;
	sketch.block(door.id + "_counter", {}, door.along(), body, {0, top_m - 0.04}, sketch.paint());
	sketch.block(door.id + "_counter", {}, door.along(), behind, {top_m - 0.04, top_m}, sketch.paint());
	sketch.promise.visible_doors.push_back(door.id);
	FrontPlan front;
	front.side.doors.push_back(door);
	buildFront(sketch, std::move(front));
	sketch.world.doors.front().sill_m = top_m;
}

void highThreshold(Sketch& sketch)
{
	DoorPlan door = blockedDoor(sketch);
	door.leaf.kind = LeafKind::none;
	door.sill_m = sketch.random.uniform(0.15, 0.25);
	drawDoorway(sketch, door, kBlockedViews);
}

void curtain(Sketch& sketch)
{
	Random& random = sketch.random;
	DoorPlan door = blockedDoor(sketch);
	door.leaf.kind = LeafKind::none;
	const double bottom_m = random.uniform(0.01, 0.25), top_m = *door.top_m;
	const double fold_m = random.uniform(0.03, std::min(0.1, sketch.style.wall_thickness_m));
	const int folds = random.integer(5, 12);
	door.clear_width_m = 0.01;
	if (!lookAt(sketch, {{}, door.along()}, kBlockedViews)) return;
	sketch.place(door.id + "_curtain", curtainMesh(door.width_m - 0.005, top_m - bottom_m, fold_m, folds),
	             WallFrame{}.pose(0, 0.5 * sketch.style.wall_thickness_m, bottom_m),
	             sketch.material("curtain", kCurtain));
	sketch.promise.visible_doors.push_back(door.id);
	FrontPlan front;
	front.side.doors.push_back(door);
	buildFront(sketch, std::move(front));
}

void stairwell(Sketch& sketch)
{
	DoorPlan door = drawDoor(sketch);
	door.leaf.kind = LeafKind::none;
	door.verdict = Verdict::drop;
	door.beyond = Beyond::stairwell;
	drawDoorway(sketch, door, {{1.0, 3.0}, {0, 45}});
}

const std::array kBlockedFamilies = {
    SceneFamily{"person_in_doorway", "somebody stands in the doorway", personInDoorway, Negative::yes},
    SceneFamily{"counter", "a counter 0.85-1.1 m high across the doorway", counter, Negative::for_ground},
    SceneFamily{"threshold_high", "a threshold of 15-25 cm", highThreshold, Negative::for_ground},
    SceneFamily{"curtain", "a curtain across the doorway", curtain, Negative::yes},
    SceneFamily{"stairwell", "stairs or a shaft downward right behind the doorway", stairwell, Negative::yes, true},
};
}  // namespace

std::span<const SceneFamily> blockedFamilies()
{
	return kBlockedFamilies;
}
}  // namespace explore::simulation

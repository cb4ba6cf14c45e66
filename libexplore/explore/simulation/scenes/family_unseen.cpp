// Where the sensor does not tell what is behind: glass, mirrors, black surfaces, dark rooms.
#include <explore/simulation/scenes/family_parts.h>
#include <explore/simulation/scenes/scene_rooms.h>

#include <array>

namespace explore::simulation
{
namespace
{
const ViewRange kUnseenViews{{1.0, 4.7}, {0, 60}};
const Eigen::Vector3f kBlack(0.05F, 0.05F, 0.05F), kPane(0.7F, 0.8F, 0.85F), kSteel(0.5F, 0.52F, 0.55F);

/** Bars of that width around a sheet and sometimes one across it. */
void frameSheet(Sketch& sketch, const std::string& body, const Span& along, const Span& behind, const Span& z)
{
	const double bar_m = sketch.random.uniform(0.04, 0.09);
	const std::size_t steel = sketch.material("steel", kSteel);
	const auto bar = [&](const Span& bar_along, const Span& bar_z)
	{ sketch.block(body, {}, bar_along, behind, bar_z, steel); };
	bar({along.low, along.low + bar_m}, z);
	bar({along.high - bar_m, along.high}, z);
	bar(along, {z.low, z.low + bar_m});
	bar(along, {z.high - bar_m, z.high});
	if (sketch.random.chance(0.4)) bar(along, around(0.5 * (z.low + z.high), bar_m));
}

void glassDoor(Sketch& sketch)
{
	Random& random = sketch.random;
	DoorPlan door = drawDoor(sketch);
	door.verdict = Verdict::unknown;
	door.leaf.kind = LeafKind::none;
	door.clear_width_m = 0.01;
	const double behind_m = random.uniform(0.02, sketch.style.wall_thickness_m - 0.03);
	if (!lookAt(sketch, {{}, door.along()}, kUnseenViews)) return;
	const Span z{0.005, *door.top_m};
	sketch.block(door.id + "_pane", {}, door.along(), {behind_m, behind_m + 0.01}, z, sketch.material("glass", kPane));
	const Span frame = around(behind_m + 0.005, 0.04);
	if (random.chance(0.6)) frameSheet(sketch, door.id + "_frame", door.along(), frame, z);
	sketch.promise.visible_doors.push_back(door.id);
	FrontPlan front;
	front.side.doors.push_back(door);
	buildFront(sketch, std::move(front));
}

/** A sheet on a plain wall, of a doorway's size. */
void sheetOnWall(Sketch& sketch, const char* material, const Eigen::Vector3f& color, double framed)
{
	Random& random = sketch.random;
	DoorPlan door = drawDoor(sketch);
	door.verdict = Verdict::unknown;
	door.leaf.kind = LeafKind::none;
	door.beyond = Beyond::nothing;
	door.hole = false;
	const double bottom_m = random.chance(0.6) ? 0.0 : random.uniform(0.02, 0.15);
	const Span z{bottom_m, *door.top_m}, behind{-random.uniform(0.003, 0.015), 0};
	if (!lookAt(sketch, {{}, door.along()}, kUnseenViews)) return;
	sketch.block(door.id + "_sheet", {}, door.along(), behind, z, sketch.material(material, color));
	if (random.chance(framed)) frameSheet(sketch, door.id + "_frame", door.along(), behind.grown(0.01), z);
	sketch.promise.visible_doors.push_back(door.id);
	FrontPlan front;
	front.side.doors.push_back(door);
	buildFront(sketch, std::move(front));
}

void mirror(Sketch& sketch)
{
	sheetOnWall(sketch, "mirror", {0.75F, 0.8F, 0.85F}, 0.4);
}

void blackPatch(Sketch& sketch)
{
	sheetOnWall(sketch, "black_felt", kBlack, 0.0);
}

void darkRoom(Sketch& sketch)
{
	DoorPlan door = drawDoor(sketch);
	door.verdict = Verdict::unknown;
	door.beyond = Beyond::dark;
	door.leaf.kind = LeafKind::none;
	drawDoorway(sketch, door, kUnseenViews);
}

const std::array kUnseenFamilies = {
    SceneFamily{"glass_door", "a shut door of glass, with or without a frame", glassDoor, Negative::yes, true},
    SceneFamily{"mirror", "a mirror of a door's size on a plain wall", mirror, Negative::yes, true},
    SceneFamily{"black_patch", "a black patch of a door's size on a plain wall", blackPatch, Negative::yes, true},
    SceneFamily{"dark_deep_room", "an open door to a room from which nothing returns", darkRoom, Negative::yes},
};
}  // namespace

std::span<const SceneFamily> unseenFamilies()
{
	return kUnseenFamilies;
}
}  // namespace explore::simulation

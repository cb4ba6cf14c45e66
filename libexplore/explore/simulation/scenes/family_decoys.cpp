// What looks like a doorway to a careless eye, and is none.
#include <explore/simulation/scenes/family_parts.h>
#include <explore/simulation/scenes/scene_clutter.h>
#include <explore/simulation/scenes/scene_furniture.h>
#include <explore/simulation/scenes/scene_rooms.h>

#include <algorithm>
#include <array>

namespace explore::simulation
{
namespace
{
const ViewRange kDecoyViews{{1.2, 4.8}, {0, 60}};

/** A room around the viewpoint whose front has nothing but those holes, and the subject in view. */
void finish(Sketch& sketch, const Subject& subject, const Span& z, FrontPlan front = {})
{
	sketch.promise.regions.push_back(regionOf(subject, z));
	front.extent = {std::min(front.extent.low, subject.along.low - 0.4),
	                std::max(front.extent.high, subject.along.high + 0.4)};
	sketch.floor_use.take(rectangleOutline(subject.frame, subject.along.grown(0.05), {-0.6, 0.05}));
	buildFront(sketch, std::move(front));
}

/** With the front to the robot, the back `gap_m` before the wall. */
struct Standing
{
	double along_m, gap_m, turn_rad;
};
Subject standBeforeWall(Sketch& sketch, const Piece& piece, const Standing& where)
{
	const double depth_m = piece.size_m.y();
	Subject subject{{{0, -(where.gap_m + depth_m + 0.02)}, 0}, around(where.along_m, piece.size_m.x())};
	putPiece(sketch, piece, WallFrame{}.pose(where.along_m, -(where.gap_m + 0.5 * depth_m), 0, where.turn_rad));
	return subject;
}

void cabinetBeforeWall(Sketch& sketch)
{
	Random& random = sketch.random;
	static constexpr std::array<std::string_view, 3> kKinds = {"cabinet", "wardrobe", "shelf"};
	const auto draw = [&] { return drawPiece(random, kKinds[static_cast<std::size_t>(random.integer(0, 2))]); };
	const Piece piece = draw();
	const Subject subject = standBeforeWall(sketch, piece, {0, random.uniform(0.05, 0.8), random.uniform(-0.15, 0.15)});
	if (random.chance(0.4))
	{
		const Piece other = draw();
		const double beside_m = 0.5 * (piece.size_m.x() + other.size_m.x()) + random.uniform(0.15, 1.2);
		standBeforeWall(sketch, other, {random.sign() * beside_m, random.uniform(0.05, 0.8), 0});
	}
	if (lookAt(sketch, subject, kDecoyViews)) finish(sketch, subject, {0.1, piece.size_m.z()});
}

void personBeforeWall(Sketch& sketch)
{
	Random& random = sketch.random;
	const Piece person = drawPiece(random, "pedestrian");
	const Subject subject = standBeforeWall(
	    sketch, person, {0, random.uniform(0.2, 1.4), random.uniform(-std::numbers::pi, std::numbers::pi)});
	if (lookAt(sketch, subject, kDecoyViews)) finish(sketch, subject, {0.2, 1.5}, {});
}

void wardrobeGap(Sketch& sketch)
{
	Random& random = sketch.random;
	const double gap_m = random.uniform(0.7, 1.3), to_wall_m = random.uniform(0.025, 0.08);
	Piece piece = drawPiece(random, "wardrobe");
	for (const double side : {-1.0, 1.0})
	{
		if (random.chance(0.5)) piece = drawPiece(random, "wardrobe");
		standBeforeWall(sketch, piece, {side * 0.5 * (gap_m + piece.size_m.x()), to_wall_m, 0});
	}
	const Subject subject{{{0, -to_wall_m - piece.size_m.y()}, 0}, around(0, gap_m)};
	FrontPlan front;
	front.extent = around(0, gap_m + 3.0);
	if (lookAt(sketch, subject, {{1.4, 4.8}, {0, 60}})) finish(sketch, subject, {0.1, 1.6}, front);
}

void pillarRow(Sketch& sketch)
{
	Random& random = sketch.random;
	const int count = random.integer(3, 5);
	const double gap_m = random.uniform(0.7, 1.3), from_wall_m = random.uniform(0.4, 1.5);
	Piece pillar = drawPiece(random, "pillar");
	const bool round = random.chance(0.5);
	pillar.size_m.z() = sketch.style.wall_height_m;
	if (!round) pillar.kind = "box";
	const double step_m = gap_m + pillar.size_m.x(), first_m = -0.5 * step_m * (count - 1);
	for (int i = 0; i < count; ++i) standBeforeWall(sketch, pillar, {first_m + step_m * i, from_wall_m, 0});
	const int seen = random.integer(0, count - 2);
	const double middle_m = first_m + step_m * (seen + 0.5);
	const Subject subject{{{0, -from_wall_m - pillar.size_m.y() - 0.02}, 0}, around(middle_m, gap_m)};
	FrontPlan front;
	front.extent = around(0, step_m * count + 0.5);
	if (lookAt(sketch, subject, kDecoyViews)) finish(sketch, subject, {0.1, 1.6}, front);
}

void underTable(Sketch& sketch)
{
	Random& random = sketch.random;
	Piece table = drawPiece(random, "table");
	table.size_m.x() = random.uniform(0.85, 1.7);
	const double gap_m = random.chance(0.5) ? 0.03 : random.uniform(0.3, 1.2);
	const Subject subject = standBeforeWall(sketch, table, {0, gap_m, random.uniform(-0.1, 0.1)});
	if (lookAt(sketch, subject, kDecoyViews)) finish(sketch, subject, {0.1, table.size_m.z()});
}

/** A back and two sides around a niche that is deeper than the wall. */
void alcove(Sketch& sketch)
{
	Random& random = sketch.random;
	const DoorPlan size = drawDoor(sketch);
	const double depth_m = random.uniform(0.3, 0.6), thickness_m = sketch.style.wall_thickness_m;
	const Subject subject{{}, size.along()};
	if (!lookAt(sketch, subject, kDecoyViews)) return;
	const double top_m = random.chance(0.25) ? sketch.style.wall_height_m : *size.top_m;
	const std::size_t plaster = sketch.material("plaster");
	const Span behind{0.5 * thickness_m, depth_m}, along = subject.along;
	constexpr double kThick_m = 0.05;
	sketch.block("niche", {}, along.grown(kThick_m), {depth_m, depth_m + kThick_m}, {0, top_m + kThick_m}, plaster);
	for (const double side_m : {along.low - kThick_m, along.high})
		sketch.block("niche", {}, {side_m, side_m + kThick_m}, behind, {0, top_m + kThick_m}, plaster);
	sketch.block("niche", {}, along, behind, {top_m, top_m + kThick_m}, plaster);
	FrontPlan front;
	front.side.openings.push_back({along, {0, top_m}, random.chance(0.3)});
	finish(sketch, subject, {0.1, 1.8}, front);
}

/** What is seen through a window: another room, or a house across the street. */
void buildOutside(Sketch& sketch, const Span& along)
{
	Random& random = sketch.random;
	const double thickness_m = sketch.style.wall_thickness_m;
	if (random.chance(0.5))
	{
		const Space room{
		    {}, along.grown(random.uniform(0.2, 3.0)), {thickness_m, thickness_m + random.uniform(1.5, 6)}};
		enclose(sketch, room, {Side::left, Side::far, Side::right});
		furnish(sketch, room, random.integer(0, 4));
		return;
	}
	const double away_m = random.uniform(2.0, 12.0), beside_m = random.uniform(2, 8), top_m = random.uniform(3, 7);
	sketch.block("facade", {}, along.grown(beside_m), {away_m, away_m + 0.2}, {0, top_m}, sketch.material("facade"));
	for (int i = random.integer(0, 3); i > 0; --i)
	{
		const Piece plant = drawPiece(random, "plant");
		const double along_m = sketch.draw(along.grown(1.0)), behind_m = random.uniform(0.8, away_m - 0.5);
		putPiece(sketch, plant, WallFrame{}.pose(along_m, behind_m));
	}
}

void window(Sketch& sketch)
{
	Random& random = sketch.random;
	const Subject subject{{}, around(0, random.uniform(0.7, 1.6))};
	if (!lookAt(sketch, subject, kDecoyViews)) return;
	const Span z{random.uniform(0.6, 1.0), random.uniform(1.8, 2.2)};
	const double middle_m = 0.5 * sketch.style.wall_thickness_m;
	const Span behind = around(middle_m, 0.05);
	const std::size_t wood = sketch.material("window_frame", {0.8F, 0.8F, 0.78F});
	// A MAV could fly through one that is open and has no bars.
	const bool pane = random.chance(0.6), bars = sketch.flies() ? !pane : random.chance(0.5);
	if (pane)
		sketch.block("window_pane", {}, subject.along, around(middle_m, 0.01), z,
		             sketch.material("glass", {0.7F, 0.8F, 0.85F}));
	for (const double edge_m : {subject.along.low, subject.along.high - 0.05})
		sketch.block("window_frame", {}, {edge_m, edge_m + 0.05}, behind, z, wood);
	for (const double edge_m : {z.low, z.high - 0.05})
		sketch.block("window_frame", {}, subject.along, behind, {edge_m, edge_m + 0.05}, wood);
	if (bars) sketch.block("window_frame", {}, around(0, 0.06), behind, z, wood);
	if (bars) sketch.block("window_frame", {}, subject.along, behind, around(z.middle(), 0.06), wood);
	buildOutside(sketch, subject.along);
	FrontPlan front;
	front.side.openings.push_back({subject.along, z});
	finish(sketch, subject, z, front);
}

const std::array kDecoyFamilies = {
    SceneFamily{"window", "a window with a sill of 0.6-1.0 m", window, Negative::yes},
    SceneFamily{"alcove", "a niche 0.3-0.6 m deep", alcove, Negative::yes},
    SceneFamily{"cabinet_before_wall", "cabinets that shade a plain wall", cabinetBeforeWall, Negative::yes},
    SceneFamily{"person_before_wall", "somebody before a plain wall", personBeforeWall, Negative::yes},
    SceneFamily{"wardrobe_gap", "two wardrobes at a wall, a door's width apart", wardrobeGap, Negative::yes},
    SceneFamily{"pillar_row", "a row of pillars before a wall", pillarRow, Negative::yes},
    SceneFamily{"under_table", "the space under a table", underTable, Negative::yes},
};
}  // namespace

std::span<const SceneFamily> decoyFamilies()
{
	return kDecoyFamilies;
}
}  // namespace explore::simulation

// The paper's Fig. 6: six obstacles in a corridor, an office and a conference room.
#include <explore/simulation/scenes/family_parts.h>
#include <explore/simulation/scenes/scene_clutter.h>
#include <explore/simulation/scenes/scene_corridor.h>
#include <explore/simulation/scenes/scene_furniture.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore::simulation
{
namespace
{
/** Ahead of the robot, nearly in its way, nearer than the wall. */
void putInTheWay(Sketch& sketch, const Space& space, std::string_view kind)
{
	Random& random = sketch.random;
	const Piece piece = drawPiece(random, kind);
	const Eigen::Vector2d robot = sketch.robotPosition();
	const Eigen::Vector2d ahead(std::cos(sketch.view.yaw_rad), std::sin(sketch.view.yaw_rad));
	const double half_m = 0.5 * piece.size_m.head<2>().norm();
	const double away_m = random.uniform(0.9, 3.2) + half_m, beside_m = random.uniform(-0.35, 0.35);
	const Eigen::Vector2d place = robot + away_m * ahead + beside_m * Eigen::Vector2d(-ahead.y(), ahead.x());
	const Eigen::Vector2d inside = space.frame.coordinatesOf(place);
	const auto holds = [half_m](const Span& span, double at)
	{ return at > span.low + half_m && at < span.high - half_m; };
	sketch.possible = sketch.possible && holds(space.along, inside.x()) && holds(space.behind, inside.y());
	putPiece(sketch, piece, WallFrame{place, sketch.view.yaw_rad}.pose(0, 0, 0, random.uniform(-3.2, 3.2)));
	// From its foot to its top, across its middle, seen from the robot.
	const Subject subject{{place - (half_m + 0.05) * ahead, sketch.view.yaw_rad - 0.5 * std::numbers::pi},
	                      around(0, 0.6 * piece.size_m.x())};
	Region region = regionOf(subject, {0.1, piece.size_m.z()}, {0.25, 1.0});
	region.behind_m = 0;
	sketch.promise.regions.push_back(region);
}

RoomPlan drawRoom(Sketch& sketch, const Span& width_m, const Span& depth_m)
{
	RoomPlan room;
	room.space = {WallFrame{}, {0, sketch.draw(width_m)}, {0, sketch.draw(depth_m)}};
	const double from_wall_m = sketch.robot.radius_m + 0.25;
	const Eigen::Vector2d place{sketch.draw(room.space.along.grown(-from_wall_m)),
	                            sketch.random.uniform(from_wall_m, 1.5)};
	standAt(sketch, place, 0.5 * std::numbers::pi + sketch.drawAngle({-35, 35}));
	if (sketch.random.chance(0.5)) return room;
	DoorPlan door = drawDoor(sketch);
	door.along_m = sketch.draw(Span{0, room.space.along.length()}.grown(-0.5 * door.width_m - 0.2));
	room[Side::far].doors.push_back(door);
	return room;
}

/** A long table with chairs on both sides. */
void putConference(Sketch& sketch, const Space& space)
{
	Random& random = sketch.random;
	const Piece table = drawPiece(random, "conference_table");
	const double along_m = space.along.middle() + random.uniform(-1, 1);
	const double behind_m = space.behind.middle() + random.uniform(0, 1);
	const Eigen::Isometry3d building_from_table =
	    space.frame.pose(along_m, behind_m, 0, random.chance(0.5) ? 0.0 : 0.5 * std::numbers::pi);
	if (!tryPiece(sketch, table, building_from_table)) return;
	const Piece chair = drawPiece(random, random.chance(0.5) ? "four_legged_chair" : "swivel_chair");
	for (double x = -0.5 * table.size_m.x() + 0.4; x < 0.5 * table.size_m.x() - 0.2; x += 0.75)
		for (const double side : {-1.0, 1.0})
		{
			const double y = side * (0.5 * table.size_m.y() + 0.5 * chair.size_m.y() + random.uniform(0.02, 0.3));
			const double turn_rad = (side > 0 ? 0.0 : std::numbers::pi) + random.uniform(-0.3, 0.3);
			Eigen::Isometry3d table_from_chair(Eigen::Translation3d(x, y, 0));
			table_from_chair.rotate(Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()));
			if (random.chance(0.85)) tryPiece(sketch, chair, building_from_table * table_from_chair);
		}
}

void drawObstacle(Sketch& sketch, std::string_view kind)
{
	const int location = sketch.random.integer(0, 2);
	RoomPlan room;
	if (location == 0) room = drawCorridor(sketch, {{1.5, 3.0}, {4.0, 12.0}, {-10, 10}});
	if (location == 1) room = drawRoom(sketch, {4.2, 6.5}, {4.2, 6.5});
	if (location == 2) room = drawRoom(sketch, {7.0, 12.0}, {6.0, 10.0});
	putInTheWay(sketch, room.space, kind);
	if (location == 2) putConference(sketch, room.space);
	room.things = location == 0 ? 2 : 6;
	if (sketch.possible) buildRoom(sketch, std::move(room));
}

void pedestrian(Sketch& sketch)
{
	drawObstacle(sketch, "pedestrian");
}

void box(Sketch& sketch)
{
	drawObstacle(sketch, "box");
}

void swivelChair(Sketch& sketch)
{
	drawObstacle(sketch, "swivel_chair");
}

void fourLeggedChair(Sketch& sketch)
{
	drawObstacle(sketch, "four_legged_chair");
}

void armchair(Sketch& sketch)
{
	drawObstacle(sketch, "armchair");
}

void stool(Sketch& sketch)
{
	drawObstacle(sketch, "stool");
}

const std::array kObstacleFamilies = {
    SceneFamily{"obstacle_pedestrian", "somebody in the way, in a corridor, an office or a conference room",
                pedestrian},
    SceneFamily{"obstacle_box", "a box in the way", box},
    SceneFamily{"obstacle_swivel_chair", "an office swivel chair in the way", swivelChair},
    SceneFamily{"obstacle_four_legged_chair", "a four-legged chair in the way", fourLeggedChair},
    SceneFamily{"obstacle_armchair", "an armchair in the way", armchair},
    SceneFamily{"obstacle_stool", "a stool in the way", stool},
};
}  // namespace

std::span<const SceneFamily> obstacleFamilies()
{
	return kObstacleFamilies;
}
}  // namespace explore::simulation

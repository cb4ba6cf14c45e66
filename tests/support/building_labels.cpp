#include "support/building_labels.h"

#include "support/building_leaves.h"

#include <algorithm>
#include <numbers>

namespace explore::test
{
namespace
{
std::string verdictOf(const Opening& opening, double clear_m)
{
	constexpr double kOpen_rad = 80 * std::numbers::pi / 180;
	switch (opening.filling)
	{
		case Filling::curtain:
		case Filling::person:
		case Filling::boxes:
		case Filling::counter:
			return "blocked";
		case Filling::leaf:
		case Filling::two_leaves:
			if (opening.angle_rad == 0) return "closed";
			if (opening.angle_rad < kOpen_rad && !opening.drop) return "ajar";
			break;
		case Filling::sliding_face:
		case Filling::sliding_wall:
			if (opening.slid_m == 0) return "closed";
			if (clear_m < opening.width_m - 0.1) return "ajar";
			break;
		default:
			break;
	}
	if (opening.drop) return "drop";
	return opening.passage ? "passage" : "open";
}

/** What people or boxes leave, or a leaf. */
double labelledClear(const Opening& opening, double thickness_m)
{
	if (opening.filling == Filling::curtain) return 0;
	if (opening.filling == Filling::boxes) return opening.slid_m;
	if (opening.filling == Filling::person) return std::max(0.0, 0.5 * opening.width_m - 0.25);
	if (opening.filling == Filling::counter) return opening.width_m;
	if (opening.filling == Filling::leaf || opening.filling == Filling::two_leaves)
		if (opening.angle_rad == 0) return 0;
	if (opening.filling == Filling::sliding_face || opening.filling == Filling::sliding_wall)
		if (opening.slid_m == 0) return 0;
	return clearWidthOf(opening, thickness_m);
}
}  // namespace

void labelDoor(Sketch& sketch, const WallFrame& wall, const Opening& opening)
{
	PlannedDoor door;
	door.id = opening.id;
	door.place = wall.start.then({opening.middle_m, 0});
	door.width_m = opening.width_m;
	if (opening.high_m < wall.height_m - 0.01) door.height_m = opening.high_m;
	door.depth_m = wall.thickness_m;
	door.clear_width_m = labelledClear(opening, wall.thickness_m);
	door.verdict = verdictOf(opening, door.clear_width_m);
	door.sill_m = opening.low_m;
	sketch.doors.push_back(std::move(door));
}
}  // namespace explore::test

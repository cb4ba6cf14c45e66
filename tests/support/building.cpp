#include "support/building.h"

#include "support/building_furniture.h"

#include <algorithm>
#include <numbers>

namespace explore::test
{
Building makeBuilding(std::string_view kind, std::uint64_t seed)
{
	std::uint64_t mixed_seed = seed;
	for (const char letter : kind) mixed_seed = mixed_seed * 1099511628211ULL + static_cast<unsigned char>(letter);
	Dice dice(mixed_seed);
	Building building;
	building.plan = planOf(kind, dice);
	Plan& plan = building.plan;
	raiseWalls(plan, dice);
	addOpenings(plan, kind, dice);
	for (std::size_t room = 0; room < plan.rooms.size(); ++room)
	{
		const Use use = plan.rooms[room].use;
		if (use != Use::stairs_down && use != Use::stairs_up && use != Use::warehouse && dice.chance(0.5))
			addObliqueWall(plan, room, dice);
	}
	building.sketch.turn_rad = dice.chance(0.5) ? dice.between(0, 2 * std::numbers::pi) : 0;
	buildShell(building.sketch, plan, dice);
	for (Room& room : plan.rooms)
	{
		furnish(building.sketch, plan, room, dice);
		if (room.use != Use::stairs_down && room.use != Use::stairs_up)
			building.sketch.spawns.emplace_back(room.inside.center());
	}
	return building;
}
}  // namespace explore::test

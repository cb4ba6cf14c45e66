// The pieces that the unknown space which the robot wants to know falls into, and how large they are.
#pragma once

#include <explore/navigation/plan_map.h>

#include <cstdint>
#include <vector>

namespace explore
{
/** Wanted cells that are joined to each other are one pocket: what is known encloses it. */
struct Pockets
{
	std::vector<std::uint32_t> number;  ///< by cell; 0: not wanted
	/** By number: floor area [m²], of a MAV's the mean over its layers; infinite where the map ends before it does. */
	std::vector<double> area_m2;

	/** Area of all pockets that lie beside any of the cells. */
	[[nodiscard]] double besideThose(const PlanMap& map, const std::vector<CellIndex>& cells) const;
};
Pockets pocketsOf(const PlanMap& map);
}  // namespace explore

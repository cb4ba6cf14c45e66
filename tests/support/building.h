// Made-up buildings with labelled doors, drawn from a seed.
#pragma once

#include "support/building_plan.h"

#include <array>
#include <string_view>

namespace explore::test
{
inline constexpr std::array<std::string_view, 5> kBuildingKinds{"house", "office", "school", "warehouse", "hotel"};

struct Building
{
	Plan plan;
	Sketch sketch;
};

/** The same arguments give the same building. Throws std::invalid_argument for an unknown kind. */
Building makeBuilding(std::string_view kind, std::uint64_t seed);
}  // namespace explore::test

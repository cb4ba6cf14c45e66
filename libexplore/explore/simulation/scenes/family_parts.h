// The lists of scene families by kind; scene_families.h joins them.
#pragma once

#include <explore/simulation/scenes/scene_families.h>

namespace explore::simulation
{
std::span<const SceneFamily> paperFamilies();
std::span<const SceneFamily> doorFamilies();
std::span<const SceneFamily> leafFamilies();
std::span<const SceneFamily> blockedFamilies();
std::span<const SceneFamily> unseenFamilies();
std::span<const SceneFamily> decoyFamilies();
std::span<const SceneFamily> corridorFamilies();
std::span<const SceneFamily> obstacleFamilies();
}  // namespace explore::simulation

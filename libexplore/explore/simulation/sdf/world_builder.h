// Turns the tree of an SDF world into triangles, bodies and materials.
#pragma once

#include <explore/simulation/sdf/resources.h>
#include <explore/simulation/sdf/warnings.h>
#include <explore/simulation/sdf/xml.h>
#include <explore/simulation/world.h>

namespace explore::simulation
{
/** All that is visible in `tree` (the `<world>` of `file`, as readWorldTree gives it), its actors, and its labels. What
 * is broken or not supported is left out with a warning. Throws InputError for broken labels only. */
World buildWorld(XmlNode tree, const std::filesystem::path& file, Resources& resources, Warnings& warnings);
}  // namespace explore::simulation

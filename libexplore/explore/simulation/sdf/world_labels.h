// The labels of a world's author: doors, corridors, obstacles, spawns, routes and things that move.
#pragma once

#include <explore/simulation/sdf/xml.h>
#include <explore/simulation/world.h>

namespace explore::simulation
{
/** Whether `plugin` is our `<plugin name="explore_labels">`. */
bool holdsLabels(const XmlNode& plugin);

/** Adds the labels in `labels` (doc/worlds.md has their attributes) to `world`. Throws InputError "`file`:line:
 * <element> …" for a label or attribute that is not known, missing or out of bounds, or an id that is there already. */
void addLabels(World& world, const XmlNode& labels, const std::string& file);
}  // namespace explore::simulation

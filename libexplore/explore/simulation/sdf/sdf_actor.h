// Gazebo's actors: people who walk along a script.
#pragma once

#include <explore/simulation/sdf/warnings.h>
#include <explore/simulation/sdf/xml.h>
#include <explore/simulation/world.h>

namespace explore::simulation
{
/** The actor as a person of ordinary size on the floor z = 0 (an actor's own z is the height of its skin's root), along
 *  all its trajectories one after the other; it stands where it has none. Throws InputError for a broken time or pose.
 */
MovingBody actorBody(const XmlNode& actor, std::size_t material, Warnings& warnings);
}  // namespace explore::simulation

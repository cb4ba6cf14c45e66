// Which SDF elements mean something to us, and which may safely be ignored.
#pragma once

#include <explore/simulation/sdf/warnings.h>
#include <explore/simulation/sdf/xml.h>

namespace explore::simulation
{
/** Warns of every element in the `<world>` `tree` that would change what is seen in Gazebo but is not supported here,
 * and of those that SDF does not have. */
void warnAboutVocabulary(const XmlNode& tree, Warnings& warnings);
}  // namespace explore::simulation

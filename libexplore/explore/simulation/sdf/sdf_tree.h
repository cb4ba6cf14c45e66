// Reads an SDF world and puts every included model in its place.
#pragma once

#include <explore/simulation/sdf/resources.h>
#include <explore/simulation/sdf/warnings.h>
#include <explore/simulation/sdf/xml.h>

namespace explore::simulation
{
/** The attribute of a model or actor that says which file it came from; no XML file can contain it. */
inline constexpr std::string_view kFileAttribute = "<file>";

/** The `<world>` of the SDF file at `path`, all of its `<include>`s replaced by what they include. What cannot be
 * included is left out with a warning. Throws InputError for a file that cannot be read, is no XML, or holds no world.
 */
XmlNode readWorldTree(const std::filesystem::path& path, Resources& resources, Warnings& warnings);
}  // namespace explore::simulation

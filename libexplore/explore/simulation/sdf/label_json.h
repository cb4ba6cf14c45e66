// Reads the labels of foreign worlds, <world>.doors.json, into the same elements as our plugin in SDF.
#pragma once

#include <explore/simulation/sdf/xml.h>

namespace explore::simulation
{
/** Of {"doors": [{"id": "a", "at": [1, 2, 0], …}, …], "routes": [{"points": [[0, 0], [1, 0]]}]} the elements
 *  `<door id="a" at="1 2 0" …/>` and `<route points="0 0; 1 0"/>`, in the file's order; a null is left out. Throws
 * InputError
 *  "`name`:line: reason" for anything else. */
XmlNode parseLabelJson(std::string_view text, const std::string& name);
}  // namespace explore::simulation

// doors.geojson: what a run remembers of doors and corridors, for floor plans and GIS programs.
#pragma once

#include <explore/memory/frontier_memory.h>

#include <string>

namespace explore
{
/** A GeoJSON FeatureCollection (RFC 7946) with the confirmed doors and corridors as lines, x y in the map [m]: a door
 *  from jamb to jamb, a corridor along its axis as far as it was seen. RFC 7946 wants longitude and latitude, which a
 *  building's map has not: the collection's `frame` says so. Properties: doc/output-format.md. */
std::string doorsGeoJson(const FrontierMemory& memory);
}  // namespace explore

// map.ot and map.bt, which octovis opens, and map.pgm with map.yaml, which ROS's map_server serves.
#pragma once

#include <explore/memory/floor_map.h>
#include <octomap/OcTree.h>

#include <filesystem>

namespace explore
{
/** Writes map.ot, all log-odds, into `folder`, and map.bt, which has occupied, free and unknown alone. Throws
 * OutputError. */
void writeOctrees(const octomap::OcTree& map, const std::filesystem::path& folder);

/** Writes map.pgm (8 bit, row 0 at the largest y: black occupied, white free, 205 unknown) and map.yaml into `folder`.
 *  A map without cells becomes a single unknown one. Throws OutputError. */
void writeFloorMap(const FloorMap& floor, const std::filesystem::path& folder);
}  // namespace explore

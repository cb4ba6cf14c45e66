#include <explore/core/errors.h>
#include <explore/sinks/map_files.h>
#include <explore/sinks/output_file.h>
#include <mrpt/core/format.h>

#include <sstream>
#include <string>

namespace explore
{
namespace
{
/** The grey values that map_server's trinary mode takes back to just these states, with the thresholds below. */
char greyOf(VoxelState state)
{
	switch (state)
	{
		case VoxelState::free:
			return static_cast<char>(254);
		case VoxelState::occupied:
			return 0;
		case VoxelState::unknown:
			break;
	}
	return static_cast<char>(205);
}

std::string pgmOf(const FloorMap& floor)
{
	std::string text = mrpt::format("P5\n%d %d\n255\n", floor.columns, floor.rows);
	text.reserve(text.size() + floor.cells.size());
	for (int row = floor.rows - 1; row >= 0; --row)
		for (int column = 0; column < floor.columns; ++column)
			text.push_back(greyOf(floor.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(floor.columns) +
			                                  static_cast<std::size_t>(column)]));
	return text;
}

std::string yamlOf(const FloorMap& floor)
{
	return mrpt::format(
	    "image: map.pgm\n"
	    "mode: trinary\n"
	    "resolution: %.9g\n"
	    "origin: [%.9g, %.9g, 0.0]\n"
	    "negate: 0\n"
	    "occupied_thresh: 0.65\n"
	    "free_thresh: 0.196\n",
	    floor.resolution_m, floor.corner_in_map.x(), floor.corner_in_map.y());
}
/** As OcTree::writeBinaryConst() writes it, which also writes about it to the standard error stream. */
std::string binaryOf(const octomap::OcTree& map)
{
	std::ostringstream text;
	text << "# Octomap OcTree binary file\n";
	text << "id " << map.getTreeType() << "\nsize " << map.size() << "\nres " << map.getResolution() << "\ndata\n";
	if (map.getRoot() != nullptr) map.writeBinaryNode(text, map.getRoot());
	return text.str();
}
}  // namespace

void writeOctrees(const octomap::OcTree& map, const std::filesystem::path& folder)
{
	std::ostringstream exact;
	map.write(exact);
	writeFileAtomically(folder / "map.ot", exact.str());
	writeFileAtomically(folder / "map.bt", binaryOf(map));
}

void writeFloorMap(const FloorMap& floor, const std::filesystem::path& folder)
{
	FloorMap shown = floor;
	if (shown.cells.empty())
	{
		shown.columns = shown.rows = 1;
		shown.cells = {VoxelState::unknown};
	}
	writeFileAtomically(folder / "map.pgm", pgmOf(shown));
	writeFileAtomically(folder / "map.yaml", yamlOf(shown));
}
}  // namespace explore

// What may include what: the one-way street of doc/ARCHITECTURE.md as rules that a test can check.
#pragma once

#include "source_tree.h"

#include <string>
#include <vector>

namespace explore::test
{
/** One folder of the project and what its files may use. */
struct Layer
{
	std::string name;                      ///< as in messages and in explore::name
	std::string folder;                    ///< below the root, with a slash at its end
	std::vector<std::string> sees;         ///< names of the other layers it may include or link
	std::vector<std::string> third_party;  ///< first path component of foreign includes: "mrpt", "zlib.h"
	bool pure = false;                     ///< touches no clock, file, device or thread
};

/** The layers of this project. */
std::vector<Layer> projectLayers();

// Each function returns one sentence per violation, beginning with "file:line: " or "file: ".

/** Includes of a layer that is not seen, of a foreign package, or of a header that touches the world in a pure layer;
 *  includes that no rule can judge; files that belong to no layer. */
std::vector<std::string> includeViolations(const SourceTree& tree, const std::vector<Layer>& layers);

/** Targets in a layer.cmake that its layer does not see. */
std::vector<std::string> linkViolations(const SourceTree& tree, const std::vector<Layer>& layers);

/** Reads of the clock in pure layers. */
std::vector<std::string> clockViolations(const SourceTree& tree, const std::vector<Layer>& layers);

/** Every include cycle once, as "a.h -> b.h -> a.h". */
std::vector<std::string> includeCycles(const SourceTree& tree);

/** Headers that do not open with a sentence saying what they are for or lack #pragma once; files above `max_lines`. */
std::vector<std::string> shapeViolations(const SourceTree& tree, int max_lines);
}  // namespace explore::test

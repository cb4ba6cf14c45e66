// What somebody most likely meant who wrote a section or key that does not exist.
#pragma once

#include <explore/config/field_list.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace explore
{
/** Letters to insert, remove, replace or swap with their neighbour to get from `a` to `b`; letter case is ignored. */
std::size_t editDistance(std::string_view a, std::string_view b);

/** "did you mean [robot]?" where a name is near, and the sections that there are. */
std::string suggestSection(const std::vector<Section>& sections, std::string_view wanted);

/** "did you mean radius?", with its section where that is not `section`; the keys of `section` where none is near. */
std::string suggestKey(const std::vector<Section>& sections, std::string_view section, std::string_view wanted);
}  // namespace explore

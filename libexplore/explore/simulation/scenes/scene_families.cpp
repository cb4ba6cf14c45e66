#include "scene_families.h"

#include <explore/simulation/scenes/family_parts.h>

#include <algorithm>
#include <vector>

namespace explore::simulation
{
std::span<const SceneFamily> sceneFamilies()
{
	static const std::vector<SceneFamily> all = []
	{
		std::vector<SceneFamily> families;
		for (const auto& part : {paperFamilies(), doorFamilies(), leafFamilies(), blockedFamilies(), unseenFamilies(),
		                         decoyFamilies(), corridorFamilies(), obstacleFamilies()})
			families.insert(families.end(), part.begin(), part.end());
		return families;
	}();
	return all;
}

const SceneFamily* sceneFamilyNamed(std::string_view name)
{
	const auto families = sceneFamilies();
	const auto family =
	    std::find_if(families.begin(), families.end(), [name](const SceneFamily& each) { return each.name == name; });
	return family == families.end() ? nullptr : &*family;
}
}  // namespace explore::simulation

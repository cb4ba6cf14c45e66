#include <explore/core/truth.h>

#include <algorithm>
#include <array>

namespace explore
{
std::string_view nameOf(Visibility visibility)
{
	static constexpr std::array<std::string_view, 3> kNames{"visible", "ignored", "hidden"};
	return kNames.at(static_cast<std::size_t>(visibility));
}

std::string_view nameOf(CorridorState state)
{
	static constexpr std::array<std::string_view, 3> kNames{"none", "not_scored", "corridor"};
	return kNames.at(static_cast<std::size_t>(state));
}

std::size_t TruthReach::cells() const
{
	std::size_t count = 0;
	for (const Level& level : levels)
		count += static_cast<std::size_t>(std::count(level.reachable.begin(), level.reachable.end(), 1));
	return count;
}

double TruthReach::floorArea() const
{
	std::size_t count = 0;
	for (std::size_t i = 0; i < static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); ++i)
		if (std::any_of(levels.begin(), levels.end(), [i](const Level& level) { return level.reachable[i] != 0; }))
			++count;
	return static_cast<double>(count) * cell_m * cell_m;
}
}  // namespace explore

#include <explore/core/truth.h>

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
}  // namespace explore

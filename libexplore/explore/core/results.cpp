#include <explore/core/results.h>

namespace explore
{
std::string_view nameOf(Verdict verdict)
{
	static constexpr std::array<std::string_view, 8> kNames{"open",    "ajar", "closed",  "blocked",
	                                                        "passage", "drop", "partial", "unknown"};
	return kNames[static_cast<std::size_t>(verdict)];
}

std::string_view nameOf(GoalKind kind)
{
	static constexpr std::array<std::string_view, 7> kNames{"door",    "corridor", "frontier", "look",
	                                                        "recover", "home",     "none"};
	return kNames[static_cast<std::size_t>(kind)];
}

std::string_view nameOf(StopReason reason)
{
	static constexpr std::array<std::string_view, 10> kNames{
	    "none",     "empty_frame", "stale_frame", "near_obstacle_lost", "path_too_short", "no_direction",
	    "finished", "bumper",      "cliff",       "link_lost"};
	return kNames[static_cast<std::size_t>(reason)];
}
}  // namespace explore

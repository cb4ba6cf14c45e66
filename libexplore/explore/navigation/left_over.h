// What stayed unknown at the end of an exploration, and why.
#pragma once

#include <explore/memory/frontier_memory.h>
#include <explore/navigation/look_targets.h>

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

namespace explore
{
enum class LeftOverReason
{
	sealed,        ///< nothing more can come of it: looked at in vain, or enclosed by what is known and passed by
	too_narrow,    ///< the robot does not fit
	out_of_reach,  ///< seen across something, without a way there
	closed_door,   ///< a door stands there that is closed or blocked
	behind_glass,  ///< an opening from which nothing came back
	drop,          ///< no floor
	kept_out,      ///< in a keep-out polygon
	outside_bounds,
};
[[nodiscard]] std::string_view nameOf(LeftOverReason reason);

struct LeftOver
{
	Eigen::Vector3d center_in_map = Eigen::Vector3d::Zero();
	double area_m2 = 0;  ///< of the unknown cells beside the frontier
	LeftOverReason why = LeftOverReason::sealed;
	bool passed_by = false;  ///< a pocket that is not worth the way: nobody looked
};

struct LeftOverInput
{
	const PlanMap& map;
	const FrontierMemory& memory;
	const TravelField& field;  ///< from the robot
	const AllowedArea& area;
	/** Of what is still wanted: it was looked at, as often as it is worth. No value: it is not in the account. */
	std::optional<LeftOverReason> wanted = LeftOverReason::sealed;
	std::vector<Eigen::Vector3d>
	    passed_by_in_map;  ///< middles of frontiers that would be worth a look, but not the way
};

/** The account: every frontier with its reason; neighbours with the same reason are one. */
std::vector<LeftOver> leftOver(const LeftOverInput& input);
}  // namespace explore

// The families of random labelled scenes: what a door detector is tried on.
#pragma once

#include <explore/core/robot.h>

#include <span>
#include <string_view>

namespace explore::simulation
{
class Sketch;

/** For which robots a family has no opening that can be passed. */
enum class Negative
{
	no,
	for_ground,  ///< a MAV may pass above
	yes,
};

struct SceneFamily
{
	std::string_view name, description;
	void (*draw)(Sketch&);
	Negative negative = Negative::no;
	bool hazard = false;                  ///< a false "open" would harm the robot: more scenes are counted
	std::string_view configuration = {};  ///< its row of the paper's Fig. 3(b); empty = none

	[[nodiscard]] bool negativeFor(RobotKind kind) const
	{
		return negative == Negative::yes || (negative == Negative::for_ground && kind == RobotKind::ground);
	}
	/** Independent scenes that a claim needs (doc/definitions.md). */
	[[nodiscard]] int scenesForAClaim() const { return hazard ? 1000 : 500; }
};

/** All of them, in the order of the list that people see. */
std::span<const SceneFamily> sceneFamilies();
/** Null where there is none of that name. */
const SceneFamily* sceneFamilyNamed(std::string_view name);
}  // namespace explore::simulation

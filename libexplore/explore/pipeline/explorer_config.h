// Everything step() needs to know: one config struct a stage.
#pragma once

#include <explore/navigation/avoider.h>
#include <explore/navigation/goal_choice.h>
#include <explore/navigation/heading.h>
#include <explore/navigation/near_field_guard.h>
#include <explore/perception/perception_config.h>

namespace explore
{
struct ExplorerConfig
{
	RobotConfig robot;
	PerceptionConfig perception;
	GoalConfig goal;
	AvoiderConfig avoider;
	HeadingConfig heading;
	NearFieldGuardConfig near_field_guard;
};
/** [robot] [perception] [goal] [avoider] [heading] */
void describe(FieldVisitor& fields, ExplorerConfig& config);
}  // namespace explore

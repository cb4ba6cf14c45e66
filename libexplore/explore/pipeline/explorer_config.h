// Everything step() needs to know: one config struct a stage.
#pragma once

#include <explore/memory/frontier_memory.h>
#include <explore/navigation/avoider.h>
#include <explore/navigation/heading.h>
#include <explore/navigation/mission_config.h>
#include <explore/navigation/near_field_guard.h>
#include <explore/perception/perception_config.h>

namespace explore
{
struct ExplorerConfig
{
	RobotConfig robot;
	PerceptionConfig perception;
	MemoryConfig memory;
	MissionConfig mission;
	AvoiderConfig avoider;
	HeadingConfig heading;
	NearFieldGuardConfig near_field_guard;
};
/** [robot] [perception] [memory] [goal] [avoider] [heading] and the sections of theirs */
void describe(FieldVisitor& fields, ExplorerConfig& config);
}  // namespace explore

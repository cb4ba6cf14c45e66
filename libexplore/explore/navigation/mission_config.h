// What the mission goes by: policy, plan, bounds and budgets.
#pragma once

#include <explore/navigation/plan_config.h>

namespace explore
{
enum class GoalPolicy
{
	paper,
	nearest_frontier,
	explore,
};

struct BudgetConfig
{
	double time_s = 0;     ///< the robot is to be home by then; 0 = no end
	double path_m = 0;     ///< it is not to drive further than this, way home included (battery); 0 = no end
	double reserve = 0.3;  ///< share of the way home kept in reserve
};
/** [budget] */
void describe(FieldVisitor& fields, BudgetConfig& config);

struct MissionConfig
{
	GoalPolicy policy = GoalPolicy::explore;
	PlanConfig plan;
	BoundsConfig bounds;
	BudgetConfig budget;
};
/** [goal] [plan] [bounds] [budget] */
void describe(FieldVisitor& fields, MissionConfig& config);
}  // namespace explore

#include <explore/navigation/mission_config.h>

#include <array>

namespace explore
{
void describe(FieldVisitor& fields, BudgetConfig& config)
{
	fields.section("budget", "How long the robot may be away");
	fields.real("time", config.time_s, {0.0, 1e6}, "s", "it is to be home by then; 0 = no end");
	fields.real("path", config.path_m, {0.0, 1e6}, "m",
	            "it is not to drive further than this, way home included (battery); 0 = no end");
	fields.real("reserve", config.reserve, {0.0, 10.0}, "", "share of the way home kept in reserve");
}

void describe(FieldVisitor& fields, MissionConfig& config)
{
	static constexpr std::array<std::string_view, 3> kPolicies{"paper", "nearest_frontier", "explore"};
	fields.section("goal", "Where the robot wants to go");
	fields.choice("policy", config.policy, kPolicies,
	              "paper: nearest door, else vanishing point, else straight on; nearest_frontier: the nearest edge of "
	              "the known by path; explore: a tour of looks at what is unknown, then home");
	describe(fields, config.plan);
	describe(fields, config.bounds);
	describe(fields, config.budget);
}
}  // namespace explore

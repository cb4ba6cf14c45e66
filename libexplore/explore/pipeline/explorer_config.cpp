#include <explore/pipeline/explorer_config.h>

namespace explore
{
void describe(FieldVisitor& fields, ExplorerConfig& config)
{
	describe(fields, config.robot);
	describe(fields, config.perception);
	describe(fields, config.memory);
	describe(fields, config.mission);
	describe(fields, config.avoider);
	describe(fields, config.heading);
	describe(fields, config.near_field_guard);
}
}  // namespace explore

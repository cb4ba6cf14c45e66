#include <explore/perception/perception_config.h>
#include <explore/perception/remedies.h>

namespace explore
{
PerceptionConfig without(Remedy remedy, PerceptionConfig config)
{
	switch (remedy)
	{
		case Remedy::none:
			break;
		case Remedy::ray_evidence:
			config.openings.rays.tell_apart = false;
			break;
		case Remedy::height_profile:
			config.openings.verdict.height_profile = false;
			break;
		case Remedy::depth_behind:
			config.openings.measure.depth_behind = false;
			break;
		case Remedy::corner_jambs:
			config.openings.jambs.corners = false;
			break;
		case Remedy::leaf:
			config.openings.verdict.leaf = false;
			break;
		case Remedy::jamb_fit:
			config.openings.jambs.full_resolution = false;
			break;
		case Remedy::range_tolerance:
			config.upright_walls.range_tolerance = false;
			break;
		case Remedy::gravity_prior:
			config.level.gravity_prior = false;
			break;
		case Remedy::direction_vote:
			config.corridor.vote = false;
			break;
		case Remedy::robot_size:
			config.openings.verdict.robot_size = false;
			break;
		case Remedy::floor_beyond:
			config.openings.verdict.floor_beyond = false;
			break;
	}
	return config;
}
}  // namespace explore

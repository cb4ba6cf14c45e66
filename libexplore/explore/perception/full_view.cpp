#include <explore/perception/full_view.h>

namespace explore
{
FullView fullView(const DepthFrame& frame, const PerceptionConfig& config, const RobotConfig& robot,
                  const GroundMemory& memory)
{
	FullView view;
	view.level = levelView(frame, robot, memory, config.level, config.sensor_noise);
	view.walls =
	    findUprightWalls(view.level, config.upright_walls, config.sensor_noise, static_cast<unsigned>(config.seed));
	view.corridors =
	    corridorPairs(view.level, view.walls, config.corridor.pairs, {config.upright_walls, config.sensor_noise});
	return view;
}
}  // namespace explore

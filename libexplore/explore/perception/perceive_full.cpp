#include <explore/perception/full_view.h>
#include <explore/perception/perceive_full.h>

#include <algorithm>

namespace explore
{
namespace
{
Eigen::Vector3d onFloor(const Eigen::Vector2d& point)
{
	return {point.x(), point.y(), 0.0};
}

/** The floor in the robot frame; no value where none was ever seen. */
std::optional<Ground> groundOf(const LevelPose& pose)
{
	if (pose.floor == FloorOrigin::guessed || pose.floor == FloorOrigin::mount) return std::nullopt;
	const Eigen::Vector3d up = pose.robot_from_level.linear().col(2);
	return Ground{planeThrough(pose.robot_from_level.translation(), up), pose.cameraHeight_m(), pose.floor_samples,
	              pose.floor == FloorOrigin::seen};
}

Wall wallOf(const UprightWall& wall, const LevelPose& pose)
{
	const Eigen::Matrix3d& robot_from_level = pose.robot_from_level.linear();
	const Eigen::Vector3d foot = pose.robot_from_level * onFloor(wall.at(0.0));
	return {planeThrough(foot, robot_from_level * onFloor(wall.normal)),
	        wall.samples,
	        {foot, robot_from_level * onFloor(wall.tangent())}};
}

/** An end of a corridor as an opening; those that a wall's opening explains are left out. */
void addCorridorEnds(std::vector<Opening>& openings, const CorridorPairs& pairs, const RobotConfig& robot,
                     const PerceptionConfig& config)
{
	for (const CorridorEnd& end : findCorridorEnds(pairs, config.corridor_ends))
		if (std::ranges::none_of(openings, [&](const Opening& opening)
		                         { return (opening.center - end.center).norm() < 0.5 * end.width_m; }))
			openings.push_back(openingOf(end, robot, config.openings.verdict));
}
}  // namespace

std::vector<Opening> allOpenings(const FullView& view, const RobotConfig& robot, const PerceptionConfig& config)
{
	auto openings = findOpenings(view.level, view.walls, robot, config.openings, config.sensor_noise);
	addCorridorEnds(openings, view.corridors, robot, config);
	return openings;
}

Percepts perceiveFull(const DepthFrame& frame, const PerceptionConfig& given, const RobotConfig& robot,
                      PerceptionMemory& memory)
{
	const PerceptionConfig config = without(given.leave_out, given);
	const FullView view = fullView(frame, config, robot, memory.ground);
	const LevelPose& pose = view.level.pose;
	memory.ground = remember(memory.ground, frame, pose);

	Percepts percepts;
	percepts.ground = groundOf(pose);
	for (const UprightWall& wall : view.walls) percepts.walls.push_back(wallOf(wall, pose));
	if (const auto corridor = findCorridor(view.corridors, config.corridor))
		percepts.vanishing_points.push_back(vanishingPointOf(*corridor, pose));

	for (const Opening& opening : allOpenings(view, robot, config)) percepts.doors.push_back(doorOf(opening, pose));

	const auto floor = percepts.ground ? std::optional(percepts.ground->plane) : std::nullopt;
	percepts.obstacles_in_robot = nearObstacles(frame, floor, robot, config.obstacles, config.sensor_noise);
	percepts.near_field = nearField(frame, floor);
	return percepts;
}
}  // namespace explore

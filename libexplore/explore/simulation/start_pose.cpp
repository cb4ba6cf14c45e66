#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/simulation/plan_triangle.h>
#include <explore/simulation/start_pose.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <optional>
#include <sstream>

namespace explore::simulation
{
namespace
{
struct StartPlace
{
	Eigen::Vector3d position_in_map = Eigen::Vector3d::Zero();
	double yaw_rad = 0;
};

StartPlace placeOf(const Spawn& spawn)
{
	return {spawn.position_in_map, spawn.yaw_rad};
}

/** On the floor there: what is highest up to knee height. */
StartPlace onFloor(const World& world, double x, double y)
{
	constexpr double kKnee_m = 0.25;
	return {{x, y, surfaceBelow(world, {x, y, kKnee_m}).value_or(0.0)}, 0.0};
}

/** "x y yaw" or "x y z yaw"; no value for anything else. */
std::optional<StartPlace> placeIn(const World& world, const std::string& text)
{
	std::istringstream words(text);
	std::vector<double> numbers;
	for (std::string word; words >> word;)
	{
		const auto number = parseNumber(word);
		if (!number) return std::nullopt;
		numbers.push_back(*number);
	}
	if (numbers.size() != 3 && numbers.size() != 4) return std::nullopt;
	StartPlace place = onFloor(world, numbers[0], numbers[1]);
	if (numbers.size() == 4) place.position_in_map.z() = numbers[2];
	place.yaw_rad = mrpt::DEG2RAD(numbers.back());
	return place;
}

StartPlace firstThatSuits(const World& world, const RobotConfig& robot)
{
	if (world.spawns.empty()) return onFloor(world, 0.0, 0.0);
	const auto suits = [&robot](const Spawn& spawn)
	{ return (robot.kind == RobotKind::mav) == (spawn.position_in_map.z() >= robot.min_altitude_m); };
	const auto found = std::find_if(world.spawns.begin(), world.spawns.end(), suits);
	return placeOf(found != world.spawns.end() ? *found : world.spawns.front());
}

StartPlace named(const World& world, const std::string& start)
{
	std::string spawns;
	for (const Spawn& spawn : world.spawns)
	{
		if (spawn.name == start) return placeOf(spawn);
		spawns.append(spawns.empty() ? "" : ", ").append(spawn.name);
	}
	throw ConfigError("start = \"" + start + "\": neither 'x y yaw' (m, degrees) nor a spawn of the world, which has " +
	                  (spawns.empty() ? "none" : spawns));
}
}  // namespace

mrpt::poses::CPose3D startPose(const World& world, const std::string& start, const RobotConfig& robot)
{
	StartPlace place;
	if (start.empty())
		place = firstThatSuits(world, robot);
	else if (const auto given = placeIn(world, start))
		place = *given;
	else
		place = named(world, start);
	Eigen::Vector3d& position = place.position_in_map;
	if (robot.kind == RobotKind::mav && position.z() < robot.min_altitude_m)
		position.z() += 0.5 * (robot.min_altitude_m + robot.max_altitude_m);
	return {position.x(), position.y(), position.z(), place.yaw_rad, 0.0, 0.0};
}
}  // namespace explore::simulation

// What tests of random scenes share: requests, and where a robot's body can be moved to.
#pragma once

#include <explore/simulation/depth_camera.h>
#include <explore/simulation/scenes/scene.h>

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <string>
#include <utility>

namespace explore::test
{
inline RobotConfig robotOfKind(RobotKind kind)
{
	RobotConfig robot;
	robot.kind = kind;
	if (kind == RobotKind::mav) robot.radius_m = 0.30, robot.height_m = 0.25;
	return robot;
}

inline simulation::Scene sceneOf(std::string_view family, int index, RobotKind kind = RobotKind::ground, int looks = 1,
                                 std::uint64_t seed = 5)
{
	const auto* found = simulation::sceneFamilyNamed(family);
	if (found == nullptr) throw std::out_of_range(std::string(family));
	return simulation::makeScene(*found,
	                             {seed, index, robotOfKind(kind), looks, simulation::depthCamera("xtion").intrinsics});
}

inline const TruthFrame& firstLook(const simulation::Scene& scene)
{
	return scene.looks.front().truth;
}

/** An upright cylinder that stands on the floor. */
struct Pusher
{
	double radius_m, low_m, high_m;
};

/** Whether the body can be moved on a grid of `step_m` from `start` to a place that `there` accepts, within `inside`,
 *  and nowhere touches anything. */
inline bool reaches(const simulation::RayScene& scene, const Pusher& body, const Eigen::Vector2d& start, double step_m,
                    const std::function<bool(const Eigen::Vector2d&)>& inside,
                    const std::function<bool(const Eigen::Vector2d&)>& there)
{
	using Cell = std::pair<int, int>;
	const auto placeOf = [&](const Cell& cell) -> Eigen::Vector2d
	{ return start + step_m * Eigen::Vector2d(cell.first, cell.second); };
	std::map<Cell, bool> met{{{0, 0}, true}};
	std::queue<Cell> open;
	for (open.push({0, 0}); !open.empty(); open.pop())
	{
		const auto [x, y] = open.front();
		for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
		{
			const Cell cell{x + dx, y + dy};
			if (!met.emplace(cell, true).second) continue;
			const Eigen::Vector2d place = placeOf(cell);
			if (!inside(place)) continue;
			if (scene.touchesCylinder({place.x(), place.y(), body.low_m}, body.radius_m, body.high_m - body.low_m))
				continue;
			if (there(place)) return true;
			open.push(cell);
		}
	}
	return false;
}
}  // namespace explore::test

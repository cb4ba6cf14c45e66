// What the tests of the map share: rooms, views into them, and maps as bytes.
#pragma once

#include <explore/memory/occupancy.h>

#include <random>
#include <sstream>
#include <string>

#include "support/analytic_scene.h"
#include "support/random_points.h"

namespace explore::test
{
/** A room of 8 m × 6 m with a door, boxes and a post of 3 cm; always the same for one seed. */
inline Scene randomRoom(std::mt19937& random)
{
	Scene scene;
	scene.floor(-4, -3, 10, 3).wall({-4, -3}, {4, -3}, 2.5).wall({-4, 3}, {4, 3}, 2.5).wall({-4, -3}, {-4, 3}, 2.5);
	scene.wall({4, -3}, {4, 3}, 2.5, {{uniform(random, 0.5, 4.5), 0.9, 2.0}});
	for (int i = 0; i < 5; ++i)
		scene.box({uniform(random, -3, 3), uniform(random, -2.5, 2.5), uniform(random, 0.2, 1.5)},
		          {uniform(random, 0.1, 1), uniform(random, 0.1, 1), uniform(random, 0.1, 1)});
	scene.box({uniform(random, 1, 3), uniform(random, -1, 1), 0.5}, {0.03, 0.03, 1.0});
	return scene;
}

/** Anywhere in the room, tilted by up to 20°. */
inline mrpt::poses::CPose3D randomView(std::mt19937& random)
{
	return {uniform(random, -3, 3),     uniform(random, -2, 2),       uniform(random, 0.3, 1.8),
	        uniform(random, -3.1, 3.1), uniform(random, -0.35, 0.35), uniform(random, -0.35, 0.35)};
}

inline DepthFrame viewOf(const Scene& scene, const mrpt::poses::CPose3D& map_from_camera, const CameraNoise& noise = {},
                         int width_px = 160)
{
	return renderFrame(scene, map_from_camera, {}, xtionIntrinsics(width_px, width_px * 3 / 4), noise);
}

/** All of a map, as .ot files hold it. */
inline std::string bytesOf(Occupancy& map)
{
	std::ostringstream bytes;
	map.tree().write(bytes);
	return bytes.str();
}
}  // namespace explore::test

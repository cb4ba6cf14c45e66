// Truths made by hand, for tests.
#pragma once

#include <explore/core/truth.h>

namespace explore::test
{
/** A visible open door in the map frame, facing −x, floor at z = 0, 2 m high. */
inline TruthDoor openDoor(const std::string& id, double x_m, double y_m, double width_m)
{
	TruthDoor door;
	door.id = id;
	door.center_in_map = {x_m, y_m, 1.0};
	door.normal_in_map = -Eigen::Vector3d::UnitX();
	door.width_m = door.clear_width_m = width_m;
	door.height_m = 2.0;
	door.visibility = Visibility::visible;
	door.visible_share = door.jamb_share[0] = door.jamb_share[1] = 1.0;
	door.lintel_in_view = true;
	return door;
}

/** Free paths of one length in all directions, at the given elevations. */
inline TruthFreePaths evenPaths(float free_m, std::vector<double> elevations_rad = {0.0})
{
	TruthFreePaths paths;
	paths.free_m.assign(elevations_rad.size() * TruthFreePaths::kAzimuths, free_m);
	paths.elevations_rad = std::move(elevations_rad);
	return paths;
}
}  // namespace explore::test

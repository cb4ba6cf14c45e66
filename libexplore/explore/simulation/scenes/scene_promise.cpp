#include "scene_promise.h"

#include <explore/core/geometry.h>
#include <explore/simulation/door_visibility.h>
#include <explore/simulation/truth_view.h>

#include <algorithm>
#include <set>

namespace explore::simulation
{
namespace
{
/** The share of the region's points that the camera sees. */
double shareInView(const Region& region, const TruthView& view, const Eigen::Isometry3d& map_from_building)
{
	constexpr int kPoints = 8;
	int seen = 0;
	for (int row = 0; row < kPoints; ++row)
		for (int column = 0; column < kPoints; ++column)
		{
			const double along_m = region.along.low + region.along.length() * (column + 0.5) / kPoints;
			const double z_m = region.z.low + region.z.length() * (row + 0.5) / kPoints;
			const Eigen::Vector2d place = region.frame.at(along_m, region.behind_m);
			const Eigen::Vector3d point(place.x(), place.y(), z_m);
			seen += view.sightOf(map_from_building * point) == PointSight::clear ? 1 : 0;
		}
	return static_cast<double>(seen) / (kPoints * kPoints);
}

bool exactlyOneJamb(const TruthDoor& door)
{
	constexpr double kSeen = 0.2;
	const auto [least, most] = std::minmax(door.jamb_share[0], door.jamb_share[1]);
	return least == 0 && most >= kSeen && door.visibility == Visibility::ignored;
}

/** "left_2" → "left". */
std::string wallOf(const std::string& id)
{
	return id.substr(0, id.find('_'));
}

bool doorsAreKept(const Promise& promise, const PromisedLook& look, const TruthView& view)
{
	std::set<std::string> walls;
	for (const DoorLabel& label : look.scene.world().doors)
	{
		const auto door = doorInView(label, view);
		const bool visible = door && door->visibility == Visibility::visible;
		if (visible) walls.insert(wallOf(label.id));
		if (!visible && std::ranges::count(promise.visible_doors, label.id) > 0) return false;
		if (promise.one_jamb == label.id && !(door && exactlyOneJamb(*door))) return false;
	}
	return static_cast<int>(walls.size()) >= promise.walls_with_visible_doors;
}

bool seesFloor(const PromisedLook& look)
{
	constexpr int kColumns = 24, kRows = 18;
	constexpr double kFar_m = 20;
	const Eigen::Isometry3d map_from_camera = isometryOf(look.map_from_robot + look.camera.robot_from_camera);
	const CameraIntrinsics& intrinsics = look.camera.intrinsics;
	for (int row = 0; row < kRows; ++row)
		for (int column = 0; column < kColumns; ++column)
		{
			const Eigen::Vector3d ray = rayOfPixel(intrinsics, (intrinsics.width_px - 1.0) * column / (kColumns - 1),
			                                       (intrinsics.height_px - 1.0) * row / (kRows - 1));
			const auto hit =
			    look.scene.cast(map_from_camera.translation(), map_from_camera.linear() * ray.normalized(), kFar_m);
			if (hit && hit->moving < 0 && look.scene.world().bodies[hit->body].name == "floor") return true;
		}
	return false;
}
}  // namespace

bool keeps(const Promise& promise, const PromisedLook& look)
{
	const TruthView view(look.scene, look.camera.intrinsics,
	                     isometryOf(look.map_from_robot + look.camera.robot_from_camera));
	for (const Region& region : promise.regions)
	{
		const double share = shareInView(region, view, look.map_from_building);
		if (share < region.share.low || share > region.share.high) return false;
	}
	return doorsAreKept(promise, look, view) && !(promise.floor_unseen && seesFloor(look));
}
}  // namespace explore::simulation

// Whether a robot gets through what is labelled open, and nowhere else out of the room in which it stands.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "scene_support.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using Eigen::Vector2d;

namespace
{
/** How far `point` is out of the rectangle; negative inside. */
double outOf(const std::vector<Vector2d>& corners, const Vector2d& point)
{
	const Vector2d x = (corners[1] - corners[0]).normalized(), y = (corners[3] - corners[0]).normalized();
	const Vector2d from = point - corners[0];
	const double right_m = from.dot(x) - (corners[1] - corners[0]).norm();
	const double back_m = from.dot(y) - (corners[3] - corners[0]).norm();
	return std::max({-from.dot(x), right_m, -from.dot(y), back_m});
}

bool hasFloor(const RayScene& scene, const Vector2d& place)
{
	const auto hit = scene.cast({place.x(), place.y(), 0.3}, {0, 0, -1}, 1.0);
	return hit && hit->distance < 0.36;
}
}  // namespace

TEST(ScenePassage, LeadsThroughEveryVisibleDoorThatIsPassable)
{
	const RobotConfig robot;
	const Pusher body{robot.radius_m, 0.06, robot.height_m};
	for (const char* family :
	     {"single_wall_single_door", "single_wall_multiple_doors", "multiple_walls_multiple_doors", "corner_door",
	      "narrow_door", "box_hiding_jamb", "threshold_low", "split_wall_door", "ajar_30", "ajar_60", "leaf_toward_us",
	      "passage_no_lintel", "wide_passage", "corridor_side_doors", "corridor_end"})
		for (int index = 0; index < 6; ++index)
		{
			const Scene scene = sceneOf(family, index);
			for (const TruthDoor& door : firstLook(scene).doors)
			{
				if (!door.passable || door.visibility != Visibility::visible) continue;
				const Vector2d center = door.center_in_map.head<2>(), normal = door.normal_in_map.head<2>();
				const double half_m = 0.5 * door.width_m;
				const auto beside = [&](const Vector2d& p)
				{ return (p - center).dot(Vector2d(-normal.y(), normal.x())); };
				const auto before = [&](const Vector2d& p) { return (p - center).dot(normal); };
				const auto inside = [&](const Vector2d& p) {
					return outOf(scene.room_in_map, p) < 0 ||
					       (std::abs(beside(p)) < half_m && std::abs(before(p)) < 1.2);
				};
				// Into the room behind by more than the wall's thickness and the robot's radius.
				EXPECT_TRUE(reaches(*scene.rays, body, {0, 0}, 0.04, inside,
				                    [&](const Vector2d& p) { return before(p) < -0.45; }))
				    << family << ' ' << index << ' ' << door.id;
			}
		}
}

TEST(ScenePassage, LeadsNowhereInNegativeScenes)
{
	constexpr double kNiche_m = 0.42;  // an alcove is at most 0.6 m deep
	const RobotConfig robot;
	const Pusher body{robot.radius_m + 0.05, 0.03, robot.height_m};
	for (const SceneFamily& family : sceneFamilies())
	{
		// A dark room could be entered; that is what one cannot know.
		if (!family.negativeFor(RobotKind::ground) || family.name == "dark_deep_room") continue;
		for (int index = 0; index < 8; ++index)
		{
			const Scene scene = sceneOf(family.name, index);
			const auto inside = [&](const Vector2d& p) { return hasFloor(*scene.rays, p); };
			EXPECT_FALSE(reaches(*scene.rays, body, {0, 0}, 0.1, inside,
			                     [&](const Vector2d& p) { return outOf(scene.room_in_map, p) > kNiche_m; }))
			    << family.name << ' ' << index;
		}
	}
}

TEST(ScenePassage, HasFloorAllOverTheRobotsRoom)
{
	for (const SceneFamily& family : sceneFamilies())
	{
		const Scene scene = sceneOf(family.name, 3);
		ASSERT_EQ(scene.room_in_map.size(), 4U);
		EXPECT_LT(outOf(scene.room_in_map, {0, 0}), -0.2) << family.name;
		const auto& corners = scene.room_in_map;
		for (const double x : {0.02, 0.3, 0.6, 0.98})
			for (const double y : {0.02, 0.3, 0.6, 0.98})
			{
				const Vector2d place = corners[0] + x * (corners[1] - corners[0]) + y * (corners[3] - corners[0]);
				const auto hit = scene.rays->cast({place.x(), place.y(), -1.0}, {0, 0, 1}, 2.0);
				ASSERT_TRUE(hit.has_value()) << family.name;
				EXPECT_NEAR(hit->distance, 0.9, 0.01) << "the floor is 10 cm thick";
			}
	}
}

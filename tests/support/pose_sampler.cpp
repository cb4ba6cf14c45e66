#include "support/pose_sampler.h"

#include "support/free_floor.h"

#include <explore/core/geometry.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

namespace explore::test
{
namespace
{
using namespace simulation;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kApart_m = 0.5;         ///< from every surface
constexpr double kCorridorShare = 0.12;  ///< of the poses that look along a corridor

class Sampler
{
public:
	Sampler(const RayScene& scene, SampleOptions options, std::uint64_t seed)
	    : m_scene(scene), m_options(std::move(options)), m_dice(seed), m_floor(scene)
	{
		if (m_floor.empty()) throw std::runtime_error("no free floor around the world's spawns");
		for (const CorridorLabel& corridor : scene.world().corridors)
			if ((corridor.end_in_map - corridor.start_in_map).norm() > 3 * corridor.width_m)
				m_corridors.push_back(&corridor);
	}

	std::vector<SampledPose> run()
	{
		constexpr int kTrials = 4000;
		std::vector<SampledPose> poses;
		for (int i = 0; i < m_options.count; ++i)
		{
			const Aim aim = drawAim();
			for (int trial = 0; trial < kTrials; ++trial)
				if (const auto pose = draw(aim))
				{
					poses.push_back(*pose);
					break;
				}
		}
		return poses;
	}

private:
	/** What a pose is there to show. */
	enum class Aim
	{
		door,
		corridor,
		anything
	};

	[[nodiscard]] Aim drawAim()
	{
		const World& world = m_scene.world();
		const double choice = m_dice.between(0, 1);
		if (choice < m_options.door_share) return world.doors.empty() ? Aim::anything : Aim::door;
		return choice < m_options.door_share + kCorridorShare && !m_corridors.empty() ? Aim::corridor : Aim::anything;
	}

	[[nodiscard]] std::optional<SampledPose> draw(Aim aim)
	{
		const std::optional<View> view = aim == Aim::door       ? doorView()
		                                 : aim == Aim::corridor ? corridorView()
		                                                        : View{m_floor.draw(m_dice), anyAngle()};
		if (!view || !m_options.within.contains(view->at) || !m_floor.reached(view->at)) return std::nullopt;
		SampledPose pose;
		pose.position = {view->at.x(), view->at.y(), m_options.mav ? m_dice.between(0.7, 1.8) : floorAt(view->at)};
		const double eye_m = pose.position.z() + (m_options.mav ? 0.0 : m_options.camera_m);
		if (!clear(view->at, eye_m)) return std::nullopt;
		if (aim == Aim::door && !m_scene.world().doors.empty() && !sees({view->at.x(), view->at.y(), eye_m}, *m_door))
			return std::nullopt;
		const double tilt = (m_options.mav ? 15 : 1) * kDegree_rad;
		pose.yaw_rad = view->yaw_rad;
		pose.pitch_rad = m_dice.between(-tilt, tilt);
		pose.roll_rad = m_dice.between(-tilt, tilt);
		return pose;
	}

	/** 0, but where the world's floor is another one. */
	[[nodiscard]] double floorAt(const Vector2d& at) const
	{
		constexpr double kFrom_m = 0.3, kCarpet_m = 0.015;
		const auto floor = m_scene.cast({at.x(), at.y(), kFrom_m}, -Vector3d::UnitZ(), 1);
		const double height_m = floor ? kFrom_m - floor->distance : 0.0;
		return std::abs(height_m) > kCarpet_m ? height_m : 0.0;
	}

	/** Room for the robot, and nothing within kApart_m of its camera at the height of its eye. */
	[[nodiscard]] bool clear(const Vector2d& at, double eye_m) const
	{
		const double low = m_options.mav ? eye_m - 0.3 : eye_m - m_options.camera_m + 0.05,
		             high = std::max(eye_m + 0.15, m_options.mav ? 0.0 : 0.7);
		return !m_scene.touchesCylinder({at.x(), at.y(), low}, kApart_m, high - low);
	}

	struct View
	{
		Vector2d at;
		double yaw_rad = 0;
	};

	[[nodiscard]] double anyAngle() { return m_dice.between(-std::numbers::pi, std::numbers::pi); }

	/** From 1.2–5.2 m before a door, up to 75° off its normal; the door is up to 20° off the image's middle. */
	[[nodiscard]] std::optional<View> doorView()
	{
		m_door = &m_dice.oneOf(m_scene.world().doors);
		const Vector2d normal = m_door->normal_in_map.head<2>();
		const double off = std::atan2(normal.y(), normal.x()) + m_dice.between(-75, 75) * kDegree_rad +
		                   (m_dice.chance(0.5) ? std::numbers::pi : 0);
		const Vector2d away(std::cos(off), std::sin(off));
		return View{m_door->floor_center_in_map.head<2>() + m_dice.between(1.2, 5.2) * away,
		            std::atan2(-away.y(), -away.x()) + m_dice.between(-20, 20) * kDegree_rad};
	}

	/** Somewhere in a long corridor, along it. */
	[[nodiscard]] std::optional<View> corridorView()
	{
		const CorridorLabel& corridor = *m_dice.oneOf(m_corridors);
		const Vector2d axis = corridor.end_in_map - corridor.start_in_map, left(-axis.y(), axis.x());
		const double half = 0.5 * corridor.width_m / axis.norm();
		return View{corridor.start_in_map + m_dice.between(0, 1) * axis + m_dice.between(-half, half) * left,
		            std::atan2(axis.y(), axis.x()) + (m_dice.chance(0.5) ? std::numbers::pi : 0) +
		                m_dice.between(-20, 20) * kDegree_rad};
	}

	/** Whether the middle of the opening, before the wall's near face, is in the line of sight. */
	[[nodiscard]] bool sees(const Vector3d& eye, const DoorLabel& door) const
	{
		const Vector2d normal = door.normal_in_map.head<2>().normalized();
		const double side = (eye - door.floor_center_in_map).head<2>().dot(normal);
		const Vector2d before = std::copysign(0.5 * door.depth_m + 0.03, side) * normal;
		return !m_scene.occluded(eye, door.floor_center_in_map + Vector3d(before.x(), before.y(), 1.2), 0.02);
	}

	const RayScene& m_scene;
	SampleOptions m_options;
	Dice m_dice;
	FreeFloor m_floor;
	std::vector<const CorridorLabel*> m_corridors;  ///< long ones
	const DoorLabel* m_door = nullptr;              ///< that the view being drawn is of
};
}  // namespace

std::vector<SampledPose> samplePoses(const RayScene& scene, const SampleOptions& options, std::uint64_t seed)
{
	return Sampler(scene, options, seed).run();
}
}  // namespace explore::test

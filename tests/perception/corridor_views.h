// Upright views of made-up corridors, and walls as a test says they were found: nothing of it comes from the library's
// own search.
#pragma once

#include <explore/core/geometry.h>
#include <explore/perception/corridor_pairs.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "support/analytic_scene.h"

namespace explore::test
{

/** Noise and gaps of a Kinect. */
inline CameraNoise sensorNoise(std::uint32_t seed, double max_depth_m = 8.0)
{
	CameraNoise noise;
	noise.axial_scale = 1.0;
	noise.dropout_share = 0.05;
	noise.max_depth_m = max_depth_m;
	noise.seed = seed;
	return noise;
}

/** The same with every standard library. */
inline double uniform(std::mt19937& random, double from, double to)
{
	return from + (to - from) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
}

/** A camera's place in the map, where corridors lead along x. */
struct CameraPlace
{
	double x_m = 0, y_m = 0, z_m = 0.6, yaw_rad = 0, pitch_rad = 0, roll_rad = 0;
};

struct CorridorView
{
	DepthFrame frame;
	LevelView level;
	Eigen::Isometry2d level_from_map;

	[[nodiscard]] Eigen::Vector2d toMap(const Eigen::Vector2d& point) const { return level_from_map.inverse() * point; }

	/** A wall found between two places of the map, turned by `error_rad` about its middle. */
	[[nodiscard]] UprightWall wall(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double error_rad = 0) const
	{
		const Eigen::Vector2d p = level_from_map * a, q = level_from_map * b, middle = 0.5 * (p + q);
		const Eigen::Vector2d along = Eigen::Rotation2Dd(error_rad) * (q - p).normalized();
		UprightWall found;
		found.normal = {-along.y(), along.x()};
		if (found.normal.dot(middle) > 0) found.normal = -found.normal;
		found.offset_m = -found.normal.dot(middle);
		const double half = 0.5 * (q - p).norm(), at = found.along_m(middle);
		found.from_m = at - half;
		found.to_m = at + half;
		found.samples = static_cast<std::size_t>(500 * 2 * half);
		return found;
	}
};

inline std::unique_ptr<CorridorView> viewOf(const Scene& scene, const CameraPlace& place, const CameraNoise& noise = {})
{
	using mrpt::poses::CPose3D;
	auto view = std::make_unique<CorridorView>();
	const CPose3D map_from_robot(place.x_m, place.y_m, 0, place.yaw_rad, 0, 0);
	const CPose3D mount(0, 0, place.z_m, 0, place.pitch_rad, place.roll_rad);
	view->frame = renderFrame(scene, map_from_robot, mount, xtionIntrinsics(), noise);
	view->level.image = &view->frame.image;
	const Eigen::Isometry3d robot_from_camera = isometryOf(mount);
	const Eigen::Vector3d axis = robot_from_camera.linear().col(0);
	LevelPose& pose = view->level.pose;
	pose.robot_from_level.linear() =
	    Eigen::AngleAxisd(std::atan2(axis.y(), axis.x()), Eigen::Vector3d::UnitZ()).toRotationMatrix();
	pose.level_from_camera = pose.robot_from_level.inverse() * robot_from_camera;
	const Eigen::Isometry3d level_from_map = pose.robot_from_level.inverse() * isometryOf(map_from_robot).inverse();
	view->level_from_map.linear() = level_from_map.linear().topLeftCorner<2, 2>();
	view->level_from_map.translation() = level_from_map.translation().head<2>();
	view->level_from_map.matrix().row(2) << 0, 0, 1;

	LevelSamples& samples = view->level.samples;
	const CameraIntrinsics& camera = view->frame.image.intrinsics;
	for (int v = 0; v < camera.height_px; v += samples.stride)
		for (int u = 0; u < camera.width_px; u += samples.stride)
		{
			const float depth = view->frame.image.at(u, v);
			if (depth <= 0) continue;
			const Eigen::Vector3d point = pose.level_from_camera * (depth * rayOfPixel(camera, u, v));
			samples.x.push_back(static_cast<float>(point.x()));
			samples.y.push_back(static_cast<float>(point.y()));
			samples.z.push_back(static_cast<float>(point.z()));
			samples.depth_m.push_back(depth);
			samples.u.push_back(static_cast<std::int16_t>(u));
			samples.v.push_back(static_cast<std::int16_t>(v));
		}
	return view;
}

/** A corridor along x between y = ±width/2, from x = −2 on, 2.6 m high, and a floor under everything. */
inline Scene sideWalls(double width_m, double end_m, const std::vector<Opening>& left = {},
                       const std::vector<Opening>& right = {})
{
	Scene scene;
	scene.floor(-4, -9, 16, 9).wall({-2, 0.5 * width_m}, {end_m, 0.5 * width_m}, 2.6, left);
	return scene.wall({-2, -0.5 * width_m}, {end_m, -0.5 * width_m}, 2.6, right);
}

/** Both walls of the above as a perfect search would find them from x = `from_m` to `to_m`. */
inline std::vector<UprightWall> bothWalls(const CorridorView& view, double width_m, double from_m, double to_m,
                                          double left_error_rad = 0, double right_error_rad = 0)
{
	const double side = 0.5 * width_m;
	return {view.wall({from_m, side}, {to_m, side}, left_error_rad),
	        view.wall({from_m, -side}, {to_m, -side}, right_error_rad)};
}
}  // namespace explore::test

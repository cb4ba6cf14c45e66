#include "support/analytic_scene.h"

#include <explore/core/geometry.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace explore::test
{
Scene& Scene::patch(const Patch& patch)
{
	m_patches.push_back(patch);
	return *this;
}

Scene& Scene::floor(double x_min, double y_min, double x_max, double y_max, double z)
{
	return patch({{x_min, y_min, z}, {x_max - x_min, 0, 0}, {0, y_max - y_min, 0}});
}

Scene& Scene::wall(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double height_m,
                   const std::vector<Opening>& openings)
{
	const double length = (b - a).norm();
	const Eigen::Vector3d along((b - a).x() / length, (b - a).y() / length, 0.0);
	const Eigen::Vector3d origin(a.x(), a.y(), 0.0);
	const auto panel = [&](double from, double to, double bottom, double top)
	{
		if (to - from > 1e-9 && top - bottom > 1e-9)
			patch({origin + from * along + bottom * Eigen::Vector3d::UnitZ(), (to - from) * along,
			       (top - bottom) * Eigen::Vector3d::UnitZ()});
	};
	double done = 0.0;
	for (const Opening& opening : openings)
	{
		panel(done, opening.start_m, 0.0, height_m);
		panel(opening.start_m, opening.start_m + opening.width_m, opening.height_m, height_m);
		done = opening.start_m + opening.width_m;
	}
	panel(done, length, 0.0, height_m);
	return *this;
}

Scene& Scene::box(const Eigen::Vector3d& center, const Eigen::Vector3d& size)
{
	for (int axis = 0; axis < 3; ++axis)
	{
		const int u = (axis + 1) % 3, v = (axis + 2) % 3;
		for (const double side : {-0.5, 0.5})
		{
			Patch face{center - 0.5 * size, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
			face.corner[axis] = center[axis] + side * size[axis];
			face.edge_u[u] = size[u];
			face.edge_v[v] = size[v];
			patch(face);
		}
	}
	return *this;
}

double castRay(const Scene& scene, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction)
{
	double nearest = 0.0;
	for (const Patch& patch : scene.patches())
	{
		const Eigen::Vector3d normal = patch.edge_u.cross(patch.edge_v);
		const double facing = normal.dot(direction);
		if (std::abs(facing) < 1e-12) continue;
		const double distance = normal.dot(patch.corner - origin) / facing;
		if (distance <= 1e-9 || (nearest > 0.0 && distance >= nearest)) continue;
		const Eigen::Vector3d offset = origin + distance * direction - patch.corner;
		const double s = offset.cross(patch.edge_v).dot(normal) / normal.squaredNorm();
		const double t = patch.edge_u.cross(offset).dot(normal) / normal.squaredNorm();
		if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) nearest = distance;
	}
	return nearest;
}

CameraIntrinsics xtionIntrinsics(int width_px, int height_px)
{
	const double focal = 0.919 * width_px;
	return {width_px, height_px, focal, focal, 0.5 * (width_px - 1), 0.5 * (height_px - 1)};
}

DepthFrame renderFrame(const Scene& scene, const mrpt::poses::CPose3D& map_from_robot,
                       const mrpt::poses::CPose3D& robot_from_camera, const CameraIntrinsics& intrinsics,
                       const CameraNoise& noise)
{
	DepthFrame frame;
	frame.sensor_label = "ANALYTIC";
	frame.timestamp = mrpt::Clock::fromDouble(1'400'000'000.0);
	frame.robot_from_camera = robot_from_camera;
	frame.map_from_robot = map_from_robot;
	frame.image.intrinsics = intrinsics;
	frame.image.depth_m.reserve(static_cast<std::size_t>(intrinsics.width_px) *
	                            static_cast<std::size_t>(intrinsics.height_px));

	const Eigen::Isometry3d map_from_camera = isometryOf(map_from_robot + robot_from_camera);
	std::mt19937 random(noise.seed);
	std::normal_distribution<double> gauss;
	std::uniform_real_distribution<double> uniform;
	for (int v = 0; v < intrinsics.height_px; ++v)
		for (int u = 0; u < intrinsics.width_px; ++u)
		{
			// The pinhole written out once more, so that an error in the library's cannot hide in its own tests.
			const Eigen::Vector3d ray(1.0, -(u - intrinsics.cx_px) / intrinsics.fx_px,
			                          -(v - intrinsics.cy_px) / intrinsics.fy_px);
			double depth = castRay(scene, map_from_camera.translation(), map_from_camera.linear() * ray);
			const double sigma = noise.axial_scale * (0.0012 + 0.0019 * (depth - 0.4) * (depth - 0.4));
			if (depth > 0.0 && noise.axial_scale > 0.0) depth += sigma * gauss(random);
			if (noise.dropout_share > 0.0 && uniform(random) < noise.dropout_share) depth = 0.0;
			if (depth > noise.max_depth_m || depth < noise.min_depth_m) depth = 0.0;
			frame.image.depth_m.push_back(static_cast<float>(depth));
		}
	return frame;
}

Scene corridorScene(double length_m, const std::vector<double>& left_doors, const std::vector<double>& right_doors)
{
	constexpr double kHalfWidth = 1.0, kHeight = 2.5, kDoorWidth = 0.9, kDoorHeight = 2.0, kRoomDepth = 3.0;
	const double behind = -2.0;
	Scene scene;
	scene.floor(behind, -kHalfWidth - kRoomDepth, length_m, kHalfWidth + kRoomDepth);
	const auto side = [&](double sign, const std::vector<double>& doors)
	{
		std::vector<Opening> openings;
		for (const double x : doors) openings.push_back({x - behind, kDoorWidth, kDoorHeight});
		scene.wall({behind, sign * kHalfWidth}, {length_m, sign * kHalfWidth}, kHeight, openings);
		scene.wall({behind, sign * (kHalfWidth + kRoomDepth)}, {length_m, sign * (kHalfWidth + kRoomDepth)}, kHeight);
	};
	side(1.0, left_doors);
	side(-1.0, right_doors);
	const double outer = kHalfWidth + kRoomDepth;
	scene.wall({length_m, -outer}, {length_m, outer}, kHeight);
	scene.wall({behind, -outer}, {behind, outer}, kHeight);
	return scene;
}
}  // namespace explore::test

#include <explore/core/errors.h>
#include <explore/core/geometry.h>
#include <explore/memory/frame_rays.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace explore
{
namespace
{
void checkPlace(const Eigen::Vector3d& voxels, const DepthFrame& frame, const OccupancyConfig& config)
{
	const double reach = config.range_m / config.resolution_m + 2.0 * kBlockEdge;
	// Written so that NaN fails too.
	if ((voxels.array().abs() < kOriginKey - reach).all()) return;
	throw InputError(mrpt::format(
	    "frame %zu: the camera is at (%g, %g, %g) m in the map, but with voxels of %g m it must be within %g m",
	    frame.index, voxels.x() * config.resolution_m, voxels.y() * config.resolution_m,
	    voxels.z() * config.resolution_m, config.resolution_m, (kOriginKey - reach) * config.resolution_m));
}

void setOptics(FrameRays& rays, const CameraIntrinsics& camera)
{
	rays.width_px = camera.width_px;
	rays.height_px = camera.height_px;
	rays.left.assign(static_cast<std::size_t>(camera.width_px) + FrameRays::kLanes,
	                 std::numeric_limits<float>::quiet_NaN());
	rays.up.resize(static_cast<std::size_t>(camera.height_px));
	for (int u = 0; u < camera.width_px; ++u)
		rays.left[static_cast<std::size_t>(u)] = static_cast<float>(rayOfPixel(camera, u, camera.cy_px).y());
	for (int v = 0; v < camera.height_px; ++v)
		rays.up[static_cast<std::size_t>(v)] = static_cast<float>(rayOfPixel(camera, camera.cx_px, v).z());
	const Eigen::Vector2d axis = pixelOfPoint(camera, {1.0, 0.0, 0.0}).value();
	rays.axis_px = axis.cast<float>().array();
	rays.px_per_tangent = (pixelOfPoint(camera, {1.0, 1.0, 1.0}).value() - axis).cast<float>().array();
}

void setReach(FrameRays& rays, const DepthImage& image, float range_m)
{
	rays.reach_m.resize(image.depth_m.size() + FrameRays::kLanes);
	std::fill(rays.reach_m.end() - FrameRays::kLanes, rays.reach_m.end(), 0.0F);
	const auto width = static_cast<std::size_t>(rays.width_px);
	for (std::size_t v = 0; v < rays.up.size(); ++v)
	{
		const float* depth_m = image.depth_m.data() + v * width;
		float* reach_m = rays.reach_m.data() + v * width;
		const float row = 1.0F + rays.up[v] * rays.up[v];
		for (std::size_t u = 0; u < width; ++u)
			reach_m[u] = std::min(depth_m[u], range_m / std::sqrt(row + rays.left[u] * rays.left[u]));
	}
}
}  // namespace

void setRays(FrameRays& rays, const DepthFrame& frame, const OccupancyConfig& config)
{
	const Eigen::Isometry3d map_from_camera = isometryOf(frame.map_from_robot + frame.robot_from_camera);
	const Eigen::Vector3d camera_in_voxels = map_from_camera.translation() / config.resolution_m;
	checkPlace(camera_in_voxels, frame, config);
	const Eigen::Vector3d corner = camera_in_voxels.array().floor();
	rays.origin_key = corner.array().cast<int>() + kOriginKey;
	rays.origin = (camera_in_voxels - corner).cast<float>();
	rays.voxels_from_camera = (map_from_camera.linear() / config.resolution_m).cast<float>();
	rays.camera_from_voxels = (map_from_camera.linear().transpose() * config.resolution_m).cast<float>();
	setOptics(rays, frame.image.intrinsics);
	setReach(rays, frame.image, static_cast<float>(config.range_m));
}
}  // namespace explore

// What a camera sees by noise-free rays: the one test behind all visibility figures.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/simulation/ray_scene.h>

#include <string>

namespace explore::simulation
{
/** How a point looks to the camera. */
enum class PointSight
{
	outside,  ///< out of the image
	hidden,   ///< behind something
	glass,    ///< only panes of glass in between
	clear,
};

class TruthView
{
public:
	/** `scene` outlives it. */
	TruthView(const RayScene& scene, const CameraIntrinsics& intrinsics, const Eigen::Isometry3d& map_from_camera);

	[[nodiscard]] Eigen::Vector3d cameraInMap() const { return m_map_from_camera.translation(); }
	/** Depth [m] of the point along the optical axis. */
	[[nodiscard]] double depthOf(const Eigen::Vector3d& point_in_map) const;
	[[nodiscard]] bool inImage(const Eigen::Vector3d& point_in_map) const;

	/** Surfaces less than `margin_m` before the point do not hide it, nor does a body called `transparent` (see
	 *  belongsTo); empty = every body hides. */
	[[nodiscard]] PointSight sightOf(const Eigen::Vector3d& point_in_map, const std::string& transparent = {},
	                                 double margin_m = 0.005) const;

private:
	[[nodiscard]] const std::string& nameOf(const RayHit& hit) const;

	const RayScene* m_scene;
	CameraIntrinsics m_intrinsics;
	Eigen::Isometry3d m_map_from_camera, m_camera_from_map;
};

/** Whether a component of `body_name` ("model::link::visual") begins with `part`; never for an empty part. */
bool belongsTo(const std::string& body_name, const std::string& part);
}  // namespace explore::simulation

#include <explore/simulation/truth_view.h>

namespace explore::simulation
{
bool belongsTo(const std::string& body_name, const std::string& part)
{
	if (part.empty()) return false;
	for (std::size_t start = 0; start != std::string::npos;)
	{
		if (body_name.compare(start, part.size(), part) == 0) return true;
		const std::size_t separator = body_name.find("::", start);
		start = separator == std::string::npos ? separator : separator + 2;
	}
	return false;
}

TruthView::TruthView(const RayScene& scene, const CameraIntrinsics& intrinsics,
                     const Eigen::Isometry3d& map_from_camera)
    : m_scene(&scene),
      m_intrinsics(intrinsics),
      m_map_from_camera(map_from_camera),
      m_camera_from_map(map_from_camera.inverse())
{
}

double TruthView::depthOf(const Eigen::Vector3d& point_in_map) const
{
	return (m_camera_from_map * point_in_map).x();
}

bool TruthView::inImage(const Eigen::Vector3d& point_in_map) const
{
	const auto pixel = pixelOfPoint(m_intrinsics, m_camera_from_map * point_in_map);
	return pixel && pixel->x() >= -0.5 && pixel->x() <= m_intrinsics.width_px - 0.5 && pixel->y() >= -0.5 &&
	       pixel->y() <= m_intrinsics.height_px - 0.5;
}

const std::string& TruthView::nameOf(const RayHit& hit) const
{
	const World& world = m_scene->world();
	return hit.moving >= 0 ? world.moving[static_cast<std::size_t>(hit.moving)].name : world.bodies[hit.body].name;
}

PointSight TruthView::sightOf(const Eigen::Vector3d& point_in_map, const std::string& transparent,
                              double margin_m) const
{
	// Steps past what lets the ray through; a ray that starts on a surface could meet it again.
	constexpr double kStep_m = 1e-4;
	if (!inImage(point_in_map)) return PointSight::outside;
	Eigen::Vector3d origin = cameraInMap();
	const Eigen::Vector3d direction = (point_in_map - origin).normalized();
	double left_m = (point_in_map - origin).norm() - margin_m;
	bool through_glass = false;
	while (left_m > 0.0)
	{
		const auto hit = m_scene->cast(origin, direction, left_m);
		if (!hit) break;
		const bool pane = m_scene->world().materials[hit->material].surface == Surface::glass;
		if (!pane && !belongsTo(nameOf(*hit), transparent)) return PointSight::hidden;
		through_glass = through_glass || pane;
		origin += (hit->distance + kStep_m) * direction;
		left_m -= hit->distance + kStep_m;
	}
	return through_glass ? PointSight::glass : PointSight::clear;
}
}  // namespace explore::simulation

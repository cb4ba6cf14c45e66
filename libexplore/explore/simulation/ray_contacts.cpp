#include <explore/simulation/ray_scene_impl.h>
#include <explore/simulation/triangle_distance.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace explore::simulation
{
namespace
{
/** Looks at the triangles near a point; what it returns is the radius to go on with. */
using Visit = std::function<double(const Triangle&)>;

struct PointSearch
{
	const BakedMesh& mesh;
	const Visit& visit;
};

/** Embree's tree is in floats: a little more radius keeps what rounding would cut off. */
float roundedUp(double radius_m, const Eigen::Vector3d& center)
{
	return static_cast<float>(radius_m + 1e-6 * (1.0 + radius_m + center.norm()));
}

bool visitTriangle(RTCPointQueryFunctionArguments* arguments)
{
	const auto& search = *static_cast<const PointSearch*>(arguments->userPtr);
	const std::uint32_t triangle = search.mesh.facets[arguments->geomID][arguments->primID].triangle;
	RTCPointQuery& query = *arguments->query;
	const Eigen::Vector3d center(query.x, query.y, query.z);
	const float radius = roundedUp(search.visit(search.mesh.corners(triangle)), center);
	if (!(radius < query.radius)) return false;
	query.radius = radius;
	return true;
}

void visitNear(const BakedMesh& mesh, const Eigen::Vector3d& center, double radius_m, const Visit& visit)
{
	if (!center.cast<float>().allFinite()) return;
	PointSearch search{mesh, visit};
	RTCPointQuery query{};
	query.x = static_cast<float>(center.x());
	query.y = static_cast<float>(center.y());
	query.z = static_cast<float>(center.z());
	query.radius = roundedUp(radius_m, center);
	RTCPointQueryContext context{};
	rtcInitPointQueryContext(&context);
	rtcPointQuery(mesh.scene.get(), &query, &context, visitTriangle, &search);
}

Triangle moved(const Eigen::Isometry3d& transform, const Triangle& triangle)
{
	return {transform * triangle[0], transform * triangle[1], transform * triangle[2]};
}
}  // namespace

void RayScene::Impl::visitTriangles(const Eigen::Vector3d& center, double radius_m,
                                    const std::function<double(const Triangle&)>& visit) const
{
	double radius = radius_m;
	visitNear(still, center, radius, [&](const Triangle& triangle) { return radius = visit(triangle); });
	for (const PlacedBody& body : moving)
		visitNear(body.mesh, body.body_from_map * center, radius,
		          [&](const Triangle& triangle) { return radius = visit(moved(body.map_from_body, triangle)); });
}

double RayScene::clearance(const Eigen::Vector3d& point, double max_m) const
{
	double nearest = max_m;
	m_impl->visitTriangles(point, max_m,
	                       [&](const Triangle& triangle)
	                       { return nearest = std::min(nearest, distanceToTriangle(point, triangle)); });
	return nearest;
}

bool RayScene::touchesCylinder(const Eigen::Vector3d& base, double radius_m, double height_m) const
{
	const VerticalCylinder cylinder{base, radius_m, height_m};
	const double reach = std::hypot(radius_m, 0.5 * height_m);
	bool touched = false;
	m_impl->visitTriangles(base + Eigen::Vector3d(0.0, 0.0, 0.5 * height_m), reach,
	                       [&](const Triangle& triangle)
	                       {
		                       touched = touched || meets(cylinder, triangle);
		                       return touched ? 0.0 : reach;
	                       });
	return touched;
}

bool RayScene::touchesCapsule(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double radius_m) const
{
	const double reach = radius_m + 0.5 * (high - low).norm();
	bool touched = false;
	m_impl->visitTriangles(0.5 * (low + high), reach,
	                       [&](const Triangle& triangle)
	                       {
		                       touched = touched || distanceToTriangle(low, high, triangle) <= radius_m;
		                       return touched ? 0.0 : reach;
	                       });
	return touched;
}
}  // namespace explore::simulation

#include "scene_sketch.h"

#include <explore/core/geometry.h>
#include <explore/simulation/recorder.h>
#include <explore/simulation/shapes.h>

#include <algorithm>
#include <cmath>

namespace explore::simulation
{
namespace
{
BuildingStyle drawStyle(Random& random)
{
	BuildingStyle style;
	style.wall_thickness_m = random.uniform(0.08, 0.25);
	style.wall_height_m = random.uniform(2.3, 3.5);
	style.ceiling = random.chance(0.75);
	if (random.chance(0.4))
		style.casing_depth_m = random.uniform(0.01, 0.03), style.casing_width_m = random.uniform(0.05, 0.1);
	if (random.chance(0.6))
		style.skirting_depth_m = random.uniform(0.008, 0.02), style.skirting_height_m = random.uniform(0.06, 0.12);
	return style;
}

/** A wheeled robot stands as level as its floor; a MAV leans into its acceleration. */
Viewpoint drawAttitude(Random& random, RobotKind kind)
{
	Viewpoint view;
	const bool flies = kind == RobotKind::mav;
	const double lean_rad = kDegree_rad * (flies ? 10.0 : 1.0);
	view.camera_height_m = flies ? random.uniform(1.0, 2.0) : random.uniform(0.3, 1.2);
	view.body_roll_rad = random.uniform(-lean_rad, lean_rad);
	view.body_pitch_rad = random.uniform(-lean_rad, lean_rad);
	view.mount_forward_m = flies ? usualMount(kind).x() : random.uniform(0.0, 0.15);
	return view;
}
}  // namespace

Sketch::Sketch(const RobotConfig& seen_from, const CameraIntrinsics& camera, std::uint64_t seed)
    : random(seed),
      robot(seen_from),
      intrinsics(camera),
      style(drawStyle(random)),
      view(drawAttitude(random, robot.kind))
{
}

double Sketch::halfView_rad() const
{
	const double left_px = intrinsics.cx_px, right_px = intrinsics.width_px - 1 - intrinsics.cx_px;
	return std::atan(std::min(left_px, right_px) / intrinsics.fx_px);
}

Eigen::Vector2d Sketch::robotPosition() const
{
	return view.camera - view.mount_forward_m * Eigen::Vector2d(std::cos(view.yaw_rad), std::sin(view.yaw_rad));
}

std::size_t Sketch::material(std::string_view name, const Eigen::Vector3f& color)
{
	const std::string key(name);
	for (std::size_t i = 0; i < world.materials.size(); ++i)
		if (world.materials[i].name == key) return i;
	Eigen::Vector3f shade = color * static_cast<float>(random.uniform(0.75, 1.25));
	for (float& channel : shade)
		channel = std::clamp(channel + static_cast<float>(random.uniform(-0.06, 0.06)), 0.05F, 1.0F);
	return world.materialNamed(key, shade);
}

std::size_t Sketch::paint()
{
	static const std::array<std::pair<const char*, Eigen::Vector3f>, 6> kPaints = {{{"oak", {0.6F, 0.45F, 0.28F}},
	                                                                                {"white", {0.85F, 0.85F, 0.82F}},
	                                                                                {"steel", {0.5F, 0.52F, 0.55F}},
	                                                                                {"red", {0.65F, 0.2F, 0.18F}},
	                                                                                {"blue", {0.2F, 0.3F, 0.55F}},
	                                                                                {"green", {0.25F, 0.45F, 0.28F}}}};
	const auto& [name, color] = kPaints[static_cast<std::size_t>(random.integer(0, 5))];
	return material(name, color);
}

void Sketch::place(const std::string& body, const TriangleMesh& piece, const Eigen::Isometry3d& building_from_piece,
                   std::size_t material)
{
	TriangleMesh moved;
	append(moved, piece, building_from_piece);
	world.add(body, moved, material);
}

void Sketch::block(const std::string& body, const WallFrame& frame, const Span& along, const Span& behind,
                   const Span& z, std::size_t material)
{
	if (along.length() <= 0 || behind.length() <= 0 || z.length() <= 0) return;
	place(body, boxMesh({along.length(), behind.length(), z.length()}),
	      frame.pose(along.middle(), behind.middle(), z.middle()), material);
}
}  // namespace explore::simulation

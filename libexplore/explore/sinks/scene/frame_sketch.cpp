#include <explore/sinks/camera_projection.h>
#include <explore/sinks/scene/frame_sketch.h>
#include <explore/sinks/scene/shapes.h>
#include <mrpt/core/format.h>
#include <mrpt/opengl/CCylinder.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace explore
{
namespace
{
constexpr double kMostPoints = 5000;

void insert(mrpt::opengl::CSetOfObjects& objects, const std::string& name, const mrpt::opengl::CRenderizable::Ptr& one)
{
	one->setName(name);
	objects.insert(one);
}

/** Every n-th row and column of the image, or every n-th point. */
PointCloud thinnedCloud(const DepthFrame& frame)
{
	const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
	PointCloud thinned;
	const auto add = [&](const Eigen::Vector3d& point_in_camera)
	{ thinned.push_back((robot_from_camera * point_in_camera).cast<float>()); };
	const CameraIntrinsics& camera = frame.image.intrinsics;
	const double pixels = frame.image.empty() ? 0.0 : double(camera.width_px) * camera.height_px;
	const int step_px = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMostPoints))));
	for (int v = 0; pixels > 0.0 && v < camera.height_px; v += step_px)
		for (int u = 0; u < camera.width_px; u += step_px)
			if (const double depth_m = frame.image.at(u, v); depth_m > 0.0) add(depth_m * rayOfPixel(camera, u, v));
	const PointCloud& points = frame.points_in_camera;
	const auto step = static_cast<std::size_t>(std::ceil(std::max(1.0, double(points.size()) / kMostPoints)));
	for (std::size_t i = 0; i < points.size(); i += step) add(points[i].cast<double>());
	return thinned;
}

/** Of a cloud, which has no pixels to ask, the whole reach. */
void addFloorLine(FrameSketch& sketch, const DepthFrame& frame, const Line& line, double reach_m)
{
	const auto at = [&](double along_m) -> Eigen::Vector3d { return line.point + along_m * line.direction; };
	if (frame.image.empty()) return void(sketch.floor_lines_in_robot.emplace_back(at(-reach_m), at(reach_m)));
	for (const auto& [from_m, to_m] : CameraProjection(frame).shownStretches(line, reach_m))
		sketch.floor_lines_in_robot.emplace_back(at(from_m), at(to_m));
}

mrpt::opengl::CSetOfObjects::Ptr vanishingPoint(const VanishingPoint& vanishing_point)
{
	constexpr double kArrow_m = 1.0, kRing_m = 0.12;
	auto object = mrpt::opengl::CSetOfObjects::Create();
	const Eigen::Vector3d& point = vanishing_point.point;
	object->insert(scene::arrow({point - kArrow_m * vanishing_point.direction, point}, style::kVanishingPoint, 0.04));
	object->insert(scene::ring(point, kRing_m, style::kVanishingPoint));
	object->insert(scene::label("VP", point + Eigen::Vector3d(0, 0, 0.25), style::kVanishingPoint));
	return object;
}

/** Its body as a cylinder, with an arrow ahead on top. */
mrpt::opengl::CSetOfObjects::Ptr robotBody(const RobotConfig& robot)
{
	constexpr int kSides = 24;
	const double bottom_m = robot.kind == RobotKind::mav ? -0.5 * robot.height_m : 0.0;
	const auto radius = static_cast<float>(robot.radius_m);
	auto body = mrpt::opengl::CCylinder::Create(radius, radius, static_cast<float>(robot.height_m), kSides);
	body->setLocation(0, 0, bottom_m);
	body->setColor_u8(style::kRobot);
	auto object = mrpt::opengl::CSetOfObjects::Create();
	object->insert(body);
	const Eigen::Vector3d top(0, 0, bottom_m + robot.height_m + 0.03);
	object->insert(
	    scene::arrow({top - Eigen::Vector3d(robot.radius_m, 0, 0), top + Eigen::Vector3d(robot.radius_m, 0, 0)},
	                 style::kPaper, 0.04));
	return object;
}
}  // namespace

FrameSketch sketchOf(const DepthFrame& frame, const StepResult& result, double max_range_m)
{
	FrameSketch sketch{frame.index, frame.map_from_robot, frame.pose_origin, thinnedCloud(frame), {}, {}};
	for (const Wall& wall : result.percepts.walls) addFloorLine(sketch, frame, wall.floor_line, 2.0 * max_range_m);
	const Percepts& percepts = result.percepts;
	sketch.result = {
	    {percepts.ground, percepts.walls, percepts.doors, percepts.vanishing_points, {}, percepts.near_field},
	    result.decision,
	    result.finished};
	return sketch;
}

mrpt::opengl::CSetOfObjects::Ptr directionObjects(const FrameSketch& sketch, const RobotConfig& robot)
{
	auto objects = mrpt::opengl::CSetOfObjects::Create();
	insert(*objects, "robot", robotBody(robot));
	for (const HeadingArrow& heading : headingArrows(sketch.result))
	{
		const Eigen::Vector3d above(0, 0, heading.kind == HeadingKind::chosen ? 0.12 : 0.08);
		insert(*objects, "heading." + std::string(nameOf(heading.kind)),
		       scene::arrow({heading.from_in_robot + above, heading.to_in_robot + above},
		                    style::headingColor(heading.kind), heading.kind == HeadingKind::chosen ? 0.08 : 0.05));
	}
	const auto& points = sketch.result.percepts.vanishing_points;
	for (std::size_t i = 0; i < points.size(); ++i)
		insert(*objects, "frame.vanishing_point." + std::to_string(i), vanishingPoint(points[i]));
	return objects;
}

mrpt::opengl::CSetOfObjects::Ptr frameObjects(const FrameSketch& sketch, const RobotConfig& robot)
{
	static const Eigen::Vector3d kBelow(0, 0, -0.5);  // where no door's label stands
	auto objects = directionObjects(sketch, robot);
	const Percepts& percepts = sketch.result.percepts;
	insert(*objects, "frame.cloud", scene::cloud(sketch.cloud_in_robot, 3.0));
	insert(*objects, "frame.floor_lines", scene::stretches(sketch.floor_lines_in_robot, style::kWall, 4.0));
	for (std::size_t i = 0; i < percepts.doors.size(); ++i)
	{
		const Door& door = percepts.doors[i];
		DoorMark mark = markOf(door, percepts.ground);
		mark.color = style::verdictColor(door.verdict);
		insert(*objects, "frame.door." + std::to_string(i), scene::opening(mark, door.verdict));
	}
	const std::string text = mrpt::format("frame %zu: ", sketch.index) + decisionText(sketch.result.decision);
	insert(*objects, "frame.text", scene::label(text, kBelow, style::kText));
	return objects;
}
}  // namespace explore

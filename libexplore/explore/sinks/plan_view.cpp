#include <explore/sinks/plan_view.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace explore
{
namespace
{
/** Floor coordinates (x ahead, y left, metres) to canvas pixels. */
class Plan
{
public:
	Plan(const CanvasArea& area, double max_range_m)
	    : m_center_px(0.5 * (area.left + area.right)),
	      m_scale((area.bottom - area.top) / (max_range_m + kBehind_m + kAhead_m)),
	      m_origin_row_px(area.bottom - kBehind_m * m_scale)
	{
	}
	[[nodiscard]] CanvasPoint at(double x_m, double y_m) const
	{
		return {m_center_px - y_m * m_scale, m_origin_row_px - x_m * m_scale};
	}
	[[nodiscard]] CanvasPoint at(const Eigen::Vector3d& point) const { return at(point.x(), point.y()); }
	[[nodiscard]] CanvasPoint polar(double heading_rad, double range_m) const
	{
		return at(range_m * std::cos(heading_rad), range_m * std::sin(heading_rad));
	}
	[[nodiscard]] double px(double length_m) const { return length_m * m_scale; }

private:
	static constexpr double kBehind_m = 0.6, kAhead_m = 0.3;
	double m_center_px, m_scale, m_origin_row_px;
};

void drawRangeRings(Canvas& canvas, const Plan& plan, double max_range_m)
{
	constexpr double kLabels_rad = -0.53;  // beside the field of view of a usual camera
	for (int range_m = 1; range_m <= static_cast<int>(max_range_m); ++range_m)
	{
		canvas.ring(plan.at(0, 0), plan.px(range_m), 1.0, {style::kGrid});
		canvas.text(plan.polar(kLabels_rad, range_m) + CanvasPoint(8, -4), mrpt::format("%d m", range_m), style::kGrid);
	}
}

void drawFieldOfView(Canvas& canvas, const Plan& plan, const DepthFrame& frame, double max_range_m)
{
	const auto& intrinsics = frame.image.intrinsics;
	if (frame.image.empty()) return;
	const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
	for (const double u_px : {0.0, intrinsics.width_px - 1.0})
	{
		const Eigen::Vector3d edge = robot_from_camera.linear() * rayOfPixel(intrinsics, u_px, intrinsics.cy_px);
		const Eigen::Vector3d start = robot_from_camera.translation();
		canvas.line(plan.at(start), plan.at(start + max_range_m * edge), 1.0, {style::kFaint, 0.5});
	}
}

void drawObstacles(Canvas& canvas, const Plan& plan, const Percepts& percepts)
{
	for (std::size_t i = 0; i < percepts.obstacles_in_robot.size(); ++i)
	{
		const Eigen::Vector3d point = percepts.obstacles_in_robot[i].cast<double>();
		const double height_m = percepts.ground ? percepts.ground->plane.signedDistance(point) : point.z();
		canvas.disc(plan.at(point), 1.3, {style::heightColor(height_m), 0.7});
	}
}

/** The stretches of a wall that obstacle points support, as bars along it. */
void drawWall(Canvas& canvas, const Plan& plan, const Wall& wall, const PointCloud& obstacles)
{
	constexpr double kAtWall_m = 0.08, kBin_m = 0.1;
	std::set<long> bins;
	for (std::size_t i = 0; i < obstacles.size(); ++i)
	{
		const Eigen::Vector3d point = obstacles[i].cast<double>();
		if (std::abs(wall.plane.signedDistance(point)) < kAtWall_m)
			bins.insert(std::lround((point - wall.floor_line.point).dot(wall.floor_line.direction) / kBin_m));
	}
	const auto end = [&](double bin)
	{ return plan.at(wall.floor_line.point + bin * kBin_m * wall.floor_line.direction); };
	for (const long bin : bins)
		if (bins.count(bin - 1) + bins.count(bin + 1) > 0)
			canvas.line(end(double(bin) - 0.5), end(double(bin) + 0.5), 3.0, {style::kWall});
}

void drawDoor(Canvas& canvas, const Plan& plan, const DoorMark& mark)
{
	const auto& corners = mark.corners_in_robot;
	const CanvasPoint a = plan.at(corners[0]), b = plan.at(corners[1]);
	canvas.line(a, b, 5.0, {mark.color});
	canvas.disc(a, 4.5, {mark.color});
	canvas.disc(b, 4.5, {mark.color});
	// The label stands behind the opening, where the wall's dots do not run.
	const CanvasPoint away = plan.at(corners[0] - mark.normal) - a;
	const CanvasPoint offset(away.x() * 1.5, away.y() * 0.7);
	canvas.label(0.5 * (a + b) + mark.label_height * offset, mark.label, {mark.color, 0.9});
}

void drawVanishingPoint(Canvas& canvas, const Plan& plan, const VanishingPoint& vanishing_point)
{
	const CanvasPoint at = plan.at(vanishing_point.point);
	canvas.ring(at, 8.0, 3.0, {style::kVanishingPoint});
	canvas.disc(at, 2.5, {style::kVanishingPoint});
	canvas.label(at + CanvasPoint(28, 0), "VP", {style::kVanishingPoint, 0.9});
}

/** The floor that the robot sweeps on its open path. */
void drawSweptCorridor(Canvas& canvas, const Plan& plan, const Decision& decision, double radius_m)
{
	if (!decision.headings.chosen_rad) return;
	const double heading_rad = *decision.headings.chosen_rad, length_m = decision.open_path_m + radius_m;
	const Eigen::Vector2d along(std::cos(heading_rad), std::sin(heading_rad)), across(-along.y(), along.x());
	const Eigen::Vector2d end = length_m * along, side = radius_m * across;
	const auto at = [&](const Eigen::Vector2d& p) { return plan.at(p.x(), p.y()); };
	canvas.convexPolygon(std::array<CanvasPoint, 4>{at(side), at(-side), at(end - side), at(end + side)},
	                     {style::kChosen, 0.16});
}

void drawHeadings(Canvas& canvas, const Plan& plan, const Decision& decision, const PictureConfig& config)
{
	const Headings& headings = decision.headings;
	const double reach_m = config.max_range_m;
	if (headings.desired_rad)
		canvas.dashedLine(plan.at(0, 0), plan.polar(*headings.desired_rad, 0.6 * reach_m), 1.5, {style::kDesired, 0.8});
	if (headings.vanishing_point_rad)
		canvas.arrow(plan.at(0, 0), plan.polar(*headings.vanishing_point_rad, 0.5 * reach_m), 3.0,
		             {style::kVanishingPoint});
	if (headings.door_rad)
		canvas.arrow(plan.at(0, 0), plan.polar(*headings.door_rad, 0.4 * reach_m), 3.5, {style::kDoorHeading});
	if (headings.chosen_rad)
		canvas.arrow(plan.at(0, 0), plan.polar(*headings.chosen_rad, 0.27 * reach_m), 6.0, {style::kChosen});
}

void drawRobot(Canvas& canvas, const Plan& plan, const RobotConfig& robot)
{
	canvas.disc(plan.at(0, 0), plan.px(robot.radius_m), {style::kRobot, 0.25});
	canvas.ring(plan.at(0, 0), plan.px(robot.radius_m), 2.0, {style::kRobot});
	canvas.line(plan.at(0, 0), plan.at(robot.radius_m, 0), 2.0, {style::kRobot});
}
}  // namespace

void drawPlanView(Canvas& canvas, const CanvasArea& area, const DepthFrame& frame, const StepResult& result,
                  const PictureConfig& config, const PictureNotes& notes)
{
	canvas.clipTo(area);
	const Plan plan(area, config.max_range_m);
	const Percepts& percepts = result.percepts;
	drawRangeRings(canvas, plan, config.max_range_m);
	drawFieldOfView(canvas, plan, frame, config.max_range_m);
	drawSweptCorridor(canvas, plan, result.decision, config.robot.radius_m);
	drawObstacles(canvas, plan, percepts);
	for (const Wall& wall : percepts.walls) drawWall(canvas, plan, wall, percepts.obstacles_in_robot);
	drawRobot(canvas, plan, config.robot);
	drawHeadings(canvas, plan, result.decision, config);
	for (const DoorMark& mark : notes.doors) drawDoor(canvas, plan, mark);
	for (const Door& door : percepts.doors) drawDoor(canvas, plan, markOf(door, percepts.ground));
	for (const auto& vanishing_point : percepts.vanishing_points) drawVanishingPoint(canvas, plan, vanishing_point);
}
}  // namespace explore

#include <explore/evaluation/cause_geometry.h>
#include <explore/evaluation/truth_marks.h>
#include <mrpt/core/format.h>

namespace explore::evaluation
{
namespace
{
const mrpt::img::TColor kWanted(64, 224, 208), kNeitherWay(167, 139, 250);

mrpt::img::TColor colorOf(const TruthDoor& door)
{
	if (countsNeitherWay(door)) return kNeitherWay;
	const bool wanted = isPositive(door) && door.visibility == Visibility::visible;
	return wanted ? kWanted : style::kFaint;
}

DoorMark markOf(const TruthDoor& door, const Eigen::Isometry3d& robot_from_map)
{
	constexpr double kUsualHeight_m = 2.0, kAboveTheReport = 0.8;
	const double floor_m = footOf(door).z(), top_m = floor_m + door.height_m.value_or(kUsualHeight_m);
	const auto jambs = jambsOf(door.center_in_map.head<2>(), door.normal_in_map.head<2>(), door.width_m);
	const auto corner = [&](const Eigen::Vector2d& jamb, double z_m) -> Eigen::Vector3d
	{ return robot_from_map * Eigen::Vector3d(jamb.x(), jamb.y(), z_m); };
	DoorMark mark;
	mark.corners_in_robot = {corner(jambs[0], floor_m), corner(jambs[1], floor_m), corner(jambs[1], top_m),
	                         corner(jambs[0], top_m)};
	mark.normal = robot_from_map.linear() * door.normal_in_map;
	mark.color = colorOf(door);
	mark.label = mrpt::format("true: %s %.2f m", std::string(nameOf(door.verdict)).c_str(), door.width_m);
	mark.label_height = kAboveTheReport;
	return mark;
}
}  // namespace

std::vector<DoorMark> truthMarks(const TruthFrame& truth, double max_range_m)
{
	const Eigen::Isometry3d robot_from_map = isometryOf(truth.map_from_robot).inverse();
	std::vector<DoorMark> marks;
	for (const TruthDoor& door : truth.doors)
		if ((robot_from_map * door.center_in_map).head<2>().norm() <= max_range_m + 1.0)
			marks.push_back(markOf(door, robot_from_map));
	return marks;
}
}  // namespace explore::evaluation

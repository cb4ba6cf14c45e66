#include <explore/sources/rawlog_info.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/system/datetime.h>

#include <iomanip>
#include <sstream>

namespace explore
{
namespace
{
/** For printing; adding 0 turns −0 into 0. */
double degreesOf(double angle_rad)
{
	return mrpt::RAD2DEG(angle_rad) + 0.0;
}

std::string layoutOf(const RawlogInfo& info)
{
	if (info.sensory_frames == 0) return "observations";
	return info.observations_alone == 0 ? "actions and sensory frames"
	                                    : "mixed: sensory frames and single observations";
}

std::string originsOf(const RawlogInfo& info)
{
	std::string text;
	for (const PoseOrigin origin : info.pose_origins) text += (text.empty() ? "" : ", ") + nameOf(origin);
	return text.empty() ? "none" : text;
}

void writeDepth(std::ostream& out, const SensorInfo& sensor)
{
	if (sensor.form.empty()) return;
	out << "    depth as:    " << sensor.form << '\n';
	if (const auto& camera = sensor.intrinsics)
		out << "    intrinsics:  " << camera->width_px << 'x' << camera->height_px << ", fx " << camera->fx_px
		    << ", fy " << camera->fy_px << ", cx " << camera->cx_px << ", cy " << camera->cy_px << '\n';
	if (const auto& pose = sensor.robot_from_sensor)
		out << "    sensor pose: x " << pose->x() << ", y " << pose->y() << ", z " << pose->z() << " m, yaw "
		    << degreesOf(pose->yaw()) << ", pitch " << degreesOf(pose->pitch()) << ", roll " << degreesOf(pose->roll())
		    << " deg\n";
}

void writeSensor(std::ostream& out, const SensorInfo& sensor)
{
	out << "  " << sensor.class_name << " '" << sensor.label << "': " << sensor.count;
	if (const auto rate_hz = sensor.rate_hz()) out << ", " << *rate_hz << " Hz";
	out << '\n';
	writeDepth(out, sensor);
}
}  // namespace

std::string textOf(const RawlogInfo& info)
{
	std::ostringstream out;
	out << std::setprecision(6);
	out << "file:          " << info.file_bytes << " bytes, " << (info.compressed ? "gzipped" : "plain") << '\n';
	out << "layout:        " << layoutOf(info) << '\n';
	out << "objects:       " << info.objects << '\n';
	if (info.first)
		out << "time:          " << std::fixed << std::setprecision(3) << secondsBetween(*info.first, *info.last)
		    << " s from " << mrpt::system::dateTimeToString(*info.first) << " (UTC)\n"
		    << std::defaultfloat << std::setprecision(6);
	out << "robot poses:   " << originsOf(info) << '\n';
	out << "accelerometer: " << (info.has_accelerometer ? "yes" : "no") << '\n';
	out << "observations:\n";
	for (const SensorInfo& sensor : info.sensors) writeSensor(out, sensor);
	for (const std::string& name : info.other_classes) out << "other entries: " << name << '\n';
	if (info.damage)
		out << "damage:        " << info.damage->what << "; lost: " << info.damage->lost_bytes << " bytes, "
		    << info.damage->lost_objects << " objects\n";
	else
		out << "damage:        none\n";
	return out.str();
}
}  // namespace explore

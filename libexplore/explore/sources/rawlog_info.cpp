#include "rawlog_info.h"

#include <explore/core/errors.h>
#include <explore/sources/depth_conversion.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace explore
{
namespace
{
using mrpt::obs::CObservation;
using mrpt::obs::CObservation3DRangeScan;

class Collector
{
public:
	void take(const mrpt::serialization::CSerializable::Ptr& object)
	{
		if (const auto observation = std::dynamic_pointer_cast<CObservation>(object))
		{
			++m_info.observations_alone;
			observe(*observation);
		}
		else if (const auto sensory_frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
		{
			++m_info.sensory_frames;
			for (const auto& part : *sensory_frame)
				if (part) observe(*part);
		}
		else
			takeOther(*object);
	}

	RawlogInfo finish()
	{
		for (auto& [key, sensor] : m_sensors) m_info.sensors.push_back(std::move(sensor));
		m_info.other_classes.assign(m_others.begin(), m_others.end());
		m_info.pose_origins.assign(m_origins.begin(), m_origins.end());
		return std::move(m_info);
	}

private:
	void takeOther(const mrpt::serialization::CSerializable& object)
	{
		m_others.insert(object.GetRuntimeClass()->className);
		mrpt::poses::CPose3D increment;
		const auto* action = dynamic_cast<const mrpt::obs::CActionCollection*>(&object);
		if (action != nullptr && action->getFirstMovementEstimationMean(increment))
			m_origins.insert(PoseOrigin::action);
	}

	void observe(const CObservation& observation)
	{
		const std::string class_name = observation.GetRuntimeClass()->className;
		SensorInfo& sensor = m_sensors[{class_name, observation.sensorLabel}];
		if (sensor.count++ == 0) describeFirst(observation, class_name, sensor);
		if (isUsable(observation.timestamp))
		{
			extend(sensor.first, sensor.last, observation.timestamp);
			extend(m_info.first, m_info.last, observation.timestamp);
		}
		if (dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&observation) != nullptr)
			m_origins.insert(PoseOrigin::robot_pose);
		if (dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation) != nullptr)
			m_origins.insert(PoseOrigin::odometry);
		const auto* imu = dynamic_cast<const mrpt::obs::CObservationIMU*>(&observation);
		if (imu != nullptr && imu->has(mrpt::obs::IMU_X_ACC)) m_info.has_accelerometer = true;
	}

	static void extend(std::optional<LogTime>& first, std::optional<LogTime>& last, LogTime time)
	{
		first = std::min(first.value_or(time), time);
		last = std::max(last.value_or(time), time);
	}

	static void describeFirst(const CObservation& observation, const std::string& class_name, SensorInfo& sensor)
	{
		sensor.class_name = class_name;
		sensor.label = observation.sensorLabel;
		mrpt::poses::CPose3D robot_from_sensor;
		observation.getSensorPose(robot_from_sensor);
		sensor.robot_from_sensor = robot_from_sensor;
		if (isDepthObservation(observation)) sensor.form = "points";
		const auto* scan = dynamic_cast<const CObservation3DRangeScan*>(&observation);
		if (scan == nullptr) return;
		sensor.form = formOf(*scan);
		const auto& camera = scan->cameraParams;
		sensor.intrinsics = CameraIntrinsics{static_cast<int>(camera.ncols),
		                                     static_cast<int>(camera.nrows),
		                                     camera.fx(),
		                                     camera.fy(),
		                                     camera.cx(),
		                                     camera.cy()};
	}

	static std::string formOf(const CObservation3DRangeScan& scan)
	{
		if (!scan.hasRangeImage) return scan.hasPoints3D ? "points" : "no depth";
		const std::string kind = scan.range_is_depth ? "depth image" : "range image";
		return kind + (scan.rangeImage_isExternallyStored() ? " in files of its own" : "");
	}

	RawlogInfo m_info;
	std::map<std::pair<std::string, std::string>, SensorInfo> m_sensors;
	std::set<std::string> m_others;
	std::set<PoseOrigin> m_origins;
};
std::string listOf(const std::vector<std::string>& names)
{
	std::string text;
	for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
	return text.empty() ? "nothing" : text;
}
}  // namespace

std::optional<double> SensorInfo::rate_hz() const
{
	if (count < 2 || !first || !last || *last <= *first) return std::nullopt;
	return static_cast<double>(count - 1) / secondsBetween(*first, *last);
}

RawlogInfo describeRawlog(const std::filesystem::path& path)
{
	RawlogReader reader(path);
	Collector collector;
	while (const auto object = reader.next()) collector.take(object);
	RawlogInfo info = collector.finish();
	if (info.observations_alone == 0 && info.sensory_frames == 0 && !reader.damage())
		throw InputError(path.string() + ": holds no observation but " + listOf(info.other_classes) +
		                 "; a rawlog is needed");
	info.compressed = reader.compressed();
	info.file_bytes = reader.fileSize();
	info.objects = reader.objects();
	info.damage = reader.damage();
	return info;
}
}  // namespace explore

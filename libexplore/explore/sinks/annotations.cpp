#include <explore/core/depth_counts.h>
#include <explore/sinks/annotations.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservation3DScene.h>
#include <mrpt/obs/CObservation6DFeatures.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <algorithm>
#include <memory>
#include <string>

namespace explore
{
namespace
{
template <class Observation>
std::shared_ptr<Observation> observationOf(const DepthFrame& frame, const std::string& label)
{
	auto observation = std::make_shared<Observation>();
	observation->timestamp = frame.timestamp;
	observation->sensorLabel = label;
	return observation;
}

mrpt::obs::CObservation::Ptr sceneOf(const DepthFrame& frame, const FrameSketch& sketch, const RobotConfig& robot)
{
	auto observation = observationOf<mrpt::obs::CObservation3DScene>(frame, "explore.scene");
	observation->scene = mrpt::opengl::COpenGLScene::Create();
	auto objects = frameObjects(sketch, robot);
	objects->setName("last_frame");
	observation->scene->insert(objects);
	return observation;
}

mrpt::poses::CPose3D poseOf(const Door& door, const Eigen::Vector3d& up)
{
	Eigen::Matrix3d axes;
	const Eigen::Vector3d across = up.cross(door.normal).normalized();
	axes << door.normal, across, door.normal.cross(across);
	return {mrpt::math::CMatrixDouble33(axes), mrpt::math::TPoint3D(door.center.x(), door.center.y(), door.center.z())};
}

mrpt::obs::CObservation::Ptr doorsOf(const DepthFrame& frame, const Percepts& percepts)
{
	auto observation = observationOf<mrpt::obs::CObservation6DFeatures>(frame, "explore.doors");
	observation->sensorPose = frame.robot_from_camera;
	const Eigen::Vector3d up = percepts.ground ? percepts.ground->plane.normal : Eigen::Vector3d::UnitZ();
	for (const Door& door : percepts.doors)
	{
		mrpt::obs::CObservation6DFeatures::TMeasurement measurement;
		measurement.pose = poseOf(door, up) - frame.robot_from_camera;
		if (door.track) measurement.id = *door.track;
		observation->sensedFeatures.push_back(measurement);
	}
	return observation;
}

mrpt::obs::CObservation::Ptr headingsOf(const DepthFrame& frame, const Decision& decision)
{
	auto observation = observationOf<mrpt::obs::CObservationBearingRange>(frame, "explore.headings");
	const auto add = [&](HeadingId id, const std::optional<double>& heading_rad, double range_m, double pitch_rad)
	{
		if (!heading_rad) return;
		mrpt::obs::CObservationBearingRange::TMeasurement measurement{};
		measurement.range = static_cast<float>(range_m);
		measurement.yaw = static_cast<float>(*heading_rad);
		measurement.pitch = static_cast<float>(pitch_rad);
		measurement.landmarkID = static_cast<std::int32_t>(id);
		observation->sensedData.push_back(measurement);
	};
	const Headings& headings = decision.headings;
	add(HeadingId::door, headings.door_rad, 1.0, 0.0);
	add(HeadingId::vanishing_point, headings.vanishing_point_rad, 1.0, 0.0);
	add(HeadingId::avoid, headings.avoid_rad, 1.0, 0.0);
	add(HeadingId::desired, headings.desired_rad, 1.0, 0.0);
	add(HeadingId::chosen, headings.chosen_rad, decision.open_path_m, -headings.chosen_elevation_rad);
	return observation;
}
}  // namespace

std::vector<mrpt::obs::CObservation::Ptr> annotationsOf(const DepthFrame& frame, const FrameSketch& sketch,
                                                        const RobotConfig& robot)
{
	std::vector<mrpt::obs::CObservation::Ptr> observations{sceneOf(frame, sketch, robot),
	                                                       doorsOf(frame, sketch.result.percepts),
	                                                       headingsOf(frame, sketch.result.decision)};
	if (frame.pose_origin == PoseOrigin::none) return observations;
	auto pose = observationOf<mrpt::obs::CObservationRobotPose>(frame, "explore.pose");
	pose->pose.mean = frame.map_from_robot;
	observations.push_back(pose);
	return observations;
}

mrpt::obs::CObservation::Ptr depthObservationOf(const DepthFrame& frame)
{
	if (frame.image.empty()) return nullptr;
	const CameraIntrinsics& camera = frame.image.intrinsics;
	auto scan = observationOf<mrpt::obs::CObservation3DRangeScan>(frame, frame.sensor_label);
	scan->sensorPose = frame.robot_from_camera;
	scan->cameraParams.ncols = static_cast<std::uint32_t>(camera.width_px);
	scan->cameraParams.nrows = static_cast<std::uint32_t>(camera.height_px);
	scan->cameraParams.setIntrinsicParamsFromValues(camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px);
	scan->hasRangeImage = true;
	scan->range_is_depth = true;
	scan->rangeUnits = static_cast<float>(1.0 / kDepthCountsPerMetre);
	scan->maxRange = *std::ranges::max_element(frame.image.depth_m);
	scan->rangeImage_setSize(camera.height_px, camera.width_px);
	for (int v = 0; v < camera.height_px; ++v)
		for (int u = 0; u < camera.width_px; ++u) scan->rangeImage(v, u) = depthCountsOf(frame.image.at(u, v));
	return scan;
}
}  // namespace explore

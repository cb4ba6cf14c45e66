// Makes a rawlog of a recording that consists of depth images and poses.
#pragma once

#include <explore/sources/image_folders.h>
#include <explore/sources/rawlog_writer.h>

#include <string>
#include <vector>

namespace explore
{
struct ImportConfig
{
	double fx_px = 525.0, fy_px = 525.0, cx_px = 319.5, cy_px = 239.5;
	double depth_scale_m = 0.001;  ///< metres a count
	std::string sensor_label = "DEPTH";
	mrpt::poses::CPose3D robot_from_camera;
};

struct Recording
{
	std::vector<TimedFile> frames;
	std::vector<TimedPose> map_from_robot;  ///< may be empty; in any order
};

/** map_from_robot of poses that place the optical frame of the camera in the map, as TUM's groundtruth.txt does. */
std::vector<TimedPose> robotPosesOfOptical(const std::vector<TimedPose>& map_from_optical,
                                           const mrpt::poses::CPose3D& robot_from_camera);

/** One CObservation3DRangeScan a frame and one CObservationRobotPose a pose, by time. Throws InputError for an image
 * that cannot be read, differs in size from the first, or does not contain the principal point; OutputError from
 * `writer`, which is left open. */
void importRecording(const Recording& recording, const ImportConfig& config, RawlogWriter& writer);
}  // namespace explore

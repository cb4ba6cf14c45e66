// What annotated.rawlog says about a frame, in MRPT's own observations.
#pragma once

#include <explore/sinks/scene/frame_sketch.h>
#include <mrpt/obs/CObservation.h>

#include <vector>

namespace explore
{
/** landmarkID of the bearings in "explore.headings". */
enum class HeadingId : std::int32_t
{
	door = 0,
	vanishing_point = 1,
	avoid = 2,
	desired = 3,
	chosen = 4
};

/** All with the frame's timestamp:
 *  - CObservation3DScene with frameObjects(), robot frame.
 *  - CObservation6DFeatures "explore.doors": the doors of the frame in their order, relative to the camera; x is the
 *    normal of the wall toward the robot, z is up; id = track, INVALID_LANDMARK_ID without one.
 *  - CObservationBearingRange "explore.headings": those headings that there are, yaw in the robot frame [rad]; range is
 *    the open path for the chosen one [m], else 1; pitch is minus the chosen elevation.
 *  - CObservationRobotPose "explore.pose": map_from_robot; left out where nobody knows it. */
std::vector<mrpt::obs::CObservation::Ptr> annotationsOf(const DepthFrame& frame, const FrameSketch& sketch,
                                                        const RobotConfig& robot);

/** The frame's depth image as CObservation3DRangeScan, in millimetres; null without an image. */
mrpt::obs::CObservation::Ptr depthObservationOf(const DepthFrame& frame);
}  // namespace explore

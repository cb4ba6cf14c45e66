// The camera's mount (height, pitch, roll) from the floor it sees, and whether the recorded mount agrees.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/perception/perception_config.h>

#include <optional>
#include <span>
#include <string>

namespace explore
{
struct MountEstimate
{
	double height_m = 0;                 ///< of the camera above the floor
	double pitch_rad = 0, roll_rad = 0;  ///< of robot_from_camera (positive pitch looks down)
	std::size_t frames = 0;              ///< that showed a floor
};

/** Median over `frames` of the mount that the lowest dominant plane within ±60° of level implies; no value when no
 * frame shows one. The recorded robot_from_camera is not used. */
std::optional<MountEstimate> estimateMount(std::span<const DepthFrame> frames, const PerceptionConfig& config);

/** One sentence for the user when the floor is not where robot_from_camera says (more than 15° or 0.15 m off; height is
 * not judged for an identity pose, which says nothing), else no value. */
std::optional<std::string> mountRemark(std::span<const DepthFrame> frames, const PerceptionConfig& config);
}  // namespace explore

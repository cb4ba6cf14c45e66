// The last floor that was seen, carried on with growing uncertainty while none is in view (remedy 9).
#pragma once

#include <explore/config/fields.h>
#include <explore/core/depth_frame.h>
#include <explore/core/geometry.h>
#include <explore/core/robot.h>

#include <optional>

namespace explore
{
struct GroundMemoryConfig
{
	double max_age_s = 8.0;  ///< older floors are forgotten
};
void describe(FieldVisitor& fields, GroundMemoryConfig& config);

/** A floor and how far it may be from the truth. */
struct UncertainGround
{
	Plane plane;  ///< normal up
	double tilt_sigma_rad = 0;
	double height_sigma_m = 0;
};

/** Nothing at first. */
struct GroundMemory
{
	std::optional<UncertainGround> ground_in_map;  ///< as of `timestamp`
	mrpt::poses::CPose3D map_from_robot;
	PoseOrigin pose_origin = PoseOrigin::none;
	mrpt::Clock::time_point timestamp;
};

/** What to remember after `frame` showed the floor `ground_in_robot`. */
GroundMemory remember(const DepthFrame& frame, const UncertainGround& ground_in_robot);

/** The remembered floor in the robot frame of `frame`. Its uncertainty grows with the time, and with the way and the
 *  turn between both poses; where no pose tells them, with what such a robot may have done. No value without a memory,
 *  when time ran backwards, or when it is too old. */
std::optional<UncertainGround> recall(const GroundMemory& memory, const DepthFrame& frame, const RobotConfig& robot,
                                      const GroundMemoryConfig& config);
}  // namespace explore

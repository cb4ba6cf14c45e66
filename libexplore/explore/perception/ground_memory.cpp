#include <explore/core/geometry.h>
#include <explore/perception/ground_memory.h>

#include <cmath>

namespace explore
{
namespace
{
/** Does the pose tell roll, pitch and height, as a flying robot needs? */
bool tellsAttitude(PoseOrigin origin, const mrpt::poses::CPose3D& map_from_robot)
{
	if (origin == PoseOrigin::none) return false;
	return isPoseInSpace(origin) || map_from_robot.roll() != 0.0 || map_from_robot.pitch() != 0.0;
}

struct Motion
{
	double seconds = 0, metres = 0, radians = 0;
};

/** Growth of the uncertainty where the poses tell the motion: floors are flat to a degree or so, odometry slips. */
void growWithMotion(UncertainGround& ground, const Motion& motion)
{
	ground.tilt_sigma_rad +=
	    0.3 * kDegree_rad * motion.metres + 0.01 * motion.radians + 0.05 * kDegree_rad * std::sqrt(motion.seconds);
	ground.height_sigma_m += 0.02 * motion.metres + 0.002 * motion.seconds;
}

/** Growth without poses: a ground robot keeps its attitude to the floor, a flying one does as it likes. */
void growBlindly(UncertainGround& ground, double seconds, const RobotConfig& robot)
{
	const bool flies = robot.kind == RobotKind::mav;
	ground.tilt_sigma_rad += (flies ? 10.0 : 0.5) * kDegree_rad * seconds;
	ground.height_sigma_m += (flies ? 0.5 * robot.max_speed_mps : 0.01) * seconds;
}

Plane transformed(const Plane& plane, const Eigen::Isometry3d& to_from_plane)
{
	const Eigen::Vector3d normal = to_from_plane.linear() * plane.normal;
	return {normal, plane.d_m - normal.dot(to_from_plane.translation())};
}
}  // namespace

void describe(FieldVisitor& fields, GroundMemoryConfig& config)
{
	fields.real("ground_memory", config.max_age_s, {0.0, 3600.0}, "s",
	            "A floor that is out of view is remembered this long.");
}

GroundMemory remember(const DepthFrame& frame, const UncertainGround& ground_in_robot)
{
	UncertainGround ground = ground_in_robot;
	ground.plane = transformed(ground.plane, isometryOf(frame.map_from_robot));
	return {ground, frame.map_from_robot, frame.pose_origin, frame.timestamp};
}

std::optional<UncertainGround> recall(const GroundMemory& memory, const DepthFrame& frame, const RobotConfig& robot,
                                      const GroundMemoryConfig& config)
{
	if (!memory.ground_in_map || memory.pose_origin != frame.pose_origin) return std::nullopt;
	const double seconds = mrpt::Clock::toDouble(frame.timestamp) - mrpt::Clock::toDouble(memory.timestamp);
	if (!(seconds >= 0.0 && seconds <= config.max_age_s)) return std::nullopt;

	UncertainGround ground = *memory.ground_in_map;
	const Eigen::Isometry3d map_from_robot = isometryOf(frame.map_from_robot);
	const Eigen::Isometry3d then_from_now = isometryOf(memory.map_from_robot).inverse() * map_from_robot;
	const bool poses_tell = robot.kind == RobotKind::ground ? frame.pose_origin != PoseOrigin::none
	                                                        : tellsAttitude(frame.pose_origin, frame.map_from_robot);
	if (poses_tell)
		growWithMotion(
		    ground, {seconds, then_from_now.translation().norm(), Eigen::AngleAxisd(then_from_now.linear()).angle()});
	else
		growBlindly(ground, seconds, robot);
	ground.plane = transformed(ground.plane, map_from_robot.inverse());
	return ground;
}
}  // namespace explore

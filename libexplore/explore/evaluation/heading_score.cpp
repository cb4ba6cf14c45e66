#include <explore/core/geometry.h>
#include <explore/evaluation/heading_score.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore::evaluation
{
namespace
{
constexpr double kCap_m = 5.0, kGoodShare = 0.9;

/** Azimuths and elevations that the camera sees, in the level frame of the robot's heading. */
struct FieldOfView
{
	double right_rad, left_rad, low_rad, high_rad;
};

FieldOfView fieldOfView(const HeadingTruth& truth)
{
	const Eigen::Matrix3d level_from_camera = Eigen::AngleAxisd(-truth.map_from_robot.yaw(), Eigen::Vector3d::UnitZ()) *
	                                          isometryOf(truth.map_from_robot).linear() *
	                                          isometryOf(truth.robot_from_camera).linear();
	const CameraIntrinsics& camera = truth.intrinsics;
	const auto ray = [&](double u_px, double v_px) -> Eigen::Vector3d
	{ return level_from_camera * rayOfPixel(camera, u_px, v_px); };
	const auto elevation = [&](double v_px)
	{
		const Eigen::Vector3d direction = ray(camera.cx_px, v_px);
		return std::atan2(direction.z(), direction.head<2>().norm());
	};
	return {azimuthOf(ray(camera.width_px - 1.0, camera.cy_px)), azimuthOf(ray(0.0, camera.cy_px)),
	        elevation(camera.height_px - 1.0), elevation(0.0)};
}

std::size_t nearestElevation(const TruthFreePaths& paths, double elevation_rad)
{
	const auto distance = [&](double candidate_rad) { return std::abs(candidate_rad - elevation_rad); };
	const auto nearest = std::ranges::min_element(paths.elevations_rad, {}, distance);
	return static_cast<std::size_t>(nearest - paths.elevations_rad.begin());
}

double freePath(const TruthFreePaths& paths, std::size_t elevation, double azimuth_rad)
{
	const auto degree = static_cast<int>(std::lround(azimuth_rad / kDegree_rad));
	const int azimuth = ((degree % TruthFreePaths::kAzimuths) + TruthFreePaths::kAzimuths) % TruthFreePaths::kAzimuths;
	return paths.free_m[elevation * TruthFreePaths::kAzimuths + static_cast<std::size_t>(azimuth)];
}

double score(double free_m, double azimuth_rad, double elevation_rad, double desired_rad)
{
	return std::min(free_m, kCap_m) * std::cos(azimuth_rad - desired_rad) * std::cos(elevation_rad);
}

/** Calls visit(azimuth, elevation's index) for each whole degree and elevation in view; straight ahead where the field
 *  of view holds no elevation. */
template <class Visit>
void eachDirection(const TruthFreePaths& paths, const FieldOfView& view, const Visit& visit)
{
	const double width_rad = std::fmod(view.left_rad - view.right_rad + 2 * std::numbers::pi, 2 * std::numbers::pi);
	const double first_rad = std::ceil(view.right_rad / kDegree_rad) * kDegree_rad;
	const std::size_t level = nearestElevation(paths, 0.0);
	for (double azimuth_rad = first_rad; azimuth_rad <= view.right_rad + width_rad; azimuth_rad += kDegree_rad)
		for (std::size_t i = 0; i < paths.elevations_rad.size(); ++i)
			if (i == level || (paths.elevations_rad[i] >= view.low_rad && paths.elevations_rad[i] <= view.high_rad))
				visit(azimuth_rad, i);
}
}  // namespace

HeadingScore scoreHeading(const Decision& decision, const HeadingTruth& truth, const RobotConfig& robot,
                          const HeadingConfig& config)
{
	const TruthFreePaths& paths = truth.paths;
	const Headings& headings = decision.headings;
	const double desired_rad = headings.desired_rad.value_or(0.0);
	HeadingScore result;
	double longest_m = 0.0;
	eachDirection(paths, fieldOfView(truth),
	              [&](double azimuth_rad, std::size_t i)
	              {
		              const double free_m = freePath(paths, i, azimuth_rad);
		              longest_m = std::max(longest_m, free_m);
		              result.best =
		                  std::max(result.best, score(free_m, azimuth_rad, paths.elevations_rad[i], desired_rad));
	              });
	if (decision.stop || !headings.chosen_rad)
	{
		result.good = longest_m <= stoppingDistance(robot.max_speed_mps, robot, config);
		return result;
	}
	const std::size_t elevation = nearestElevation(paths, headings.chosen_elevation_rad);
	const double free_m = freePath(paths, elevation, *headings.chosen_rad);
	result.chosen = score(free_m, *headings.chosen_rad, paths.elevations_rad[elevation], desired_rad);
	result.good = *result.chosen > 0.0 && *result.chosen >= kGoodShare * result.best;
	result.collision = free_m < stoppingDistance(decision.command.velocity_mps.norm(), robot, config);
	return result;
}
}  // namespace explore::evaluation

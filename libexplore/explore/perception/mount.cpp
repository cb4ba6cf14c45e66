#include <explore/core/geometry.h>
#include <explore/perception/mount.h>
#include <explore/perception/perceive.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

namespace explore
{
namespace
{
constexpr double kWidestTilt_rad = std::numbers::pi / 4;
constexpr double kTiltDisagreement_rad = 15 * kDegree_rad;  // what the ground search tolerates (paper §3.1)
constexpr double kHeightDisagreement_m = 0.15;

/** The floor in the camera frame, whatever mount was recorded. */
std::optional<Plane> floorInCamera(DepthFrame frame, const PerceptionConfig& config)
{
	frame.robot_from_camera = mrpt::poses::CPose3D::Identity();
	const PointCloud points_in_camera = filteredVoxels(frame, config.range_filter, config.voxel_grid);
	RandomEngine random(static_cast<RandomEngine::result_type>(config.seed));
	const auto floor = findGround(points_in_camera, {}, {kWidestTilt_rad}, config.planes, random);
	return floor ? std::optional(floor->plane) : std::nullopt;
}

double median(std::vector<double> values)
{
	const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
	std::ranges::nth_element(values, middle);
	return *middle;
}

/** The vertical of the robot frame as a robot_from_camera with this pitch and roll sees it. */
Eigen::Vector3d upInCamera(double pitch_rad, double roll_rad)
{
	return {-std::sin(pitch_rad), std::cos(pitch_rad) * std::sin(roll_rad), std::cos(pitch_rad) * std::cos(roll_rad)};
}

std::string sentence(const MountEstimate& seen, const mrpt::poses::CPose3D& recorded)
{
	std::ostringstream text;
	text.precision(2);
	text << std::fixed << "the floor is not where the camera's pose says: seen " << seen.height_m
	     << " m below the camera, pitch " << mrpt::RAD2DEG(seen.pitch_rad) << " deg, roll "
	     << mrpt::RAD2DEG(seen.roll_rad) << " deg; recorded height " << recorded.z() << " m, pitch "
	     << mrpt::RAD2DEG(recorded.pitch()) << " deg, roll " << mrpt::RAD2DEG(recorded.roll())
	     << " deg. Set [camera] mount = estimate, or mount = ini with pose_z, pose_pitch, pose_roll, or --sensors-pose";
	return text.str();
}
}  // namespace

std::optional<MountEstimate> estimateMount(std::span<const DepthFrame> frames, const PerceptionConfig& config)
{
	std::vector<double> heights_m, pitches_rad, rolls_rad;
	for (const DepthFrame& frame : frames)
	{
		const auto floor = floorInCamera(frame, config);
		if (!floor) continue;
		heights_m.push_back(floor->d_m);
		pitches_rad.push_back(std::asin(std::clamp(-floor->normal.x(), -1.0, 1.0)));
		rolls_rad.push_back(std::atan2(floor->normal.y(), floor->normal.z()));
	}
	if (heights_m.empty()) return std::nullopt;
	return MountEstimate{median(heights_m), median(pitches_rad), median(rolls_rad), heights_m.size()};
}

std::optional<std::string> mountRemark(std::span<const DepthFrame> frames, const PerceptionConfig& config)
{
	if (frames.empty()) return std::nullopt;
	const auto seen = estimateMount(frames, config);
	if (!seen)
		return "no floor found in the first " + std::to_string(frames.size()) +
		       " frames, and doors and vanishing points need it: is the camera tilted by more than 45 deg?";
	const mrpt::poses::CPose3D& recorded = frames.front().robot_from_camera;
	const Eigen::Vector3d recorded_up = isometryOf(recorded).linear().transpose() * Eigen::Vector3d::UnitZ();
	const double tilt_rad =
	    std::acos(std::clamp(recorded_up.dot(upInCamera(seen->pitch_rad, seen->roll_rad)), -1.0, 1.0));
	const bool height_known = !(recorded == mrpt::poses::CPose3D::Identity());
	const bool height_differs = height_known && std::abs(seen->height_m - recorded.z()) > kHeightDisagreement_m;
	if (tilt_rad <= kTiltDisagreement_rad && !height_differs) return std::nullopt;
	return sentence(*seen, recorded);
}
}  // namespace explore

#include <explore/core/geometry.h>
#include <explore/perception/level_view.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kPaperTilt = 15 * kDegree_rad;
constexpr double kFlightMargin_m = 0.35;  // cameras sit above or below the body's centre, and MAVs overshoot

struct Mount
{
	Eigen::Isometry3d robot_from_camera;
	bool tells_height = false;  ///< an identity mount says nothing
};

Mount mountOf(const DepthFrame& frame)
{
	const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
	return {robot_from_camera, !robot_from_camera.isApprox(Eigen::Isometry3d::Identity(), 1e-9)};
}

/** The height in the map where a flying robot's pose tells it: most flights begin on the floor, so that maps have
 *  theirs at 0. No value outside the flight band, where it cannot be that. */
std::optional<double> heightInMap_m(const DepthFrame& frame, const Mount& mount, const CameraHeight& band)
{
	if (!isPoseInSpace(frame.pose_origin)) return std::nullopt;
	const double height_m = (isometryOf(frame.map_from_robot) * mount.robot_from_camera.translation()).z();
	if (height_m < band.min_m || height_m > band.max_m) return std::nullopt;
	return height_m;
}

CameraHeight heightPrior(const DepthFrame& frame, const Mount& mount, const Eigen::Vector3d& up_in_robot,
                         const RobotConfig& robot, const std::optional<UncertainGround>& remembered,
                         const FloorConfig& config)
{
	const Eigen::Vector3d camera_in_robot = mount.robot_from_camera.translation();
	CameraHeight height;
	height.tolerance_m = config.height_tolerance_m;
	const bool flies = robot.kind == RobotKind::mav;
	if (flies)
	{
		const double above_body = up_in_robot.dot(camera_in_robot);
		height.min_m = std::max(0.1, robot.min_altitude_m + above_body - kFlightMargin_m);
		height.max_m = robot.max_altitude_m + above_body + kFlightMargin_m;
	}
	if (!flies && mount.tells_height)
		height.expected_m = up_in_robot.dot(camera_in_robot);
	else if (remembered && 2.0 * remembered->height_sigma_m < config.height_tolerance_m)
		height.expected_m = remembered->plane.signedDistance(camera_in_robot);
	else if (flies)
		height.expected_m = heightInMap_m(frame, mount, height);
	return height;
}

/** Axes of the level frame for `up`: x is the optical axis laid flat; the image's upward direction for a camera that
 *  looks straight down. */
Eigen::Matrix3d levelAxes(const Eigen::Vector3d& up_in_camera)
{
	const auto laid = [&](const Eigen::Vector3d& axis)
	{ return Eigen::Vector3d(axis - axis.dot(up_in_camera) * up_in_camera); };
	Eigen::Vector3d forward = laid(Eigen::Vector3d::UnitX());
	if (forward.norm() < 1e-3) forward = laid(-up_in_camera.x() * Eigen::Vector3d::UnitZ());
	forward.normalize();
	Eigen::Matrix3d level_from_camera;
	level_from_camera << forward.transpose(), up_in_camera.cross(forward).transpose(), up_in_camera.transpose();
	return level_from_camera;
}

void setFloor(LevelPose& pose, const Plane& plane_in_camera, const Mount& mount)
{
	pose.level_from_camera.linear() = levelAxes(plane_in_camera.normal);
	pose.level_from_camera.translation() = plane_in_camera.d_m * Eigen::Vector3d::UnitZ();
	pose.robot_from_level = mount.robot_from_camera * pose.level_from_camera.inverse();
}

/** Camera height such that all but one in two hundred samples lie above the floor. */
double lowestSeen_m(const SampleGrid& grid, const Eigen::Vector3d& up_in_camera)
{
	const Eigen::Vector3f up = up_in_camera.cast<float>();
	std::vector<float> below;
	below.reserve(grid.size());
	std::size_t i = 0;
	for (const float ray_z : grid.ray_z)
		for (const float ray_y : grid.ray_y)
			if (const float depth = grid.depth_m[i++]; depth > 0.0F)
				below.push_back(-depth * (up.x() + up.y() * ray_y + up.z() * ray_z));
	if (below.empty()) return 0.0;
	const auto kth = below.begin() + static_cast<std::ptrdiff_t>(below.size() - 1 - below.size() / 200);
	std::nth_element(below.begin(), kth, below.end());
	return static_cast<double>(*kth);
}

/** The pose without a floor in view. */
void setUnseen(LevelPose& pose, const Mount& mount, const RobotConfig& robot, const CameraHeight& height,
               const std::optional<UncertainGround>& remembered, const UpPrior& up, const SampleGrid& grid)
{
	const double lowest_m = lowestSeen_m(grid, up.up);
	double height_m = 0;
	pose.tilt_sigma_rad = up.sigma_rad;
	if (robot.kind == RobotKind::ground && mount.tells_height)
	{
		pose.floor = FloorOrigin::mount;
		pose.height_sigma_m = 0.03;
		height_m = *height.expected_m;
	}
	else if (remembered)
	{
		pose.floor = FloorOrigin::remembered;
		pose.height_sigma_m = remembered->height_sigma_m;
		height_m = remembered->plane.signedDistance(mount.robot_from_camera.translation());
	}
	else
	{
		// the height in the map, else the middle of what flight band and view leave
		const double low = std::clamp(lowest_m, height.min_m, height.max_m);
		pose.floor = FloorOrigin::guessed;
		height_m = std::max(height.expected_m.value_or(0.5 * (low + height.max_m)), low);
	}
	setFloor(pose, {up.up, std::max(height_m, 0.05)}, mount);
}

LevelSamples levelSamplesOf(const SampleGrid& grid, const Eigen::Isometry3d& level_from_camera)
{
	LevelSamples samples;
	samples.stride = grid.stride;
	for (auto* values : {&samples.x, &samples.y, &samples.z, &samples.depth_m}) values->reserve(grid.size());
	samples.u.reserve(grid.size());
	samples.v.reserve(grid.size());
	const Eigen::Matrix3f turn = level_from_camera.linear().cast<float>();
	const auto height = static_cast<float>(level_from_camera.translation().z());
	std::size_t i = 0;
	for (int row = 0; row < grid.rows; ++row)
	{
		const Eigen::Vector3f start = turn.col(0) + grid.ray_z[static_cast<std::size_t>(row)] * turn.col(2);
		for (int column = 0; column < grid.columns; ++column)
		{
			const float depth = grid.depth_m[i++];
			if (!(depth > 0.0F)) continue;
			const Eigen::Vector3f point = depth * (start + grid.ray_y[static_cast<std::size_t>(column)] * turn.col(1));
			samples.x.push_back(point.x());
			samples.y.push_back(point.y());
			samples.z.push_back(point.z() + height);
			samples.depth_m.push_back(depth);
			samples.u.push_back(static_cast<std::int16_t>(grid.pixel(column)));
			samples.v.push_back(static_cast<std::int16_t>(grid.pixel(row)));
		}
	}
	return samples;
}
}  // namespace

void describe(FieldVisitor& fields, LevelViewConfig& config)
{
	describe(fields, config.up);
	describe(fields, config.floor);
	describe(fields, config.memory);
}

LevelView levelView(const DepthFrame& frame, const RobotConfig& robot, const GroundMemory& memory,
                    const LevelViewConfig& config, const SensorNoiseConfig& noise)
{
	LevelView view;
	view.image = &frame.image;
	const SampleGrid grid = sampleGrid(frame.image);
	const Mount mount = mountOf(frame);
	const auto remembered = config.gravity_prior ? recall(memory, frame, robot, config.memory) : std::nullopt;
	UpPrior up{Eigen::Vector3d::UnitZ(), kPaperTilt, UpOrigin::mount};
	if (config.gravity_prior) up = recordedUp(frame, robot, remembered, config.up);
	const CameraHeight height = heightPrior(frame, mount, up.up, robot, remembered, config.floor);
	up.up = mount.robot_from_camera.linear().transpose() * up.up;
	if (config.gravity_prior) up = refineUp(up, grid, noise);

	const auto floor = findFloor(grid, up, height, config.floor, noise);
	view.pose.up = up.origin;
	if (floor)
	{
		view.pose.floor_samples = floor->samples;
		view.pose.tilt_sigma_rad = floor->tilt_sigma_rad;
		view.pose.height_sigma_m = floor->height_sigma_m;
		setFloor(view.pose, floor->plane_in_camera, mount);
	}
	else
		setUnseen(view.pose, mount, robot, height, remembered, up, grid);
	if (floor || config.gravity_prior) view.samples = levelSamplesOf(grid, view.pose.level_from_camera);
	return view;
}

GroundMemory remember(const GroundMemory& memory, const DepthFrame& frame, const LevelPose& pose)
{
	if (pose.floor != FloorOrigin::seen || pose.floor_samples == 0) return memory;
	const Eigen::Vector3d normal = pose.robot_from_level.linear().col(2);
	const Plane plane{normal, -normal.dot(pose.robot_from_level.translation())};
	return remember(frame, {plane, pose.tilt_sigma_rad, pose.height_sigma_m});
}
}  // namespace explore

// A depth image seen upright: which way is up, where the floor is, and a thinned set of its points in that frame.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/results.h>
#include <explore/perception/floor.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace explore
{
/** Where the height of the floor below the camera comes from. */
enum class FloorOrigin
{
	seen,        ///< fitted in this frame
	remembered,  ///< an earlier frame's
	mount,       ///< a ground robot stands on it
	guessed      ///< a MAV that never saw it: not higher than what is seen, within its flight band
};

/** The level frame of a view: origin on the floor straight below the camera, z up (the floor's normal where it was
 *  seen, else against gravity), x the optical axis laid into the floor. The height of a point is its z. */
struct LevelPose
{
	Eigen::Isometry3d level_from_camera = Eigen::Isometry3d::Identity();
	Eigen::Isometry3d robot_from_level = Eigen::Isometry3d::Identity();
	FloorOrigin floor = FloorOrigin::seen;
	UpOrigin up = UpOrigin::mount;                       ///< `surfaces`: what was recorded about gravity is wrong
	std::size_t floor_samples = 0;                       ///< on the floor that was seen
	double tilt_sigma_rad = 0.1, height_sigma_m = 0.25;  ///< standard deviations of up and of the floor's height

	[[nodiscard]] double cameraHeight_m() const { return level_from_camera.translation().z(); }
};

/** Every `stride`-th pixel of every `stride`-th row that has a return, in the level frame [m]; all arrays have the same
 *  length. Row by row, left to right. */
struct LevelSamples
{
	int stride = 4;
	std::vector<float> x, y, z;
	std::vector<float> depth_m;      ///< along the optical axis
	std::vector<std::int16_t> u, v;  ///< the pixel

	[[nodiscard]] std::size_t size() const { return x.size(); }
};

struct LevelView
{
	const DepthImage* image = nullptr;  ///< must outlive the view
	LevelPose pose;
	LevelSamples samples;
};

struct LevelViewConfig
{
	UpPriorConfig up;
	FloorConfig floor;
	GroundMemoryConfig memory;
	/** False: up is the robot's z axis as in the paper, and without a floor within 15° of it there are no samples
	 *  (remedy 9 left out). */
	bool gravity_prior = true;
};
void describe(FieldVisitor& fields, LevelViewConfig& config);

/** The view of an organised frame; an empty image gives no samples. The frame must outlive it. */
LevelView levelView(const DepthFrame& frame, const RobotConfig& robot, const GroundMemory& memory,
                    const LevelViewConfig& config, const SensorNoiseConfig& noise);

/** `memory`, or what this view's floor makes of it where one was seen. */
GroundMemory remember(const GroundMemory& memory, const DepthFrame& frame, const LevelPose& pose);
}  // namespace explore

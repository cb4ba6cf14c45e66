// How good a chosen heading is against the true free paths (doc/definitions.md, "Heading").
#pragma once

#include <explore/core/truth.h>
#include <explore/navigation/heading.h>

#include <optional>

namespace explore::evaluation
{
struct HeadingScore
{
	std::optional<double> chosen;  ///< s(chosen) [m]; no value: the robot stops
	double best = 0;               ///< largest s in the field of view [m]
	bool good = false;
	bool collision = false;  ///< the true path along the heading ends within the stopping distance
};

/** What the camera truly sees and what the robot needs to stop. */
struct HeadingTruth
{
	const TruthFreePaths& paths;
	const mrpt::poses::CPose3D& map_from_robot;
	const mrpt::poses::CPose3D& robot_from_camera;
	const CameraIntrinsics& intrinsics;
};

HeadingScore scoreHeading(const Decision& decision, const HeadingTruth& truth, const RobotConfig& robot,
                          const HeadingConfig& config);
}  // namespace explore::evaluation

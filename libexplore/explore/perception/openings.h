// The openings in a view's walls: doors and passages with verdict and confidence (method = full).
#pragma once

#include <explore/core/robot.h>
#include <explore/perception/corridor_end.h>
#include <explore/perception/opening_verdict.h>
#include <explore/perception/remedies.h>

#include <vector>

namespace explore
{
struct OpeningsConfig
{
	RayEvidenceConfig rays;
	JambConfig jambs;
	OpeningConfig measure;
	VerdictConfig verdict;
};
void describe(FieldVisitor& fields, OpeningsConfig& config);

/** An opening in the level frame. */
struct Opening
{
	OpeningFrame frame;
	OpeningMeasure measure;
	OpeningContext context;
	OpeningVerdict verdict;
	std::size_t wall = 0;  ///< index of the wall it is in
	Eigen::Vector2d center = Eigen::Vector2d::Zero();
	Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
};

/** The openings of all walls; of those that overlap, the surest. Best first. */
std::vector<Opening> findOpenings(const LevelView& view, const std::vector<UprightWall>& walls,
                                  const RobotConfig& robot, const OpeningsConfig& config,
                                  const SensorNoiseConfig& noise);

/** Where a corridor ends, as an opening. */
Opening openingOf(const CorridorEnd& end, const RobotConfig& robot, const VerdictConfig& config);

/** The same as the rest of the program wants it: a door in the robot frame. */
Door doorOf(const Opening& opening, const LevelPose& pose);
}  // namespace explore

// The stretches of a view's walls that may be openings, measured but not judged.
#pragma once

#include <explore/core/robot.h>
#include <explore/perception/opening_verdict.h>

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
	OpeningVerdict verdict;  ///< see findOpenings()
	std::size_t wall = 0;    ///< index of the wall it is in
	Eigen::Vector2d center = Eigen::Vector2d::Zero();
	Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
};

/** Those of all walls, in their order; several may be about the same opening. Without a verdict. */
std::vector<Opening> measuredOpenings(const LevelView& view, const std::vector<UprightWall>& walls,
                                      const RobotConfig& robot, const OpeningsConfig& config,
                                      const SensorNoiseConfig& noise);
}  // namespace explore

// A line in the plan view: fitting it to points of the scan, and which points lie on it.
#pragma once

#include <explore/perception/plan_scan.h>
#include <explore/perception/upright_walls.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace explore
{
/** The points p of the level frame's plan with normal · p + offset_m = 0; the normal turns to the camera. */
struct PlanLine
{
	Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
	double offset_m = 0;
};

/** inverse = at_zero + per_slope · slope; no value for a line through the camera. */
std::optional<PlanLine> planLineOf(double at_zero, double per_slope);

/** Signed distance of a point of the scan, positive toward the camera [m]. */
double distanceFrom(const PlanScan& scan, const PlanLine& line, int i);

/** pointTolerance() of a point of the scan. */
double toleranceAt(const PlanScan& scan, const PlanLine& line, int i, const UprightWallConfig& config);

/** How far from the line a point of the scan may lie: noise of the means of many samples is less than that of one. */
double pointTolerance(const PlanLine& line, double point_noise, const UprightWallConfig& config);

/** Weighted least squares in (slope, inverse) through `members`, iterated with less and less weight to what lies off
 *  `start`. */
PlanLine fitLine(const PlanScan& scan, const std::vector<int>& members, const PlanLine& start,
                 const UprightWallConfig& config);

/** The points of `candidates` within tolerance of the line. */
std::vector<int> membersOf(const PlanScan& scan, const PlanLine& line, const std::vector<int>& candidates,
                           const UprightWallConfig& config);

/** Where a point of the scan lies along the line's tangent (see UprightWall) [m]. */
double alongOf(const PlanScan& scan, const PlanLine& line, int i);

/** Members of a line without a gap between them. */
struct LinePiece
{
	double from_m, to_m;  ///< along the tangent
	int points;
	double samples;
};

/** The pieces that `members` (ascending) make on the line, in the order of the scan: along the tangent from its end to
 * its beginning. */
std::vector<LinePiece> piecesOf(const PlanScan& scan, const PlanLine& line, const std::vector<int>& members);

}  // namespace explore

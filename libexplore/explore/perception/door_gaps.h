// Open doors as gaps in a wall (Algorithm 1, lines 10–20): scan at two heights above the ground, keep what agrees.
#pragma once

#include <explore/core/results.h>
#include <explore/perception/walls.h>

#include <vector>

namespace explore
{
struct DoorGapConfig
{
	double scan_height_m = 0.8;  ///< h_s
	double second_scan_height_m = 1.2;
	double scan_band_m = 0.05;  ///< th_s, half the band's height
	double min_gap_m = 0.8;     ///< th_g^min
	double max_gap_m = 1.6;     ///< th_g^max
	double agreement_m = 0.15;  ///< between the jambs of the two heights
};
void describe(FieldVisitor& fields, DoorGapConfig& config);

/** A hole in a wall's scan line: the two points beside it, ordered along the wall's tangent t = g × n. */
struct Gap
{
	Eigen::Vector3d start, end;
};

/** The gaps of door width between consecutive points of the band h ± th_s above the ground (paper eq. 2), in the order
 * of the wall's tangent. */
std::vector<Gap> scanGaps(const WallPatch& wall, const Plane& ground, double height_m, const DoorGapConfig& config);

/** The doors of one wall: pairs of gaps at the two heights that agree, averaged. Each gap is used once. */
std::vector<Door> findDoors(const WallPatch& wall, const Plane& ground, const DoorGapConfig& config);
}  // namespace explore

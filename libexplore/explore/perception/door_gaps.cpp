#include <explore/perception/door_gaps.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
/** Along the wall, horizontal, to the left when one looks at the wall (t = g × n; replaces the paper's X or Z axis). */
Eigen::Vector3d tangentOf(const WallPatch& wall, const Plane& ground)
{
	return ground.normal.cross(wall.wall.plane.normal).normalized();
}

std::vector<Eigen::Vector3d> pointsAtHeight(const WallPatch& wall, const Plane& ground, double height_m,
                                            double half_band_m)
{
	std::vector<Eigen::Vector3d> band;
	for (std::size_t i = 0; i < wall.inliers_in_robot.size(); ++i)
	{
		const Eigen::Vector3d point = wall.inliers_in_robot[i].cast<double>();
		if (std::abs(ground.signedDistance(point) - height_m) <= half_band_m) band.push_back(point);  // eq. 2
	}
	return band;
}

double widthAlong(const Gap& gap, const Eigen::Vector3d& tangent)
{
	return tangent.dot(gap.end - gap.start);
}

bool agree(const Gap& a, const Gap& b, const Eigen::Vector3d& tangent, double tolerance_m)
{
	return std::abs(tangent.dot(a.start - b.start)) <= tolerance_m &&
	       std::abs(tangent.dot(a.end - b.end)) <= tolerance_m;
}

Door doorFrom(const Gap& low, const Gap& high, const WallPatch& wall, const Eigen::Vector3d& tangent)
{
	Door door;
	door.center = 0.25 * (low.start + low.end + high.start + high.end);
	door.normal = wall.wall.plane.normal;
	door.width_m = 0.5 * (widthAlong(low, tangent) + widthAlong(high, tangent));
	door.clear_width_m = door.width_m;
	return door;
}
}  // namespace

void describe(FieldVisitor& fields, DoorGapConfig& config)
{
	fields.real("scan_height", config.scan_height_m, {0.05, 3.0}, "m",
	            "h_s: height of the first scan above the ground.");
	fields.real("second_scan_height", config.second_scan_height_m, {0.05, 3.0}, "m",
	            "Height of the second scan above the ground.");
	fields.real(
	    "scan_band", config.scan_band_m, {0.01, 0.5}, "m",
	    "th_s: points within this distance of the scan height count (paper: 0.05; 0.15 for simulated warehouses).");
	fields.real("min_gap", config.min_gap_m, {0.1, 10.0}, "m", "th_g^min: narrowest gap that is a door.");
	fields.real("max_gap", config.max_gap_m, {0.1, 10.0}, "m", "th_g^max: widest gap that is a door.");
	fields.real("gap_agreement", config.agreement_m, {0.01, 1.0}, "m",
	            "The gaps at both heights agree when their jambs are this close.");
}

std::vector<Gap> scanGaps(const WallPatch& wall, const Plane& ground, double height_m, const DoorGapConfig& config)
{
	const Eigen::Vector3d tangent = tangentOf(wall, ground);
	auto band = pointsAtHeight(wall, ground, height_m, config.scan_band_m);
	std::ranges::stable_sort(band, {}, [&](const Eigen::Vector3d& point) { return tangent.dot(point); });
	std::vector<Gap> gaps;
	for (std::size_t i = 1; i < band.size(); ++i)
	{
		const Gap gap{band[i - 1], band[i]};
		const double width_m = widthAlong(gap, tangent);
		if (width_m >= config.min_gap_m && width_m <= config.max_gap_m) gaps.push_back(gap);
	}
	return gaps;
}

std::vector<Door> findDoors(const WallPatch& wall, const Plane& ground, const DoorGapConfig& config)
{
	const Eigen::Vector3d tangent = tangentOf(wall, ground);
	auto high_gaps = scanGaps(wall, ground, config.second_scan_height_m, config);
	std::vector<Door> doors;
	for (const Gap& low : scanGaps(wall, ground, config.scan_height_m, config))
	{
		const auto high = std::ranges::find_if(
		    high_gaps, [&](const Gap& candidate) { return agree(low, candidate, tangent, config.agreement_m); });
		if (high == high_gaps.end()) continue;
		doors.push_back(doorFrom(low, *high, wall, tangent));
		high_gaps.erase(high);
	}
	return doors;
}
}  // namespace explore

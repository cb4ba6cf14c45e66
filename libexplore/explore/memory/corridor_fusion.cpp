#include <explore/memory/corridor_fusion.h>
#include <explore/memory/door_place.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
/** Added to the variances [m², rad²] before each look, so that the mean never stops listening. */
constexpr double kOffsetPerLook = 0.01 * 0.01, kDirectionPerLook = 0.002 * 0.002;

/** Offset of the sighting's point from the axis, positive to the left, and its turn. */
Eigen::Vector2d residual(const CorridorTrack& track, const CorridorSighting& sighting)
{
	const Eigen::Vector2d direction = track.direction(), offset = sighting.point_in_map - track.point_in_map;
	return {direction.x() * offset.y() - direction.y() * offset.x(),
	        axisDifference(sighting.direction_rad, track.direction_rad)};
}

double alongOf(const CorridorTrack& track, const Eigen::Vector2d& point_in_map)
{
	return track.direction().dot(point_in_map - track.point_in_map);
}

/** The covariance of offset and direction at another point of the axis. */
Eigen::Matrix2d covarianceAt(const CorridorTrack& track, double along_m)
{
	Eigen::Matrix2d shift = Eigen::Matrix2d::Identity();
	shift(0, 1) = along_m;
	return shift * track.covariance * shift.transpose();
}

Eigen::Matrix2d noiseOf(const CorridorSighting& sighting)
{
	return Eigen::Vector2d(sighting.offset_variance, sighting.direction_variance).asDiagonal();
}

/** The nearest walls of the vanishing point on either side of the camera, as offsets across its direction. */
struct Sides
{
	std::optional<double> left_m, right_m;
};

Sides sidesOf(const VanishingPoint& point, std::span<const Wall> walls, const Eigen::Vector3d& camera_in_robot)
{
	Sides sides;
	const Eigen::Vector3d left = Eigen::Vector3d::UnitZ().cross(point.direction).normalized();
	for (const std::size_t index : point.walls)
	{
		if (index >= walls.size()) continue;
		const double offset_m = left.dot(walls[index].floor_line.point - camera_in_robot);
		std::optional<double>& side = offset_m > 0 ? sides.left_m : sides.right_m;
		if (!side || std::abs(offset_m) < std::abs(*side)) side = offset_m;
	}
	return sides;
}
}  // namespace

Eigen::Vector2d CorridorTrack::direction() const
{
	return {std::cos(direction_rad), std::sin(direction_rad)};
}

Eigen::Vector2d CorridorTrack::at(double along_m) const
{
	return point_in_map + along_m * direction();
}

CorridorSighting sightingOf(const VanishingPoint& vanishing_point_in_robot, const CorridorLook& look,
                            const CorridorTrackConfig& config)
{
	const Eigen::Vector3d camera = look.robot_from_camera.translation();
	const Eigen::Vector3d& direction = vanishing_point_in_robot.direction;
	const Sides sides = sidesOf(vanishing_point_in_robot, look.walls_in_robot, camera);
	const bool both = sides.left_m && sides.right_m;
	const double middle_m = both ? 0.5 * (*sides.left_m + *sides.right_m) : 0.0;
	const Eigen::Vector3d left = Eigen::Vector3d::UnitZ().cross(direction).normalized();
	const double sigma_m = both ? config.middle_m : config.one_sided_m;

	CorridorSighting sighting;
	sighting.point_in_map = (look.map_from_robot * (camera + middle_m * left)).head<2>();
	sighting.direction_rad = azimuthOf(look.map_from_robot.linear() * direction);
	sighting.offset_variance = sigma_m * sigma_m;
	sighting.direction_variance = config.direction_rad * config.direction_rad;
	sighting.length_m = std::max(0.0, direction.dot(vanishing_point_in_robot.point - camera));
	if (both) sighting.width_m = *sides.left_m - *sides.right_m;
	sighting.height_m = (look.map_from_robot * vanishing_point_in_robot.point).z();
	return sighting;
}

std::optional<double> distanceOf(const CorridorTrack& track, const CorridorSighting& sighting,
                                 const CorridorTrackConfig& config)
{
	const double along_m = alongOf(track, sighting.point_in_map);
	const double ahead = std::cos(sighting.direction_rad - track.direction_rad) > 0 ? 1.0 : -1.0;
	const double end_m = along_m + ahead * sighting.length_m;
	const double gap_m = std::max(std::min(along_m, end_m) - track.to_m, track.from_m - std::max(along_m, end_m));
	if (gap_m > config.max_gap_m) return std::nullopt;
	const Eigen::Vector2d apart = residual(track, sighting);
	const Eigen::Matrix2d spread = covarianceAt(track, along_m) + noiseOf(sighting);
	const double distance = apart.dot(spread.inverse() * apart);
	return distance < config.gate ? std::optional(distance) : std::nullopt;
}

void fuse(CorridorTrack& track, const CorridorSighting& sighting)
{
	const double along_m = alongOf(track, sighting.point_in_map);
	const Eigen::Vector2d apart = residual(track, sighting);
	const double ahead = std::cos(sighting.direction_rad - track.direction_rad) > 0 ? 1.0 : -1.0;
	const Eigen::Matrix2d predicted =
	    covarianceAt(track, along_m) + Eigen::Matrix2d(Eigen::Vector2d(kOffsetPerLook, kDirectionPerLook).asDiagonal());
	const Eigen::Matrix2d noise = noiseOf(sighting), gain = predicted * (predicted + noise).inverse();
	const Eigen::Vector2d change = gain * apart;
	const Eigen::Vector2d left(-track.direction().y(), track.direction().x());
	track.point_in_map = track.at(along_m) + change.x() * left;
	track.direction_rad = wrapToPi(track.direction_rad + change.y());
	const Eigen::Matrix2d rest = Eigen::Matrix2d::Identity() - gain;
	track.covariance = rest * predicted * rest.transpose() + gain * noise * gain.transpose();

	const double end_m = ahead * sighting.length_m;
	track.from_m = std::min({track.from_m - along_m, 0.0, end_m});
	track.to_m = std::max({track.to_m - along_m, 0.0, end_m});
	constexpr double kNews = 0.2;  // of a width
	if (sighting.width_m)
		track.width_m =
		    track.width_m ? *track.width_m + kNews * (*sighting.width_m - *track.width_m) : *sighting.width_m;
	track.point_height_m = sighting.height_m;
}

CorridorTrack newCorridor(int number, const CorridorSighting& sighting)
{
	CorridorTrack track;
	track.number = number;
	track.point_in_map = sighting.point_in_map;
	track.direction_rad = sighting.direction_rad;
	track.covariance = noiseOf(sighting);
	track.to_m = sighting.length_m;
	track.width_m = sighting.width_m;
	track.point_height_m = sighting.height_m;
	return track;
}

CorridorSighting asSighting(const CorridorTrack& track)
{
	CorridorSighting sighting;
	sighting.point_in_map = track.at(track.from_m);
	sighting.direction_rad = track.direction_rad;
	sighting.offset_variance = covarianceAt(track, track.from_m)(0, 0);
	sighting.direction_variance = track.covariance(1, 1);
	sighting.length_m = track.to_m - track.from_m;
	sighting.width_m = track.width_m;
	sighting.height_m = track.point_height_m;
	return sighting;
}

CorridorTrack joined(const CorridorTrack& a, const CorridorTrack& b)
{
	CorridorTrack result = a;
	fuse(result, asSighting(b));
	result.existence = joined(a.existence, b.existence);
	return result;
}
}  // namespace explore

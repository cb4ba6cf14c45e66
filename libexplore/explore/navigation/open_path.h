// Open path lengths d(θ): how far the hull can be swept along a direction before it touches an obstacle point.
#pragma once

#include <explore/navigation/avoider.h>
#include <explore/navigation/direction_fan.h>

#include <cstddef>
#include <vector>

namespace explore
{
/** An obstacle point in the level frame. */
struct ObstacleSample
{
	float x, y, z;
	float radius_m;   ///< of the hull that must not touch it
	float nearest_m;  ///< no direction reaches it sooner: distance in the plane − radius, at least 0
};

/** A stretch of the way, from one travelled length [m] to another. */
struct TravelSpan
{
	double enter_m, leave_m;
};

/** The obstacles that the hull can touch, ready for questions about directions.
 *
 *  The hull is the upright cylinder of the robot's radius + clearance around the robot frame's origin. The clearance is
 *  asked for at the robot and fades to a fifth at clearance_range_m: before the robot gets to what is further away it
 *  measures that better and mends its way, and a way past it should not be lost for a centimetre. With p the obstacle
 *  point and θ̂ the direction, in the plane (Biswas & Veloso 2012, exact disc):
 *
 *      d(θ) = min over p with p·θ̂ > 0 and ‖p⊥‖ < r of max(0, p·θ̂ − √(r² − ‖p⊥‖²)),  at most max_range_m.
 *
 *  A point already inside the hull blocks the directions toward it and none away from it.
 *
 *  - A ground robot moves in the floor's plane. What is lower than step_height_m or higher than the robot's height +
 *    clearance does not touch it. What lies deeper than step_height_m below the floor is a drop: it counts where the
 *    sensor's ray pierces the floor, because from there on nothing carries the robot. Where no floor was seen nothing
 *    can be called low, and all that is below the robot's top counts (z in the robot frame).
 *  - A MAV moves in 3D; its cylinder reaches height / 2 + clearance above and below the origin, which leaves room for
 *    the tilt of flight. Climbs end at max_altitude_m, descents at min_altitude_m; where no floor was seen, both have
 *    length 0. */
class OpenPath
{
public:
	OpenPath(const AvoiderInput& input, const RobotConfig& robot, const AvoiderConfig& config);

	/** d [m] of one direction. A ground robot has elevation 0. */
	[[nodiscard]] double along(const Direction& direction) const;
	/** d [m] of each direction of the fan. */
	[[nodiscard]] std::vector<double> along(const DirectionFan& fan) const;
	/** The obstacles that may touch the hull. */
	[[nodiscard]] const std::vector<ObstacleSample>& samples() const { return m_samples; }

private:
	void addGroundObstacles(const AvoiderInput& input, const RobotConfig& robot, const AvoiderConfig& config);
	void addFlightObstacles(const AvoiderInput& input);
	void add(const Eigen::Vector3d& point_in_level);
	/** Puts the samples into rings around the robot, the nearest first: they settle most directions at once. */
	void sortByDistance();
	[[nodiscard]] double altitudeLimit(double elevation_rad) const;
	[[nodiscard]] TravelSpan heightSpan(const ObstacleSample& sample, double sin_elevation) const;
	[[nodiscard]] std::vector<double> sweep(const DirectionFan& fan) const;

	std::vector<ObstacleSample> m_samples;
	double m_radius_m, m_clearance_m, m_clearance_range_m;
	double m_half_height_m;  ///< infinite for a ground robot: heights are sorted out beforehand
	double m_range_m;
	double m_climb_m = 0, m_descent_m = 0;  ///< height to the ends of the flight band
};
}  // namespace explore

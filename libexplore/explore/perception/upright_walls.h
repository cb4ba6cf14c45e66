// Walls as lines in the plan view: vertical planes in the level frame, with a tolerance that grows with range.
#pragma once

#include <explore/config/fields.h>
#include <explore/perception/level_view.h>
#include <explore/perception/sensor_noise.h>

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace explore
{
struct UprightWallConfig
{
	double max_range_m = 5.0;       ///< of the samples that make a wall
	double tolerance_m = 0.02;      ///< at zero range: bow, plaster, skirting
	double tolerance_sigmas = 2.5;  ///< added: this many σ_z along the ray, seen across the wall
	double min_height_m = 0.3;      ///< a wall reaches over at least this height
	double min_length_m = 0.1;
	int min_samples = 60;
	/** False: a fixed tolerance of 5 cm and no merging, as in the paper (remedy 8 left out). */
	bool range_tolerance = true;
};
void describe(FieldVisitor& fields, UprightWallConfig& config);

/** A vertical plane in the level frame: the points with normal · (x, y) + offset_m = 0. The normal turns to the camera,
 *  so offset_m, the camera's distance from the plane, is positive. Coplanar pieces are one wall. */
struct UprightWall
{
	Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
	double offset_m = 0;
	double from_m = 0, to_m = 0;  ///< extent of its samples along tangent(), 0 = foot of the camera
	std::size_t samples = 0;      ///< LevelSamples that lie on it
	double longest_piece_m = 0;   ///< of it that is seen without a break

	/** Unit, horizontal: t = g × n (remedy 1). Looking at the wall, it points to the right. */
	[[nodiscard]] Eigen::Vector2d tangent() const { return {-normal.y(), normal.x()}; }
	/** How far in front of the plane (toward the camera) a point lies. */
	[[nodiscard]] double inFront_m(const Eigen::Vector2d& point) const { return normal.dot(point) + offset_m; }
	[[nodiscard]] double along_m(const Eigen::Vector2d& point) const { return tangent().dot(point); }
	/** The point of the plane at `along_m` of its tangent. */
	[[nodiscard]] Eigen::Vector2d at(double along_m) const { return along_m * tangent() - offset_m * normal; }
};

/** How far from the plane [m] a sample may lie that belongs to it: tolerance + sigmas · σ_z(depth) · |cos(angle between
 *  the wall's normal and the sample's ray)|. */
double wallTolerance(const UprightWall& wall, const Eigen::Vector2d& point, double depth_m,
                     const UprightWallConfig& config, const SensorNoiseConfig& noise);

/** The walls of a view, the one with the most samples first. No two of them describe the same surface. Deterministic
 *  for a given seed. */
std::vector<UprightWall> findUprightWalls(const LevelView& view, const UprightWallConfig& config,
                                          const SensorNoiseConfig& noise, unsigned seed);
}  // namespace explore

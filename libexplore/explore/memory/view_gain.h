// How much of the unknown a camera would see from a place, and which way it would see most.
#pragma once

#include <explore/memory/body_layers.h>

#include <array>
#include <numbers>

namespace explore
{
struct ViewConfig
{
	double fov_rad = 57.0 * std::numbers::pi / 180.0;  ///< of the camera, horizontal
	double min_range_m = 0.6;                          ///< it is blind for what is nearer
	double range_m = 4.5;                              ///< what is farther does not count
	/** So far it may look through the unknown: what stands in there is not known either. */
	double max_unknown_m = 1.0;
};
/** [view] */
void describe(FieldVisitor& fields, ViewConfig& config);

/** Where the camera is, in which layer of the body; it may be beyond their frame. */
struct ViewPlace
{
	Eigen::Vector2d camera_in_map = Eigen::Vector2d::Zero();
	int layer = 0;
};

/** Area [m²] of the layer's unknown that a camera would see which looks along yaw_rad: inside its field of view, no
 *  nearer than config.min_range_m and no farther than config.range_m, with no occupied cell and at most
 *  config.max_unknown_m of unknown between. Rays a degree apart stand for all: what is narrower may be missed. */
double viewGain(const BodyLayers& layers, const ViewPlace& place, double yaw_rad, const ViewConfig& config);

constexpr int kYaws = 36;

/** Yaw i of kYaws around the circle, from 0 to the left [rad], in (−π, π]. */
double yawOf(int i);

/** viewGain() [m²] for every yawOf(), in one pass. */
std::array<double, kYaws> viewGains(const BodyLayers& layers, const ViewPlace& place, const ViewConfig& config);

struct BestYaw
{
	double yaw_rad = 0.0, gain_m2 = 0.0;
};

/** The best of them; the first where several are. */
BestYaw bestYaw(const BodyLayers& layers, const ViewPlace& place, const ViewConfig& config);
}  // namespace explore

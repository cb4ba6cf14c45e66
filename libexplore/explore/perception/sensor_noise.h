// How precise a depth measurement is at its range: what tolerances and weights are made of.
#pragma once

#include <explore/config/fields.h>

namespace explore
{
/** σ_z(z) = base + quadratic · (z − 0.4 m)², the axial noise of a structured-light camera (Nguyen, Izadi, Lovell 2012),
 *  times `scale` for a better or worse sensor. */
struct SensorNoiseConfig
{
	double base_m = 0.0012;
	double quadratic_per_m = 0.0019;
	double scale = 1.0;
};
void describe(FieldVisitor& fields, SensorNoiseConfig& config);

/** Standard deviation [m] of the depth `depth_m` along the optical axis. */
double depthSigma(double depth_m, const SensorNoiseConfig& config);
}  // namespace explore

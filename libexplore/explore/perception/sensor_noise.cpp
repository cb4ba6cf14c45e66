#include <explore/perception/sensor_noise.h>

namespace explore
{
void describe(FieldVisitor& fields, SensorNoiseConfig& config)
{
	fields.real("noise_base", config.base_m, {0.0, 0.1}, "m",
	            "Depth noise at 0.4 m: sigma(z) = noise_scale * (noise_base + noise_quadratic * (z - 0.4)^2).");
	fields.real("noise_quadratic", config.quadratic_per_m, {0.0, 0.1}, "1/m", "See noise_base (Nguyen 2012).");
	fields.real("noise_scale", config.scale, {0.01, 20.0}, "", "See noise_base; below 1 for a better sensor.");
}

double depthSigma(double depth_m, const SensorNoiseConfig& config)
{
	constexpr double kNearest_m = 0.4;
	const double beyond_m = depth_m - kNearest_m;
	return config.scale * (config.base_m + config.quadratic_per_m * beyond_m * beyond_m);
}
}  // namespace explore

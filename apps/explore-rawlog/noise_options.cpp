#include <explore-rawlog/noise_options.h>
#include <explore/config/number_text.h>

#include <CLI/CLI.hpp>

namespace explore::app
{
void addNoiseOptions(CLI::App& app, double& noise_scale, double& holes)
{
	app.add_option("--noise-scale", noise_scale, "Factor on the noise of the depth; 1 is that of a usual device")
	    ->type_name("X")
	    ->check(CLI::Range(0.0, 10.0).description(""))
	    ->capture_default_str();
	app.add_option("--holes", holes,
	               "Share of the returns that are missing besides, in blotches of several sizes and one by one; 0-1")
	    ->type_name("SHARE")
	    ->check(CLI::Range(0.0, 1.0).description(""))
	    ->capture_default_str();
}

std::string noiseArguments(double noise_scale, double holes)
{
	std::string text;
	if (noise_scale != 1.0) text.append(" --noise-scale ").append(formatNumber(noise_scale));
	if (holes != 0.0) text.append(" --holes ").append(formatNumber(holes));
	return text;
}

std::string noiseName(const simulation::DepthCameraConfig& camera)
{
	std::string name(simulation::nameOf(camera.noise));
	if (camera.noise_scale != 1.0) name.append(" x").append(formatNumber(camera.noise_scale));
	if (camera.hole_share != 0.0) name.append(" holes ").append(formatNumber(camera.hole_share));
	return name;
}
}  // namespace explore::app

// How much worse than usual the simulated camera measures: the same options for record and synth.
#pragma once

#include <explore/simulation/depth_camera.h>

#include <string>

namespace CLI
{
class App;
}

namespace explore::app
{
/** --noise-scale and --holes. */
void addNoiseOptions(CLI::App& app, double& noise_scale, double& holes);

/** The same as arguments, each after a blank; "" where they are as usual. */
std::string noiseArguments(double noise_scale, double holes);

/** The truth's name of the noise: "kinect", "kinect x2", "speckle x2 holes 0.3". */
std::string noiseName(const simulation::DepthCameraConfig& camera);
}  // namespace explore::app

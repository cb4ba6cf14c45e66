// A structured-light camera rebuilt: a projected speckle pattern in an infrared picture, found again block by block.
#pragma once

#include <explore/simulation/sensor_view.h>

#include <cstddef>

namespace explore::simulation
{
/** The camera whose picture is matched: the same, but as fine as a device's at least. Every `finer`-th pixel of its
 * rows and columns is a pixel of `config`'s. */
struct SpeckleCamera
{
	DepthCameraConfig config;
	int finer = 1;
};
SpeckleCamera speckleCamera(const DepthCameraConfig& config);

/** The depth image that the camera delivers of `view`; 0 where no block of the pattern was recognised. */
std::vector<float> speckleDepth(const SensorView& view, const DepthCameraConfig& config, std::uint64_t seed);

/** What `camera` shows of a row-major image `finer` times as wide and high, with `channels` numbers a pixel. */
template <class Value>
std::vector<Value> everyNth(const std::vector<Value>& values, const CameraIntrinsics& camera, int finer, int channels)
{
	std::vector<Value> kept;
	if (values.empty()) return kept;
	const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(finer) * camera.width_px * channels;
	for (int v = 0; v < camera.height_px; ++v)
		for (int u = 0; u < camera.width_px; ++u)
		{
			const auto first = values.begin() + v * finer * row + static_cast<std::ptrdiff_t>(u) * finer * channels;
			kept.insert(kept.end(), first, first + channels);
		}
	return kept;
}
}  // namespace explore::simulation

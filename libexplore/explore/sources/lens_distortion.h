// Straightens depth images of cameras whose recording carries lens distortion.
#pragma once

#include <explore/core/depth_frame.h>
#include <mrpt/img/TCamera.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace explore
{
/** Where the distorted image shows what an ideal pinhole with the same fx, fy, cx, cy shows at (u, v). Knows MRPT's
 *  plumb_bob (k1 k2 p1 p2 k3 k4 k5 k6) and kannala_brandt (k1 k2 · · k3 k4) models. */
[[nodiscard]] Eigen::Vector2d distortPixel(const mrpt::img::TCamera& camera, double u_px, double v_px);

/** True when the model and its coefficients move any pixel. */
[[nodiscard]] bool hasDistortion(const mrpt::img::TCamera& camera);

/** Resamples images of one camera after the other; keeps the lookup table of the last one. Each pixel takes its nearest
 *  neighbour's value: depths on both sides of an edge must not be mixed. Pixels that look past the image become 0. */
class Undistorter
{
public:
	void apply(const mrpt::img::TCamera& camera, std::vector<float>& values);

private:
	void prepare(const mrpt::img::TCamera& camera);
	std::optional<mrpt::img::TCamera> m_camera;
	std::vector<int> m_source;  ///< index of the distorted pixel, −1 = outside
};
}  // namespace explore

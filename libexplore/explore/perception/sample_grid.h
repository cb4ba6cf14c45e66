// The depth image thinned to a grid of samples, and which way the surface faces at each of them.
#pragma once

#include <explore/core/depth_frame.h>

#include <cstddef>
#include <vector>

namespace explore
{
/** Every stride-th pixel of every stride-th row; arrays are row-major, rows × columns, unless said otherwise. */
struct SampleGrid
{
	int stride = 1, columns = 0, rows = 0;
	std::vector<float> depth_m;  ///< along the optical axis; 0 = no return
	std::vector<float> ray_y;    ///< a column each: the point in the camera frame is depth · (1, ray_y, ray_z)
	std::vector<float> ray_z;    ///< a row each
	std::vector<float> normal_x, normal_y, normal_z;  ///< unit, camera frame, toward the camera; zero = not known

	[[nodiscard]] std::size_t size() const { return depth_m.size(); }
	[[nodiscard]] int pixel(int index) const { return stride / 2 + index * stride; }
};

/** The stride that leaves about 19,200 samples (160 × 120): 4 for VGA, 2 for QVGA, 1 below. */
int sampleStride(const CameraIntrinsics& intrinsics);

/** The grid with the normals of its surfaces, which are differences between the samples two steps to either side. An
 *  empty or inconsistent image gives an empty grid. */
SampleGrid sampleGrid(const DepthImage& image);
}  // namespace explore

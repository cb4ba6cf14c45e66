#include <explore/core/vector_code.h>
#include <explore/memory/cube_view.h>
#include <explore/memory/octet_look.h>
#include <explore/memory/voxel_block.h>

namespace explore
{
namespace
{
constexpr float kHoldsPixel_px = 0.75F;  // a circle of this radius holds the pixel nearest to its centre
constexpr Octet<unsigned> kBit{1, 2, 4, 8, 16, 32, 64, 128};

// Plain comparisons, so that loops over them vectorise.
[[gnu::always_inline]] inline float larger(float a, float b)
{
	return a < b ? b : a;
}
[[gnu::always_inline]] inline float smaller(float a, float b)
{
	return a < b ? a : b;
}
[[gnu::always_inline]] inline int larger(int a, int b)
{
	return a < b ? b : a;
}
[[gnu::always_inline]] inline int smaller(int a, int b)
{
	return a < b ? a : b;
}

/** One axis of the image: pixel = at_axis + scale · tangent, `last` is the image's last pixel. */
struct ImageAxis
{
	float at_axis, scale;
	int last;
};

/** Centres across the viewing direction, and their pixels. */
[[gnu::always_inline]] inline void findPixels(const ImageAxis& axis, const Octet<float>& across,
                                              const Octet<float>& per_depth, Octet<int>& pixel)
{
	for (std::size_t i = 0; i < kOctet; ++i)
		pixel[i] = pixelBelow(axis.at_axis + axis.scale * across[i] * per_depth[i] + 0.5F);
}

struct Depths
{
	Octet<float> per_nearest, per_farthest;  ///< 1 / depth
};

[[gnu::always_inline]] inline void findRects(const ImageAxis& axis, const Octet<float>& across, float half,
                                             const Depths& depths, Octet<int>& first, Octet<int>& last)
{
	for (std::size_t i = 0; i < kOctet; ++i)
	{
		const float low = across[i] - half, high = across[i] + half;
		const float a = axis.at_axis + axis.scale * low * (low < 0.0F ? depths.per_nearest[i] : depths.per_farthest[i]);
		const float b =
		    axis.at_axis + axis.scale * high * (high > 0.0F ? depths.per_nearest[i] : depths.per_farthest[i]);
		first[i] = larger(pixelBelow(smaller(a, b) - kRounding_px) + 1, 0);
		last[i] = smaller(pixelBelow(larger(a, b) + kRounding_px), axis.last);
	}
}

[[gnu::always_inline]] inline void look(const OctetLook& with, const Eigen::Vector3f& first_center,
                                        const ReachPyramid::Around& around, OctetSight& sight)
{
	const FrameRays& rays = *with.rays;
	const ImageAxis columns{rays.axis_px[0], rays.px_per_tangent[0], rays.width_px - 1};
	const ImageAxis rows{rays.axis_px[1], rays.px_per_tangent[1], rays.height_px - 1};
	const float half_m = with.half[0], x0 = first_center[0], y0 = first_center[1], z0 = first_center[2];
	Octet<float> depth_m{}, left_m{}, up_m{}, per_depth{};
	Depths depths{};
	for (std::size_t i = 0; i < kOctet; ++i)
	{
		depth_m[i] = x0 + with.offset[0][i];
		left_m[i] = y0 + with.offset[1][i];
		up_m[i] = z0 + with.offset[2][i];
		per_depth[i] = 1.0F / depth_m[i];
		sight.nearest_m[i] = depth_m[i] - half_m;
		depths.per_nearest[i] = 1.0F / larger(sight.nearest_m[i], kInFront_m);
		depths.per_farthest[i] = 1.0F / (depth_m[i] + half_m);
	}
	Octet<int> u{}, v{};
	findPixels(columns, left_m, per_depth, u);
	findPixels(rows, up_m, per_depth, v);
	findRects(columns, left_m, with.half[1], depths, sight.u0, sight.u1);
	findRects(rows, up_m, with.half[2], depths, sight.v0, sight.v1);
	unsigned passed = 0, hidden = 0;
	for (std::size_t i = 0; i < kOctet; ++i)
	{
		// Moving a pixel into the image brings it nearer to every pixel of the image.
		const int inner_u = smaller(larger(u[i], 0), columns.last), inner_v = smaller(larger(v[i], 0), rows.last);
		const int moved_px = larger(larger(u[i] - inner_u, inner_u - u[i]), larger(v[i] - inner_v, inner_v - v[i]));
		const float reach_m = around.reach_m[inner_v * around.width_px + inner_u];
		const float around_m =
		    around.farthest_m[(inner_v >> around.shift) * around.columns + (inner_u >> around.shift)];
		const float farthest_m = depth_m[i] + half_m;
		const int in_front = static_cast<int>(sight.nearest_m[i] > 0.0F);
		const int is_passed = in_front & static_cast<int>(moved_px == 0) & static_cast<int>(reach_m > farthest_m) &
		                      static_cast<int>(farthest_m < with.sure_depth_m);
		const int out_of_view = static_cast<int>(moved_px > around.radius_px);
		const int is_hidden = (in_front & (out_of_view | static_cast<int>(around_m <= sight.nearest_m[i]))) |
		                      static_cast<int>(farthest_m <= 0.0F);
		passed |= is_passed != 0 ? kBit[i] : 0U;
		hidden |= is_hidden != 0 ? kBit[i] : 0U;
	}
	sight.passed = passed;
	sight.hidden = hidden;
}
EXPLORE_VECTOR_CODE(lookOnThisProcessor, look,
                    (const OctetLook& with, const Eigen::Vector3f& first_center, const ReachPyramid::Around& around,
                     OctetSight& sight),
                    (with, first_center, around, sight))
}  // namespace

OctetLook octetLook(const FrameRays& rays)
{
	OctetLook look;
	look.rays = &rays;
	look.half = halfExtent(rays, 1.0F);
	for (int i = 0; i < kOctet; ++i)
	{
		const auto [x, y, z] = coordinatesOfPlace(i);
		const Eigen::Vector3f offset = rays.camera_from_voxels * Eigen::Vector3f(x, y, z);
		for (int axis = 0; axis < 3; ++axis)
			look.offset[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)] = offset[axis];
	}
	const float inscribed_m = 0.5F * rays.camera_from_voxels.col(0).norm();
	look.sure_depth_m = inscribed_m * rays.px_per_tangent.abs().minCoeff() / kHoldsPixel_px;
	return look;
}

OctetSight lookAtOctet(const OctetLook& look, const Eigen::Vector3f& first_center, const ReachPyramid::Around& around)
{
	OctetSight sight;
	lookOnThisProcessor(look, first_center, around, sight);
	return sight;
}
}  // namespace explore

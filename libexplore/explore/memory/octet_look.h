// A first look at eight voxels at once: which are passed by rays, which are hidden, and where the others are seen.
#pragma once

#include <explore/memory/frame_rays.h>
#include <explore/memory/reach_pyramid.h>

#include <array>

namespace explore
{
/** A cube of 2³ voxels, in the order of their places in a block. */
constexpr int kOctet = 8;
template <class Value>
using Octet = std::array<Value, kOctet>;

/** What is the same for all octets of a frame. */
struct OctetLook
{
	const FrameRays* rays = nullptr;
	std::array<Octet<float>, 3> offset{};  ///< of the voxels from the first one, camera axes [m]
	Eigen::Vector3f half;                  ///< of a voxel's box in camera axes [m]
	/** A voxel with its farthest corner at a smaller depth [m] is crossed by the ray of the pixel nearest to its
	 * centre. */
	float sure_depth_m = 0;
};
OctetLook octetLook(const FrameRays& rays);

struct OctetSight
{
	unsigned passed = 0;                ///< a bit a voxel: the ray of its centre's pixel passes through
	unsigned hidden = 0;                ///< no ray does: all around end in front of it, or it is behind the camera
	Octet<float> nearest_m{};           ///< depth of the boxes' nearest corners
	Octet<int> u0{}, v0{}, u1{}, v1{};  ///< the pixels of the image that see the boxes; none where u0 > u1 or v0 > v1
};

/** `first_center` is the middle of the octet's first voxel in camera axes [m]; `around` is for what a voxel may be seen
 * from its centre's pixel. */
OctetSight lookAtOctet(const OctetLook& look, const Eigen::Vector3f& first_center, const ReachPyramid::Around& around);
}  // namespace explore

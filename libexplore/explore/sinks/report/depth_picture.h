// A depth image as a small grey picture, for pages that colour it themselves.
#pragma once

#include <explore/core/depth_frame.h>

#include <string>

namespace explore
{
/** How a grey value stands for a depth: kNear at 0 m, kFar at the range's end and beyond, in equal steps in between; 0
 *  where there is no return. Between 0 and kFar is what a lossy picture may make of the borders. */
struct DepthGrey
{
	static constexpr int kFar = 48, kNear = 255;
};

/** A JPEG file at most `width_px` wide, higher images in proportion: each pixel is the mean of what was measured in it,
 *  and without return where that is less than half. Empty for an empty image. */
std::string depthJpeg(const DepthImage& image, double max_range_m, int width_px);
}  // namespace explore

// What is known about an opening as a row of numbers, from which its confidence is made.
#pragma once

#include <explore/perception/opening_evidence.h>

#include <array>
#include <cstddef>
#include <string_view>

namespace explore
{
/** Wall beside an opening. */
struct WallPiece
{
	double length_m = 0;  ///< that was seen
	bool ends = false;    ///< in view, at another opening or edge
	bool hidden = false;  ///< goes on behind something in front
};

/** What is known about an opening beyond the rays in it. */
struct OpeningContext
{
	double needed_width_m = 0;  ///< the robot's diameter and a margin
	WallPiece left, right;
	double wall_length_m = 0, longest_piece_m = 0;  ///< of the wall it is in
	double distance_m = 0;                          ///< of the wall's plane from the camera
};

inline constexpr std::size_t kOpeningFeatures = 42;
using OpeningFeatures = std::array<float, kOpeningFeatures>;

/** Both sides count alike: a mirrored view gives the same row. */
OpeningFeatures openingFeatures(const OpeningFrame& frame, const OpeningMeasure& measure,
                                const OpeningContext& context);

/** The names of the row's entries, in its order. */
const std::array<std::string_view, kOpeningFeatures>& openingFeatureNames();
}  // namespace explore

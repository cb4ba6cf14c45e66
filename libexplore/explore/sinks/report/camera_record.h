// What the report shows of one frame's camera: a small depth picture and what lies over it.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/pipeline/explorer.h>

#include <string>

namespace explore
{
struct CameraRecordConfig
{
	double max_range_m = 5.0;  ///< depth colours end here
	int width_px = 320;        ///< of the picture
};

/** One line of JSON. Places are [column, row] in thousandths of the picture's width, whole numbers, perhaps beyond its
 *  edges:
 *  `i` frame, `t` seconds since the first frame, `img` the picture as JPEG in base64 (null: a cloud, no image),
 *  `ratio` height by width, `walls` [x, y, x, y] of each stretch of a wall–floor line, `doors` with `q` the outline's
 *  corners (a side behind the camera left out: a list of stretches), `v` verdict, `w` and `c` widths [m], `p`
 *  confidence, `n` track, `vp` [x, y, track] of each vanishing point, `arrows` by heading, `deg` the headings
 *  [degrees, positive left], `stop` the reason or null, `free` the open path [m], `speed` [m/s]. */
std::string cameraRecord(const DepthFrame& frame, const StepResult& result, double t_s,
                         const CameraRecordConfig& config);
}  // namespace explore

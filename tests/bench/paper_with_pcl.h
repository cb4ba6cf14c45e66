// The paper's pipeline as its authors describe it, on the Point Cloud Library: the peer that the benchmarks compare
// with.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/results.h>
#include <explore/pipeline/explorer.h>

#include <optional>
#include <vector>

namespace explore::test
{
/** What Algorithm 1 returns, robot frame. */
struct PeerResult
{
	bool ground_seen = false;
	std::size_t walls = 0;
	std::vector<Door> doors;                        ///< center, normal and width only
	std::vector<Eigen::Vector3d> vanishing_points;  ///< one a wall
	std::optional<double> door_rad;                 ///< θ_o
	std::optional<double> vanishing_point_rad;      ///< θ_v
	double avoid_rad = 0;                           ///< θ*
	double open_path_m = 0;                         ///< d(θ*)
};

/** One frame with the same parameters as step(): unproject → PassThrough → VoxelGrid → SACSegmentation for the ground
 *  (perpendicular plane) and for the other planes one by one with ProjectInliers and ExtractIndices → gap scan at two
 *  heights, Lagrange lines, vanishing points → open path over the directions within ±sector. `ended` as in step(). */
PeerResult exploreWithPcl(const DepthFrame& frame, const ExplorerConfig& config, const StageEnded& ended = {});
}  // namespace explore::test

// Depth frames of rooms made of rectangles and boxes, computed ray by ray: truth that owes nothing to the library.
#pragma once

#include <explore/core/depth_frame.h>

#include <cstdint>
#include <vector>

namespace explore::test
{
/** A parallelogram corner + s·edge_u + t·edge_v, 0 ≤ s, t ≤ 1, in the map frame [m]; seen from both sides. */
struct Patch
{
	Eigen::Vector3d corner, edge_u, edge_v;
};

/** An opening in a wall: `start_m` along the wall from its first end, to `start_m + width_m`, floor to `height_m`. */
struct Opening
{
	double start_m, width_m, height_m;
};

/** Rectangles in the map frame: z up, floor at z = 0. */
class Scene
{
public:
	Scene& floor(double x_min, double y_min, double x_max, double y_max, double z = 0.0);
	/** Vertical wall from (ax, ay) to (bx, by) with openings (not overlapping, in order along the wall). */
	Scene& wall(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double height_m,
	            const std::vector<Opening>& openings = {});
	/** Axis-aligned box by its centre and size. */
	Scene& box(const Eigen::Vector3d& center, const Eigen::Vector3d& size);
	Scene& patch(const Patch& patch);

	[[nodiscard]] const std::vector<Patch>& patches() const { return m_patches; }

private:
	std::vector<Patch> m_patches;
};

/** Distance along `direction` (not necessarily unit: in its multiples) to the first patch hit; 0 = none. */
double castRay(const Scene& scene, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

struct CameraNoise
{
	/** Scale of the axial noise σ_z = scale · (0.0012 + 0.0019 (z − 0.4)²) m (Nguyen 2012); 0 = none. */
	double axial_scale = 0.0;
	double dropout_share = 0.0;  ///< pixels without return, at random
	double max_depth_m = 8.0;    ///< no return beyond
	double min_depth_m = 0.0;
	std::uint32_t seed = 1;
};

/** A VGA-like pinhole, 57° wide: fx = fy = 0.919 · width. */
CameraIntrinsics xtionIntrinsics(int width_px = 640, int height_px = 480);

/** The depth frame that a camera at map_from_robot + robot_from_camera takes of the scene. */
DepthFrame renderFrame(const Scene& scene, const mrpt::poses::CPose3D& map_from_robot,
                       const mrpt::poses::CPose3D& robot_from_camera, const CameraIntrinsics& intrinsics,
                       const CameraNoise& noise = {});

/** A corridor along +x, 2 m wide (y ∈ [−1, 1]), `length_m` long, 2.5 m high, closed at its end, with doors of
 *  0.9 m × 2.0 m: left ones start at x = `left_doors`, right ones at `right_doors`; rooms of 3 m depth behind them. */
Scene corridorScene(double length_m, const std::vector<double>& left_doors, const std::vector<double>& right_doors);
}  // namespace explore::test

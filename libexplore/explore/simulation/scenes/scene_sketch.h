// A made-up place while it is being drawn: its style, its geometry so far, and where it is to be seen from.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/geometry.h>
#include <explore/core/robot.h>
#include <explore/simulation/random.h>
#include <explore/simulation/scenes/scene_plan.h>
#include <explore/simulation/world.h>

#include <string>
#include <string_view>
#include <vector>

namespace explore::simulation
{
/** How this building is built. */
struct BuildingStyle
{
	double wall_thickness_m = 0.12, wall_height_m = 2.6;
	bool ceiling = true;
	double casing_depth_m = 0, casing_width_m = 0;       ///< moulding around doors; 0 = none
	double skirting_depth_m = 0, skirting_height_m = 0;  ///< 0 = none
};

/** The first look. */
struct Viewpoint
{
	Eigen::Vector2d camera = Eigen::Vector2d::Zero();  ///< in the building
	double yaw_rad = 0;                                ///< of the robot, in the building
	double camera_height_m = 0.5;
	double body_roll_rad = 0, body_pitch_rad = 0;
	double mount_forward_m = 0, mount_roll_rad = 0, mount_pitch_rad = 0;
};

/** A rectangle on a wall's face of which a share of points has to be in view. */
struct Region
{
	WallFrame frame;
	Span along, z;
	double behind_m = -0.05;
	Span share{0.5, 1.0};
};

/** What a look must show for the scene to be one of its family. */
struct Promise
{
	std::vector<std::string> visible_doors;  ///< ids of labels
	int walls_with_visible_doors = 0;        ///< at least so many different ones
	std::vector<Region> regions;
	bool floor_unseen = false;
	std::string one_jamb;  ///< id of a door of which exactly one jamb is in the image; empty = none
};

/** A rectangular room or corridor: a piece of its frame's plane. */
struct Space
{
	WallFrame frame;
	Span along, behind;
};

class Sketch
{
public:
	Sketch(const RobotConfig& seen_from, const CameraIntrinsics& camera, std::uint64_t seed);

	Random random;
	RobotConfig robot;
	CameraIntrinsics intrinsics;
	BuildingStyle style;
	World world;  ///< in the building frame
	FloorUse floor_use;
	Viewpoint view;
	Promise promise;
	Space robot_space;                 ///< the room or corridor in which the robot stands
	std::vector<Outline> floor_holes;  ///< rectangles along the building's axes, from their lowest corner
	bool possible = true;              ///< false: what was drawn so far has no place for the rest

	[[nodiscard]] bool flies() const { return robot.kind == RobotKind::mav; }
	/** Half of the camera's horizontal angle of view. */
	[[nodiscard]] double halfView_rad() const;
	/** Where the robot's axis meets the floor plan. */
	[[nodiscard]] Eigen::Vector2d robotPosition() const;

	double draw(const Span& span) { return random.uniform(span.low, span.high); }
	double drawAngle(const Span& degrees) { return kDegree_rad * draw(degrees); }

	/** The material of that name in this scene; its colour is drawn once, near `color`. */
	std::size_t material(std::string_view name, const Eigen::Vector3f& color = {0.7F, 0.7F, 0.7F});
	/** One of the scene's few paints. */
	std::size_t paint();

	void place(const std::string& body, const TriangleMesh& piece, const Eigen::Isometry3d& building_from_piece,
	           std::size_t material);
	/** A box between those spans of the frame. */
	void block(const std::string& body, const WallFrame& frame, const Span& along, const Span& behind, const Span& z,
	           std::size_t material);
};
}  // namespace explore::simulation

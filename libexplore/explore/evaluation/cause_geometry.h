// Geometry that the causes of errors are told by: true floor and camera against what perception found.
#pragma once

#include <explore/evaluation/causes.h>

#include <array>

namespace explore::evaluation
{
/** Middle of the opening on its floor, map frame. */
Eigen::Vector3d footOf(const TruthDoor& door);
/** The jambs on the floor plane, map frame. */
std::array<Eigen::Vector2d, 2> jambsOf(const Eigen::Vector2d& center, const Eigen::Vector2d& normal, double width_m);

class CauseGeometry
{
public:
	explicit CauseGeometry(const CauseInput& input);

	/** The camera's centre on the floor plane. */
	[[nodiscard]] Eigen::Vector2d camera() const { return m_map_from_camera.translation().head<2>(); }
	/** The floor that was found is more than 5° or 0.10 m off at `foot_in_map`; with the paper's method also: none was.
	 */
	[[nodiscard]] bool groundWrong(const Eigen::Vector3d& foot_in_map) const;
	/** Walls that were found within 10° and 0.20 m of the plane of an opening. */
	[[nodiscard]] int wallsAt(const Eigen::Vector2d& center, const Eigen::Vector2d& normal) const;
	/** The wall beside a jamb is not in the image: at one of the paper's scan heights above `floor_m`; with another
	 *  method over more than half of 2 m. */
	[[nodiscard]] bool besideImage(const std::array<Eigen::Vector2d, 2>& jambs, double floor_m) const;
	/** An obstacle stands between the camera and the opening or the wall beside it. */
	[[nodiscard]] bool behindObstacle(const std::array<Eigen::Vector2d, 2>& jambs) const;
	/** Share of the opening that lies within the image, whatever stands before it. */
	[[nodiscard]] double shareInImage(const TruthDoor& door) const;
	/** The floor's height in the map: that of the nearest true door, else 0. */
	[[nodiscard]] double floorNear(const Eigen::Vector2d& place) const;

private:
	[[nodiscard]] bool paperMethod() const;
	[[nodiscard]] bool inImage(const Eigen::Vector3d& point_in_map) const;

	const CauseInput& m_input;
	Eigen::Isometry3d m_map_from_robot, m_map_from_camera;
};
}  // namespace explore::evaluation

// Where a made-up scene is looked at from.
#pragma once

#include <explore/simulation/scenes/scene_sketch.h>

namespace explore::simulation
{
/** The part of a wall's face that a scene is about. */
struct Subject
{
	WallFrame frame;
	Span along;

	[[nodiscard]] Eigen::Vector2d low() const { return frame.at(along.low, 0); }
	[[nodiscard]] Eigen::Vector2d high() const { return frame.at(along.high, 0); }
	[[nodiscard]] Eigen::Vector2d middle() const { return frame.at(along.middle(), 0); }
};

struct ViewRange
{
	Span distance_m{1.0, 4.9};  ///< from the camera to the subject's middle
	Span offset_deg{0, 75};     ///< of the line of sight from the wall's normal
	double side = 0;            ///< of the normal: −1 = toward smaller along, 1 = toward larger, 0 = either
};

/** Places camera and robot so that both edges of the subject are in the image, and keeps furniture out of the robot, of
 *  the line of sight and of the way there. False, and an impossible sketch, where the range holds no such place. */
bool lookAt(Sketch& sketch, const Subject& subject, const ViewRange& range);
/** As lookAt(), but one edge is in the image and the other is not. */
bool lookPast(Sketch& sketch, const Subject& subject, const ViewRange& range);
/** Stands at `place`, looks along `yaw_rad`, and keeps furniture out of the robot. */
void standAt(Sketch& sketch, const Eigen::Vector2d& place, double yaw_rad);
/** Keeps the view onto the subject free of all but low things. */
void keepInSight(Sketch& sketch, const Subject& subject);
/** The subject as a region that has to be seen, between those heights. */
Region regionOf(const Subject& subject, const Span& z, const Span& share = {0.5, 1.0});
}  // namespace explore::simulation

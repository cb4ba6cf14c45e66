// What was reported against what truly is there, for the doors of one frame.
#pragma once

#include <explore/core/robot.h>
#include <explore/core/truth.h>
#include <explore/evaluation/tally.h>

#include <functional>
#include <optional>
#include <vector>

namespace explore::evaluation
{
/** A door of the frame's results, placed in the map by the robot's true pose. */
struct Report
{
	Door door;
	Eigen::Vector2d center_in_map;
	Eigen::Vector2d normal_in_map;  ///< unit
	bool positive = false;          ///< says that the robot can go through now: fitsThrough()
};
std::vector<Report> reportsOf(const std::vector<Door>& doors, const mrpt::poses::CPose3D& map_from_robot,
                              const RobotConfig& robot);

/** A true door that a robot can go through now: open, ajar or passage, and it fits. */
bool isPositive(const TruthDoor& door);
/** A true door that may be reported as passable or not: partly visible, or flown over. */
bool countsNeitherWay(const TruthDoor& door);

/** Stairs and shafts farther than kNearDoor_m from the camera are not scored: their floor is too far to be seen. */
bool isFarDrop(const TruthDoor& door, const Eigen::Vector2d& camera_in_map);

/** Distance of the centres on the floor plane [m]. */
double centerDistance(const Report& report, const TruthDoor& door);
/** The parts of that distance with their signs [m]. */
struct CenterError
{
	double along_m = 0;   ///< along the true wall, positive to the left as the camera sees it
	double across_m = 0;  ///< across it, positive toward the camera
};
CenterError centerError(const Report& report, const TruthDoor& door);
/** Reported − true [m]: of the clear widths where the true door is ajar, else of the widths. */
double widthError(const Report& report, const TruthDoor& door);
/** Centre within `tolerance_m` and width within kWidthTolerance_m. */
bool agrees(const Report& report, const TruthDoor& door, double tolerance_m);

enum class Outcome
{
	hit,          ///< a positive report and the visible positive door that it belongs to
	miss,         ///< a visible positive door without one
	false_alarm,  ///< a positive report without one
	ignored,      ///< a positive report at a door that counts neither way
	other,        ///< a report that is not positive, with or without the true door that it lies at; or a door that
	              ///< need not be found and was not
};
std::string_view nameOf(Outcome outcome);

/** Each report and each true door of the frame occurs in exactly one pair. */
struct DoorPair
{
	Outcome outcome = Outcome::other;
	std::optional<std::size_t> report, truth;
};

using DoorRule = std::function<bool(const TruthDoor&)>;

/** Hits by bestMatching() under `agrees`; then what is left. A positive report whose centre lies within the tolerance,
 *  or half the width, of a door that counts `neither_way` is ignored. */
std::vector<DoorPair> pairDoors(const std::vector<Report>& reports, const std::vector<TruthDoor>& truth,
                                double tolerance_m, const DoorRule& neither_way = countsNeitherWay);

/** Reports `open` of the pairs at places where nothing can be passed: no hit, not ignored, not at a positive door. */
std::size_t openWhereNothing(const std::vector<Report>& reports, const std::vector<TruthDoor>& truth,
                             const std::vector<DoorPair>& pairs, const DoorRule& neither_way);

/** Verdict against verdict, matched by the centres alone (main tolerance), for visible doors; reports at doors that are
 *  only partly visible are left out. Open and passage are the same while the lintel is out of view, and `blocked` is
 *  right or `open` where a MAV can fly over. */
Confusion confusionOf(const std::vector<Report>& reports, const std::vector<TruthDoor>& truth,
                      const DoorRule& neither_way = countsNeitherWay);
}  // namespace explore::evaluation

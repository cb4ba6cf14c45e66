// What an exploration left behind, for summary.json: the doors and corridors it knows, how far it got, and what it did
// not see.
#pragma once

#include <explore/navigation/left_over.h>
#include <explore/pipeline/explorer.h>

#include <optional>
#include <string>
#include <vector>

namespace explore
{
/** A confirmed track of a door. */
struct DoorSummary
{
	int track = 0;
	Eigen::Vector3d center_in_map = Eigen::Vector3d::Zero();
	double width_m = 0;
	std::optional<double> height_m;
	Verdict verdict = Verdict::open;
	double confidence = 0;
	int seen = 0;  ///< looks that showed it
	bool visited = false;
};

/** A confirmed track of a corridor. */
struct CorridorSummary
{
	int track = 0;
	Eigen::Vector3d point_in_map = Eigen::Vector3d::Zero();
	Eigen::Vector3d direction_in_map = Eigen::Vector3d::UnitX();
	int seen = 0;
};

struct ExplorationSummary
{
	bool complete = false;                ///< every frontier has a reason, and the robot is home
	bool finished = false;                ///< the robot has nothing more to do
	std::string end;                      ///< why the mission went home; empty = it did not
	std::optional<double> known_free_m2;  ///< of the robot's (lowest) layer
	std::optional<double> home_error_m;   ///< of the last pose, on the plan
	std::vector<DoorSummary> doors;
	std::vector<CorridorSummary> corridors;
	std::vector<LeftOver> left_over;
};

/** Of the robot's (lowest) layer. */
[[nodiscard]] double knownFreeArea(const FrontierMemory& memory);
[[nodiscard]] std::size_t confirmedDoors(const FrontierMemory& memory);

/** Of a state without memory all is empty. */
ExplorationSummary explorationSummary(const ExplorerState& state);
}  // namespace explore

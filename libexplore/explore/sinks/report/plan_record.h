// The map as it is at one time, seen from above, and the lines that tell how it grew.
#pragma once

#include <explore/sinks/json_values.h>
#include <explore/sinks/report/plan_grid.h>

#include <map>
#include <optional>

namespace explore
{
/** What the report's plan shows at one time, but for robot, way and goal. */
struct PlanSnapshot
{
	PlanGrid grid;
	std::map<int, Json> doors;      ///< by track: [x, y, azimuth of the normal, width, verdict, confidence, visited]
	std::map<int, Json> corridors;  ///< by track: [x, y, x, y, width or null], its ends
	double known_free_m2 = 0;
	std::optional<double> coverage;  ///< of what the robot can get to, where that is known, 0–1
};
PlanSnapshot planSnapshotOf(const FrontierMemory& memory);

/** When a snapshot was taken. */
struct PlanTime
{
	std::size_t frame = 0;
	double t_s = 0;  ///< since the first frame
};

/** One line of JSON: `i`, `t` the time, `free` `cover` as above, `at` [first_x, first_y, columns, rows, cell_m] of the
 * grid, `cells` its planChanges() in base64, `doors` and `corridors` that are new or changed, each [track, …], `gone`
 * and `ended` the tracks of those that are no more. */
std::string planRecord(const PlanSnapshot& from, const PlanSnapshot& to, const PlanTime& time);
/** Takes a snapshot on by a line of planRecord(); returns when it was taken. Throws what the JSON library and
 *  applyPlanChanges() throw where it is none. */
PlanTime applyPlanRecord(const std::string& record, PlanSnapshot& snapshot);
}  // namespace explore

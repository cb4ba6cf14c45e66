// Tables with a line for each group of scenes.
#pragma once

#include <explore/evaluation/figures.h>

#include <string>
#include <vector>

namespace explore::evaluation
{
/** What the lines tell of each group. */
enum class TableOf
{
	doors,            ///< precision, recall and counts
	recalls,          ///< of doors that must be found: recall and counts
	narrow_doors,     ///< the same of doors narrower than kNarrowDoor_m
	false_alarms,     ///< shares of frames with false alarms, `open` and any report
	tolerances,       ///< precision and recall by the tolerance of the centre
	hit_errors,       ///< widths and centres of the hits
	near_hit_errors,  ///< the same up to kNearDoor_m
	directions,       ///< of corridors
	headings,         ///< against the true free paths
	confidences,      ///< calibration and AUROC
};

/** The title and, below, a line for each of `groups` that has anything to tell; "" where none has. Ends in an empty
 *  line. */
std::string groupTable(TableOf what, const std::string& title, const std::vector<Group>& groups);
}  // namespace explore::evaluation

// Whether a depth frame shows the place of a door, and what it shows there: what a track is asked for that no report
// came of.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/memory/door_place.h>
#include <explore/perception/sensor_noise.h>

#include <functional>
#include <optional>

namespace explore
{
/** What the unoccluded rays through a door in plain view met; the rest came back with nothing. */
struct DoorView
{
	double through_share = 0;  ///< end behind it
	double shut_share = 0;     ///< end in the opening
};

/** No value: the door is not in plain view (out of the image, too near, too far, at a grazing angle, occluded). */
using DoorQuery = std::function<std::optional<DoorView>(const DoorPlace&)>;

struct DoorSightConfig
{
	double max_range_m = 5.0;                       ///< of either jamb
	double max_incidence_rad = 1.2217304763960306;  ///< 70°: at a more grazing angle a door is not expected to be found
	double min_share = 0.5;                         ///< of the opening's rays, and of either jamb's height in the image
};
/** Field list of the above; without a section of its own. */
void describe(FieldVisitor& fields, DoorSightConfig& config);

/** A door is in plain view when at least half of each jamb that the image holds is seen, at least half of the opening's
 *  rays end not in front of it, and both jambs are near enough. A jamb without return is not seen. Without an image
 *  there is no value. */
std::optional<DoorView> viewOf(const DepthFrame& frame, const DoorPlace& place, const DoorSightConfig& config,
                               const SensorNoiseConfig& noise);

/** viewOf() in `frame`, which must outlive the result. */
DoorQuery doorQuery(const DepthFrame& frame, const DoorSightConfig& config, const SensorNoiseConfig& noise);
}  // namespace explore

// The ways that lie open to the robot: per direction how far it is free, how far that was seen, and what it is worth.
#pragma once

#include <explore/navigation/avoider.h>
#include <explore/navigation/direction_fan.h>
#include <explore/navigation/open_path.h>
#include <explore/navigation/unseen_space.h>

#include <optional>
#include <vector>

namespace explore
{
/** One value for each direction of a fan; nothing (0, false) out of view, where it is known what is in view. */
struct WayFan
{
	std::vector<double> open_m;    ///< what obstacles leave free, as far as it was observed
	std::vector<double> worth_m;   ///< free length to be expected
	std::vector<bool> seen_start;  ///< whether most of what the hull first passes through was observed
};

/** The answers of a frame to questions about directions, by what config.method and config.leave_out say of obstacles
 * and of unseen space. */
class Ways
{
public:
	Ways(const AvoiderInput& input, const RobotConfig& robot, const AvoiderConfig& config);

	[[nodiscard]] WayFan along(const DirectionFan& fan) const;
	[[nodiscard]] WayFan along(const Direction& direction) const;
	/** Whether unseen space counts: then directions out of view are worth nothing. */
	[[nodiscard]] bool watchesUnseen() const { return m_sight.has_value(); }

private:
	/** What obstacles leave free. */
	[[nodiscard]] std::vector<double> openAlong(const DirectionFan& fan) const;
	/** As printed in the paper: d(θ) = min over p of max(0, |p · θ̂| − r), no corridor. */
	[[nodiscard]] std::vector<double> printedLengths(const DirectionFan& fan) const;
	[[nodiscard]] MovingBody bodyAt(double elevation_rad) const;

	LevelFrame m_level;
	RobotConfig m_robot;
	AvoiderConfig m_config;
	bool m_as_printed;
	PointCloud m_cropped_in_robot;  ///< the obstacles within ± sector, where the paper's crop is in force
	OpenPath m_open_path;
	std::optional<LevelSight> m_sight;
};
}  // namespace explore

// Where the camera was when something was seen, as coarse as is needed to say "from the same place".
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

namespace explore
{
/** Numbers the places of a moving camera: a new station begins where it is kHop_m away from the last one's first pose.
 */
class Stations
{
public:
	static constexpr double kHop_m = 0.25;
	static constexpr int kRecent =
	    4;  ///< so many stations count as the same place: the camera has moved 1.25 m at most
	/** Whoever is farther than this from where he was is at none of the recent stations. */
	static constexpr double kForgotten_m = kHop_m * (kRecent + 1);

	Stations() { m_origins.fill(Eigen::Vector3d::Zero()); }

	/** Returns whether the numbers had to begin anew: all that were given out before are to be forgotten. */
	bool moveTo(const Eigen::Vector3d& camera_in_map);

	/** From 1 on; 0 stands for never. */
	[[nodiscard]] std::uint16_t current() const { return m_current; }
	[[nodiscard]] bool isRecent(std::uint16_t station) const { return station != 0 && m_current - station < kRecent; }
	/** Where a recent station began, map frame [m]. */
	[[nodiscard]] const Eigen::Vector3d& origin(std::uint16_t station) const { return m_origins[station % kRecent]; }

	/** Writes or reads all of it. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_current), archive(m_origins);
	}

private:
	std::uint16_t m_current = 0;
	std::array<Eigen::Vector3d, kRecent> m_origins;
};
}  // namespace explore

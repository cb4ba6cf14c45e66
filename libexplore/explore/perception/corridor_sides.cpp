#include <explore/perception/corridor_sides.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kOpening_m = 0.5;  ///< both sides open for longer: the walls have to prove that they go on
constexpr double kWidestDoor_m = 1.5;
constexpr double kProof_m = 1.0, kProven_m = 0.4;  ///< so much wall on either side, within so much behind it
constexpr int kFewestPoints = 2;                   ///< of a strip that has wall by its points

/** One side's plane and how densely its strips are met. */
struct SideLine
{
	float distance_m;  ///< of the plane from the camera
	float half_spacing_rad;
	float tolerance_m, sigmas;
};

int stripAt(float along_m)
{
	const float strip =
	    std::floor((along_m - static_cast<float>(SideProfile::kFirst_m)) / static_cast<float>(SideProfile::kStrip_m));
	return static_cast<int>(std::clamp(strip, -1.0F, static_cast<float>(SideProfile::kStrips)));
}

void count(std::array<int, SideProfile::kStrips>& strips, int first, int last)
{
	last = std::min(last, static_cast<int>(SideProfile::kStrips) - 1);
	for (int strip = std::max(first, 0); strip <= last; ++strip) ++strips[static_cast<std::size_t>(strip)];
}

/** A point `across` to this side (positive outward). True: it is on the wall. */
bool add(SideProfile& profile, const SideLine& side, float along, float across, float sigma_per_m)
{
	const float tolerance = side.tolerance_m + side.sigmas * sigma_per_m * across;
	if (across < side.distance_m - tolerance) return false;
	// Where the ray crosses the plane: surer than where noisy depth puts the point.
	const float crossing = along * side.distance_m / across;
	const float reach =
	    side.half_spacing_rad * (crossing * crossing + side.distance_m * side.distance_m) / side.distance_m;
	const int first = stripAt(crossing - reach), last = stripAt(crossing + reach);
	const bool on = across <= side.distance_m + tolerance;
	count(on ? profile.on : profile.behind, first, last);
	return on;
}

/** How many strips are wall up to each. */
class WallCounts
{
public:
	explicit WallCounts(const SideProfile& side)
	{
		for (std::size_t strip = 0; strip < SideProfile::kStrips; ++strip)
			m_before[strip + 1] = m_before[strip] + (side.isWall(strip) ? 1 : 0);
	}
	/** The first strip that is wall; kStrips without one. */
	[[nodiscard]] std::size_t first() const
	{
		return static_cast<std::size_t>(std::ranges::upper_bound(m_before, 0) - m_before.begin() - 1);
	}
	/** One behind the last of the first `strips`. */
	[[nodiscard]] std::size_t lastOf(std::size_t strips) const
	{
		return static_cast<std::size_t>(std::ranges::lower_bound(m_before, m_before[strips]) - m_before.begin());
	}
	[[nodiscard]] int between(std::size_t from, std::size_t to) const { return m_before[to] - m_before[from]; }

private:
	std::array<int, SideProfile::kStrips + 1> m_before{};
};

/** The strip at which both sides open for good; kStrips where they do not. */
std::size_t openingOf(const SideProfiles& sides, std::size_t first)
{
	const auto proven = [&](double from_m)
	{
		return std::min(sides.left.pointsBetween(from_m, from_m + kProof_m),
		                sides.right.pointsBetween(from_m, from_m + kProof_m)) >= kProven_m;
	};
	std::size_t open = 0;  // strips in a row
	for (std::size_t strip = first; strip < SideProfile::kStrips; ++strip)
	{
		const double open_m = static_cast<double>(open) * SideProfile::kStrip_m;
		const bool is_open = sides.left.isOpen(strip) && sides.right.isOpen(strip);
		const bool ended =
		    is_open ? open_m > kWidestDoor_m : open_m > kOpening_m && !proven(SideProfile::along_m(strip));
		if (ended) return strip - open;
		open = is_open ? open + 1 : 0;
	}
	return SideProfile::kStrips;
}

template <class Is>
double lengthBetween(double from_m, double to_m, Is is)
{
	int strips = 0;
	for (std::size_t strip = 0; strip < SideProfile::kStrips; ++strip)
		if (SideProfile::along_m(strip) > from_m && SideProfile::along_m(strip) < to_m && is(strip)) ++strips;
	return strips * SideProfile::kStrip_m;
}
}  // namespace

double SideProfile::wallBetween(double from_m, double to_m) const
{
	return lengthBetween(from_m, to_m, [this](std::size_t strip) { return isWall(strip); });
}

double SideProfile::pointsBetween(double from_m, double to_m) const
{
	return lengthBetween(from_m, to_m, [this](std::size_t strip) { return points[strip] >= kFewestPoints; });
}

bool runsAlong(std::size_t i, const PlanPoints& points, const TurnedPoints& turned, double spacing_rad)
{
	if (i == 0 || i + 1 >= points.size() || points.row[i - 1] != points.row[i + 1]) return false;
	const double apart = std::abs(turned.across[i + 1] - turned.across[i - 1]);
	return apart < std::abs(turned.along[i]) * spacing_rad;
}

SideProfiles sideProfiles(const FacingWalls& pair, const PlanPoints& points, const TurnedPoints& turned,
                          double spacing_rad, const UprightWallConfig& config)
{
	const auto side_at = [&](double distance_m)
	{
		return SideLine{static_cast<float>(distance_m), static_cast<float>(0.5 * spacing_rad),
		                static_cast<float>(config.tolerance_m), static_cast<float>(config.tolerance_sigmas)};
	};
	const SideLine left = side_at(pair.left_m), right = side_at(pair.right_m);
	SideProfiles sides;
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const float along = turned.along[i], across = turned.across[i], sigma = points.sigma_per_m[i];
		SideProfile& profile = across > 0 ? sides.left : sides.right;
		if (!add(profile, across > 0 ? left : right, along, std::abs(across), sigma)) continue;
		const int strip = stripAt(along);
		if (runsAlong(i, points, turned, spacing_rad)) count(profile.points, strip, strip);
	}
	return sides;
}

std::optional<Overlap> overlapOf(const SideProfiles& sides, double share)
{
	const WallCounts left(sides.left), right(sides.right);
	const std::size_t first = std::max(left.first(), right.first());
	const std::size_t opening = openingOf(sides, first);
	for (std::size_t end = std::min(left.lastOf(opening), right.lastOf(opening)); end > first; --end)
	{
		const double fewest = share * static_cast<double>(end - first);
		if (std::min(left.between(first, end), right.between(first, end)) < fewest) continue;
		const double half_m = 0.5 * SideProfile::kStrip_m;
		return Overlap{SideProfile::along_m(first) - half_m, SideProfile::along_m(end) - half_m};
	}
	return std::nullopt;
}
}  // namespace explore

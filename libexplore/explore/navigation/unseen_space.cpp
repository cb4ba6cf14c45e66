#include <explore/navigation/unseen_space.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore
{
namespace
{
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr std::size_t kBearings = 180;
constexpr double kBearing_rad = kTurn / kBearings;
constexpr double kRing_m = 0.1;

/** Obstacles per square metre. */
constexpr double kBlind = 0.3, kDark = 30.0;
/** Of the rays through a cell: fewer clear ones leave it dark. */
constexpr double kClearShare = 0.5;
/** The body's heights come into view nearer than this, or nothing is known of the stretch before. */
constexpr double kLongestBlind_m = 2.0;
/** A way is known until so many obstacles are to be expected. */
constexpr double kSurprise = 0.7;
/** The robot moves where of the first stretch no more than this share was unseen. */
constexpr double kFirst_m = 0.5, kUnseenShare = 0.4;

/** Where along a ray the body's heights are, horizontal metres. */
struct Stretch
{
	double from_m, to_m;
};
Stretch atBodyHeight(const LevelRay& ray, const MovingBody& body, double camera_z, double range_m)
{
	const double rise = ray.slope - body.slope, low = body.low_m - camera_z, high = body.high_m - camera_z;
	if (std::abs(rise) < 1e-6) return low <= 0.0 && high >= 0.0 ? Stretch{0.0, range_m} : Stretch{0.0, 0.0};
	const double a = low / rise, b = high / rise;
	return {std::max(0.0, std::min(a, b)), std::min(range_m, std::max(a, b))};
}
}  // namespace

/** Rays through each cell: how many pass it at the body's heights, how many are clear up to it, how many have ended at
 *  something seen before. Sums are taken outward when all rays are in. */
struct UnseenSpace::Polar
{
	struct Cell
	{
		int passing = 0, clear = 0, ended = 0;
	};
	explicit Polar(double range_m)
	    : rings(static_cast<std::size_t>(std::ceil(range_m / kRing_m)) + 1), cells(kBearings * (rings + 1))
	{
	}
	void add(const LevelRay& ray, const MovingBody& body, double camera_z)
	{
		const double range_m = static_cast<double>(rings) * kRing_m;
		const Stretch stretch = atBodyHeight(ray, body, camera_z, range_m);
		if (!(stretch.from_m < stretch.to_m)) return;
		const auto bearing = static_cast<std::size_t>((ray.bearing_rad + kTurn) / kBearing_rad) % kBearings;
		const auto at = [&](double distance_m) -> Cell&
		{
			const auto ring = static_cast<std::size_t>(std::clamp(distance_m, 0.0, range_m) / kRing_m);
			return cells[bearing * (rings + 1) + std::min(ring, rings)];
		};
		const bool meets = ray.hit_m > 0.0F && ray.hit_m >= stretch.from_m && ray.hit_m < stretch.to_m;
		const double passes_to_m = meets ? ray.hit_m : stretch.to_m;
		++at(stretch.from_m).passing, --at(passes_to_m).passing;
		if (meets) ++at(ray.hit_m).ended;
		if (ray.clear_m <= stretch.from_m) return;
		const double clear_to_m = std::min<double>(passes_to_m, ray.clear_m);
		++at(stretch.from_m).clear, --at(clear_to_m).clear;
	}
	void sum()
	{
		for (std::size_t bearing = 0; bearing < kBearings; ++bearing)
			for (std::size_t ring = 1; ring <= rings; ++ring)
			{
				Cell& cell = cells[bearing * (rings + 1) + ring];
				const Cell& before = cells[bearing * (rings + 1) + ring - 1];
				cell.passing += before.passing, cell.clear += before.clear, cell.ended += before.ended;
			}
	}
	[[nodiscard]] const Cell& cell(std::size_t bearing, std::size_t ring) const
	{
		return cells[bearing * (rings + 1) + ring];
	}
	[[nodiscard]] bool isDark(std::size_t bearing, std::size_t ring) const
	{
		return cell(bearing, ring).clear < kClearShare * cell(bearing, ring).passing;
	}
	/** The first ring that the image shows; `rings` when it shows none. */
	[[nodiscard]] std::size_t firstInView(std::size_t bearing) const
	{
		std::size_t ring = 0;
		while (ring < rings && cell(bearing, ring).passing == 0) ++ring;
		return ring;
	}

	/** Of each bearing the angle to the nearest one in view, at most a right angle. */
	[[nodiscard]] std::vector<double> anglesFromView() const
	{
		std::vector<double> angles(kBearings, 0.5 * std::numbers::pi);
		const auto spread = [&](std::size_t from, std::size_t to)
		{ angles[to] = firstInView(to) < rings ? 0.0 : std::min(angles[to], angles[from] + kBearing_rad); };
		for (std::size_t i = 0; i < 2 * kBearings; ++i) spread(i % kBearings, (i + 1) % kBearings);
		for (std::size_t i = 2 * kBearings; i-- > 0;) spread((i + 1) % kBearings, i % kBearings);
		return angles;
	}

	std::size_t rings;
	std::vector<Cell> cells;
};

UnseenSpace::UnseenSpace(const LevelSight& sight, const MovingBody& body, double range_m)
    : m_radius_m(body.radius_m), m_range_m(range_m)
{
	Polar polar(range_m + body.radius_m);
	for (const LevelRay& ray : sight.rays) polar.add(ray, body, sight.camera.z());
	polar.sum();
	addCells(polar, sight.camera);
}

void UnseenSpace::addCells(const Polar& polar, const Eigen::Vector3d& camera)
{
	const std::vector<double> aside_rad = polar.anglesFromView();
	constexpr std::size_t kWatched = 3;  // rings behind a blind stretch: what is dark there reaches into it
	const auto blind_rings = static_cast<std::size_t>(kLongestBlind_m / kRing_m);
	for (std::size_t bearing = 0; bearing < kBearings; ++bearing)
	{
		const std::size_t first = polar.firstInView(bearing);
		bool dark_start = true;
		for (std::size_t ring = first; ring < std::min(first + kWatched, polar.rings); ++ring)
			dark_start = dark_start && polar.isDark(bearing, ring);
		for (std::size_t ring = 0; ring < polar.rings; ++ring)
		{
			const Polar::Cell& seen = polar.cell(bearing, ring);
			const bool before_view = first <= blind_rings && ring < first;
			const bool dark = before_view ? dark_start : polar.isDark(bearing, ring);
			const bool blind = !before_view && seen.passing == 0 && seen.ended == 0;
			if (!dark && !blind) continue;
			const double distance_m = (static_cast<double>(ring) + 0.5) * kRing_m;
			// No way in view comes near it.
			if (distance_m * std::sin(aside_rad[bearing]) > 2.0 * m_radius_m) continue;
			const double azimuth = (static_cast<double>(bearing) + 0.5) * kBearing_rad;
			const Eigen::Vector2d middle =
			    camera.head<2>() + distance_m * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
			m_cells.push_back({static_cast<float>(middle.x()), static_cast<float>(middle.y()),
			                   static_cast<float>(middle.norm()),
			                   static_cast<float>(std::atan2(middle.y(), middle.x())),
			                   static_cast<float>(distance_m * kRing_m * kBearing_rad), dark});
		}
	}
}

namespace
{
/** What there is to meet along one way. */
struct Hazards
{
	std::vector<double> obstacles;  ///< to be expected, by the travelled length in steps of kRing_m
	double unseen_start_m2 = 0;     ///< area that the hull sweeps unseen in the first stretch
};

/** Mean free length; `known_m` receives the length up to which there is little to expect. */
double meanLength(const Hazards& hazards, double open_m, double& known_m)
{
	double mean_m = 0.0, sum = 0.0;
	known_m = 0.0;
	for (std::size_t i = 0; i < hazards.obstacles.size(); ++i)
	{
		const double step_m = std::min(kRing_m, open_m - static_cast<double>(i) * kRing_m);
		if (!(step_m > 0.0)) break;
		sum += hazards.obstacles[i];
		mean_m += step_m * std::exp(-sum);
		if (sum < kSurprise) known_m += step_m;
	}
	return mean_m;
}
}  // namespace

WayLengths UnseenSpace::along(const DirectionFan& fan, const std::vector<double>& open_m) const
{
	const auto steps = static_cast<std::size_t>(m_range_m / kRing_m) + 1;
	std::vector<Hazards> hazards(fan.count, {std::vector<double>(steps), 0.0});
	const double level_cosine = std::cos(fan.elevation_rad);
	std::vector<Eigen::Vector2d> ahead(fan.count);
	for (std::size_t k = 0; k < fan.count; ++k)
		ahead[k] = Eigen::Vector2d(std::cos(fan.at(k).azimuth_rad), std::sin(fan.at(k).azimuth_rad));
	for (const Cell& cell : m_cells)
	{
		if (cell.distance_m <= m_radius_m) continue;
		const double expected = cell.area_m2 * (cell.dark ? kDark : kBlind);
		const auto meet = [&](std::size_t k)
		{
			const double forward = cell.x * ahead[k].x() + cell.y * ahead[k].y();
			const double aside = cell.y * ahead[k].x() - cell.x * ahead[k].y();
			const double half_chord2 = m_radius_m * m_radius_m - aside * aside;
			if (forward <= 0.0 || half_chord2 <= 0.0) return;
			const double travel_m = (forward - std::sqrt(half_chord2)) / level_cosine;
			if (travel_m >= open_m[k]) return;
			hazards[k].obstacles[static_cast<std::size_t>(std::max(0.0, travel_m) / kRing_m)] += expected;
			if (travel_m < kFirst_m) hazards[k].unseen_start_m2 += cell.area_m2;
		};
		forEachNear(fan, cell.azimuth_rad, std::asin(m_radius_m / cell.distance_m), meet);
	}
	WayLengths lengths{std::vector<double>(fan.count), std::vector<double>(fan.count), {}};
	for (std::size_t k = 0; k < fan.count; ++k)
	{
		lengths.expected_m[k] = meanLength(hazards[k], open_m[k], lengths.known_m[k]);
		const double swept_m2 = 2.0 * m_radius_m * std::min(kFirst_m, std::max(open_m[k], kRing_m));
		lengths.seen_start.push_back(hazards[k].unseen_start_m2 <= kUnseenShare * swept_m2);
	}
	return lengths;
}
}  // namespace explore

#include <explore/core/geometry.h>
#include <explore/memory/view_gain.h>

#include <cmath>
#include <limits>

namespace explore
{
namespace
{
constexpr double kPi = std::numbers::pi;
/** The circle in sectors, each with a ray in its middle; sector 0 begins at yaw 0. */
constexpr int kSectors = 360;
constexpr double kSector_rad = 2.0 * kPi / kSectors;

/** One axis of a walk from cell to cell along a ray (Amanatides and Woo 1987). */
struct AxisWalk
{
	int cell, step;
	double next, between;  ///< distance along the ray [cells] to the next face, and from face to face

	AxisWalk(double start, double direction)
	    : cell(static_cast<int>(std::floor(start))),
	      step(direction < 0.0 ? -1 : 1),
	      next(std::numeric_limits<double>::infinity()),
	      between(next)
	{
		if (direction == 0.0) return;
		between = 1.0 / std::abs(direction);
		next = (direction < 0.0 ? start - cell : cell + 1 - start) * between;
	}
	void advance()
	{
		cell += step;
		next += between;
	}
};

/** Casts rays from one place. Lengths are in cells. */
class Rays
{
public:
	Rays(const BodyLayers& layers, const ViewPlace& place, const ViewConfig& config)
	    : m_layers(layers),
	      m_layer(place.layer),
	      m_start(place.camera_in_map / layers.frame().resolution_m - layers.frame().first.cast<double>()),
	      m_near(config.min_range_m / layers.frame().resolution_m),
	      m_far(config.range_m / layers.frame().resolution_m),
	      m_max_unknown(config.max_unknown_m / layers.frame().resolution_m)
	{
	}

	/** Area of unknown [m²] that is seen in the sector. */
	[[nodiscard]] double gainOf(int sector) const
	{
		const double yaw_rad = (sector + 0.5) * kSector_rad, edge_m = m_layers.frame().resolution_m;
		return 0.5 * kSector_rad * edge_m * edge_m * unknownAlong({std::cos(yaw_rad), std::sin(yaw_rad)});
	}

private:
	/** Sum of end² − begin² over the pieces of the ray that lie in unknown cells. */
	[[nodiscard]] double unknownAlong(const Eigen::Vector2d& direction) const
	{
		AxisWalk x(m_start.x(), direction.x()), y(m_start.y(), direction.y());
		double begin = 0.0, rest = m_max_unknown, sum = 0.0;
		while (begin < m_far && rest > 0.0)
		{
			const CellState state = m_layers.stateOf({x.cell, y.cell, m_layer});
			if (state == CellState::occupied) break;
			double end = std::min({x.next, y.next, m_far});
			if (state == CellState::unknown)
			{
				const double seen_to = std::min(end, begin + rest), seen_from = std::max(begin, m_near);
				if (seen_to > seen_from) sum += seen_to * seen_to - seen_from * seen_from;
				rest -= end - begin;
			}
			(x.next < y.next ? x : y).advance();
			begin = end;
		}
		return sum;
	}

	const BodyLayers& m_layers;
	int m_layer;
	Eigen::Vector2d m_start;
	double m_near, m_far, m_max_unknown;
};

/** The field of view, in sectors from yaw 0 on. */
struct Wedge
{
	double first, last = 0.0;

	/** `first` is not negative. */
	Wedge(double yaw_rad, double fov_rad) : first((yaw_rad - 0.5 * fov_rad) / kSector_rad)
	{
		first -= kSectors * std::floor(first / kSectors);
		last = first + std::min(fov_rad / kSector_rad, static_cast<double>(kSectors));
	}
};
}  // namespace

void describe(FieldVisitor& fields, ViewConfig& config)
{
	fields.section("view", "What a look from a place is taken to show.");
	fields.degrees("fov_deg", config.fov_rad, {1.0, 360.0}, "The camera's horizontal field of view.");
	fields.real("min_range", config.min_range_m, {0.0, 5.0}, "m", "The camera is blind for what is nearer.");
	fields.real("range", config.range_m, {0.5, 20.0}, "m", "What is farther does not count.");
	fields.real("max_unknown", config.max_unknown_m, {0.05, 20.0}, "m",
	            "How far through unknown space a look is taken to reach.");
}

double viewGain(const BodyLayers& layers, const ViewPlace& place, double yaw_rad, const ViewConfig& config)
{
	const Rays rays(layers, place, config);
	const Wedge wedge(yaw_rad, config.fov_rad);
	double sum_m2 = 0.0;
	for (int sector = static_cast<int>(wedge.first); sector < wedge.last; ++sector)
	{
		const double share = std::min(wedge.last, sector + 1.0) - std::max(wedge.first, static_cast<double>(sector));
		sum_m2 += share * rays.gainOf(sector);
	}
	return sum_m2;
}

double yawOf(int i)
{
	return wrapToPi(i * (2.0 * kPi / kYaws));
}

std::array<double, kYaws> viewGains(const BodyLayers& layers, const ViewPlace& place, const ViewConfig& config)
{
	const Rays rays(layers, place, config);
	std::array<double, 2 * kSectors + 1> up_to_m2{};  // sector i, over two turns
	for (int sector = 0; sector < kSectors; ++sector)
		up_to_m2[static_cast<std::size_t>(sector) + 1] = rays.gainOf(sector);
	for (std::size_t i = 1; i <= kSectors; ++i) up_to_m2[i + kSectors] = up_to_m2[i];
	for (std::size_t i = 1; i < up_to_m2.size(); ++i) up_to_m2[i] += up_to_m2[i - 1];
	const auto up_to = [&](double sector)
	{
		const std::size_t whole = std::min(static_cast<std::size_t>(sector), up_to_m2.size() - 2);
		const double part = sector - static_cast<double>(whole);
		return (1.0 - part) * up_to_m2[whole] + part * up_to_m2[whole + 1];
	};
	std::array<double, kYaws> gains_m2{};
	for (int i = 0; i < kYaws; ++i)
	{
		const Wedge wedge(yawOf(i), config.fov_rad);
		gains_m2[static_cast<std::size_t>(i)] = up_to(wedge.last) - up_to(wedge.first);
	}
	return gains_m2;
}

BestYaw bestYaw(const BodyLayers& layers, const ViewPlace& place, const ViewConfig& config)
{
	const std::array<double, kYaws> gains_m2 = viewGains(layers, place, config);
	const auto best = std::ranges::max_element(gains_m2);
	return {yawOf(static_cast<int>(best - gains_m2.begin())), *best};
}
}  // namespace explore

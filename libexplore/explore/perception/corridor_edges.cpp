#include <explore/perception/corridor_edges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace explore
{
namespace
{
/** A row is followed for so many samples: the shadow of a structured-light camera beside an edge is narrower. */
constexpr int kFollow_samples = 6;

/** A row that shows the edge. */
struct EdgeRow
{
	double along_m, height_m;
	bool behind;  ///< something is seen behind the wall's plane, next to the edge
};

/** The plane of one side as the pixels of the image see it. `across` is positive outward. */
class SidePlane
{
public:
	SidePlane(Side side, const FacingWalls& pair, const LevelView& view)
	    : m_image(*view.image),
	      m_toward(side == Side::left ? 1 : -1),
	      m_follow_px(kFollow_samples * view.samples.stride),
	      m_distance_m(side == Side::left ? pair.left_m : pair.right_m),
	      m_camera_height_m(view.pose.cameraHeight_m())
	{
		const Eigen::Matrix3d camera_from_level = view.pose.level_from_camera.linear().transpose();
		const Eigen::Vector2d outward = m_toward * leftOf(pair.direction);
		m_along = camera_from_level * Eigen::Vector3d(pair.direction.x(), pair.direction.y(), 0.0);
		m_across = camera_from_level * Eigen::Vector3d(outward.x(), outward.y(), 0.0);
		m_up = camera_from_level * Eigen::Vector3d::UnitZ();
	}

	/** From a pixel on the wall along its row to where the wall ends; no value where it does not, where something in
	 *  front hides that, and at the border of the image. */
	[[nodiscard]] std::optional<EdgeRow> follow(int u, int v, double tolerance_m) const
	{
		int on = u;
		for (int step = 1; step <= m_follow_px; ++step)
		{
			const int here = u + m_toward * step;
			if (here < 0 || here >= m_image.intrinsics.width_px) return std::nullopt;
			const double depth = m_image.at(here, v);
			if (depth <= 0) continue;
			const double behind_m = depth * m_across.dot(rayOfPixel(m_image.intrinsics, here, v)) - m_distance_m;
			if (behind_m > tolerance_m) return edgeBeside(on, v, true);
			if (behind_m < -tolerance_m) return std::nullopt;
			on = here;
		}
		const bool is_gap = std::abs(on - u) <= m_follow_px / 2;
		return is_gap ? std::optional(edgeBeside(on, v, false)) : std::nullopt;
	}

private:
	/** Where the ray along the outer side of the last pixel on the wall meets its plane. */
	[[nodiscard]] EdgeRow edgeBeside(int on, int v, bool behind) const
	{
		const Eigen::Vector3d ray = rayOfPixel(m_image.intrinsics, on + 0.5 * m_toward, v);
		const double depth = m_distance_m / m_across.dot(ray);
		return {depth * m_along.dot(ray), m_camera_height_m + depth * m_up.dot(ray), behind};
	}

	const DepthImage& m_image;
	int m_toward;  ///< in which direction of the row the wall recedes
	int m_follow_px;
	double m_distance_m, m_camera_height_m;
	Eigen::Vector3d m_along, m_across, m_up;
};

/** The rows in which the side's wall ends, in any order. */
std::vector<EdgeRow> edgeRows(Side side, const FacingWalls& pair, const LevelView& view, const PlanPoints& points,
                              const TurnedPoints& turned, double max_along_m, const UprightWallConfig& walls)
{
	const SidePlane plane(side, pair, view);
	const LevelSamples& samples = view.samples;
	const float outward = side == Side::left ? 1.0F : -1.0F;
	const auto distance = static_cast<float>(side == Side::left ? pair.left_m : pair.right_m);
	const auto base = static_cast<float>(walls.tolerance_m), sigmas = static_cast<float>(walls.tolerance_sigmas);
	const auto furthest = static_cast<float>(max_along_m);
	const auto tolerance_of = [&](std::size_t i)
	{ return base + sigmas * points.sigma_per_m[i] * std::abs(turned.across[i]); };
	const auto is_before_plane = [&](std::size_t i) { return outward * turned.across[i] < distance + tolerance_of(i); };
	const auto is_neighbour = [&](std::size_t i, std::size_t k)
	{
		const std::uint32_t a = points.sample[i], b = points.sample[k];
		return samples.v[a] == samples.v[b] && std::abs(samples.u[a] - samples.u[b]) <= samples.stride;
	};
	std::vector<EdgeRow> rows;
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const float off = outward * turned.across[i] - distance, tolerance = tolerance_of(i);
		if (std::abs(off) > tolerance || turned.along[i] > furthest) continue;
		const std::size_t next = side == Side::left ? i + 1 : i - 1;  // wraps to a place behind the last
		if (next < points.size() && is_neighbour(i, next) && is_before_plane(next)) continue;
		const std::uint32_t sample = points.sample[i];
		const auto row = plane.follow(samples.u[sample], samples.v[sample], tolerance);
		if (row && row->along_m > 0 && row->along_m <= max_along_m) rows.push_back(*row);
	}
	return rows;
}

/** The furthest group of rows that agree; they are sorted by `along_m`. */
std::optional<SideEdge> furthestGroup(const std::vector<EdgeRow>& sorted, const SideEdgeConfig& config,
                                      double distance_m, double pixel_rad)
{
	const auto fewest = static_cast<std::size_t>(config.min_rows);
	for (std::size_t end = sorted.size(); end >= fewest; --end)
	{
		const double furthest = sorted[end - 1].along_m;
		const double apart = config.apart_m + 2.0 * pixel_rad * (furthest * furthest / distance_m + distance_m);
		std::size_t first = end - 1;
		while (first > 0 && furthest - sorted[first - 1].along_m <= apart) --first;
		if (end - first < fewest) continue;
		SideEdge edge{sorted[(first + end) / 2].along_m, static_cast<int>(end - first), 0, sorted[first].height_m,
		              sorted[first].height_m};
		for (std::size_t i = first; i < end; ++i)
		{
			edge.rows_behind += sorted[i].behind ? 1 : 0;
			edge.lowest_m = std::min(edge.lowest_m, sorted[i].height_m);
			edge.highest_m = std::max(edge.highest_m, sorted[i].height_m);
		}
		if (edge.highest_m - edge.lowest_m >= config.min_height_m) return edge;
	}
	return std::nullopt;
}
}  // namespace

void describe(FieldVisitor& fields, SideEdgeConfig& config)
{
	fields.integer("edge_min_rows", config.min_rows, {1, 1000}, "",
	               "Rows of the thinned image that show the edge of a corridor's side wall and something behind it.");
	fields.integer("edge_min_sharp_rows", config.min_sharp_rows, {1, 1000}, "",
	               "The same where nothing behind the edge returns.");
	fields.real("edge_min_height", config.min_height_m, {0.05, 3.0}, "m", "Heights over which the edge is seen.");
	fields.real("edge_max_range", config.max_along_m, {1.0, 20.0}, "m", "Furthest edge, along the corridor.");
	fields.real("edge_apart", config.apart_m, {0.01, 1.0}, "m", "Rows of one edge agree within this and two pixels.");
	fields.integer("edge_min_floor_samples", config.min_floor_samples, {1, 10000}, "",
	               "Thinned samples of the floor behind an edge that show its space where nothing else does.");
}

bool isTrueEdge(const SideEdge& edge, int floor_samples, const SideEdgeConfig& config)
{
	return edge.rows_behind >= config.min_rows || floor_samples >= config.min_floor_samples ||
	       edge.rows >= config.min_sharp_rows;
}

std::optional<SideEdge> furthestEdge(Side side, const FacingWalls& pair, const LevelView& view,
                                     const PlanPoints& points, const TurnedPoints& turned, const SideEdgeConfig& config,
                                     const UprightWallConfig& walls)
{
	std::vector<EdgeRow> rows = edgeRows(side, pair, view, points, turned, config.max_along_m, walls);
	std::ranges::sort(rows, {}, &EdgeRow::along_m);
	const double distance = side == Side::left ? pair.left_m : pair.right_m;
	return furthestGroup(rows, config, distance, 1.0 / view.image->intrinsics.fx_px);
}
}  // namespace explore

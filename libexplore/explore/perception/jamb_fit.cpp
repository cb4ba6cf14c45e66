#include <explore/perception/jamb_fit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace explore
{
namespace
{
constexpr double kBin_m = 0.005;
constexpr std::size_t kMaxBins = 128;
constexpr int kEnoughRays = 4000;  // more rows do not make the edge sharper
constexpr int kFewOfJamb = 12;
constexpr double kCasing_m = 0.05;  // wide, at least
constexpr double kThickest_m = 0.04;
constexpr double kFace_m = 0.02;    // inside an edge, where its jamb's face is looked for
constexpr double kOnEdge_m = 0.04;  // a surface this near to the edge touches it

/** Rays by their distance from the guess, increasing from the opening outward. */
struct EdgeHistogram
{
	std::array<int, kMaxBins> outside{};     ///< wall, or what stands before it
	std::array<int, kMaxBins> inside{};      ///< lead behind the wall
	std::array<int, kMaxBins> near_plane{};  ///< of `outside`: on the wall or beside it
	std::array<int, kMaxBins> on_wall{};     ///< of `outside`: on the wall
	std::array<int, kMaxBins> shallow{};     ///< of `inside`: end a little behind the wall
	std::array<int, kMaxBins> missing{};     ///< without return
	std::array<int, kMaxBins> all{};
	std::size_t bins = 0;
	std::array<float, kMaxBins> front_sum_m{};  ///< over `near_plane`: how far before the plane
	double ray_width_m = 0;                     ///< between neighbouring columns, on the wall
};

struct EdgeChoice
{
	std::size_t bin = 0;  ///< the first one outside
	int wrong = 0, outside = 0, inside = 0;
};

/** The bin from which on rays count as outside with the fewest mistakes. Where no ray decides (no returns beside an
 *  edge) the outermost: a surface's edge is where the surface begins. */
EdgeChoice bestEdge(const std::array<int, kMaxBins>& outside, const std::array<int, kMaxBins>& inside, std::size_t bins,
                    std::size_t back_off)
{
	EdgeChoice best;
	for (std::size_t i = 0; i < bins; ++i) best.inside += inside.at(i), best.outside += outside.at(i);
	int wrong = best.inside;  // all counted as outside
	best.wrong = wrong;
	std::size_t first_best = 0;
	for (std::size_t i = 0; i < bins; ++i)
	{
		wrong += outside.at(i) - inside.at(i);
		if (wrong < best.wrong) first_best = i + 1;
		if (wrong <= best.wrong) best.wrong = wrong, best.bin = i + 1;
	}
	best.bin = std::max(first_best, best.bin > back_off ? best.bin - back_off : 0);
	return best;
}

EdgeHistogram histogramAround(const RayJudge& judge, double guess_m, JambSide side, const RayEvidenceConfig& band,
                              const JambConfig& config)
{
	EdgeHistogram edge;
	edge.bins = std::min(kMaxBins, static_cast<std::size_t>(std::lround(2.0 * config.search_m / kBin_m)));
	const double half_m = 0.5 * static_cast<double>(edge.bins) * kBin_m;
	const PixelBox box = judge.rays().boxOf({guess_m - half_m, guess_m + half_m, band.bottom_m, band.top_m});
	if (box.empty()) return edge;
	const int step = std::max(1, box.pixels() / kEnoughRays);
	const float sign = side == JambSide::right ? 1.0F : -1.0F;
	const auto first_m = static_cast<float>(guess_m) - sign * static_cast<float>(half_m);
	const auto bins = static_cast<float>(edge.bins);
	for (int v = box.first_v; v <= box.last_v; v += step)
		for (int u = box.first_u; u <= box.last_u; ++u)
		{
			const WallCrossing crossing = judge.rays().at(u, v);
			if (!(crossing.depth_m > 0.0F) || crossing.height_m < static_cast<float>(band.bottom_m) ||
			    crossing.height_m > static_cast<float>(band.top_m))
				continue;
			const float place = sign * (crossing.along_m - first_m) / static_cast<float>(kBin_m);
			if (place < 0.0F || place >= bins) continue;
			const auto bin = static_cast<std::size_t>(place);
			const RayMet met = judge.met(u, v, crossing);
			const bool wall = met == RayMet::wall, beside = met == RayMet::beside, front = met == RayMet::front;
			edge.on_wall.at(bin) += static_cast<int>(wall);
			edge.near_plane.at(bin) += static_cast<int>(wall || beside);
			if (wall || beside) edge.front_sum_m.at(bin) += judge.rays().inFront_m(crossing, judge.depth(u, v));
			edge.outside.at(bin) += static_cast<int>(wall || beside || front);
			edge.inside.at(bin) += static_cast<int>(met == RayMet::through || met == RayMet::shallow);
			edge.shallow.at(bin) += static_cast<int>(met == RayMet::shallow);
			edge.missing.at(bin) += static_cast<int>(met == RayMet::no_return);
			++edge.all.at(bin);
		}
	const int v = (box.first_v + box.last_v) / 2, u = (box.first_u + box.last_u) / 2;
	edge.ray_width_m = std::abs(judge.rays().at(u + 1, v).along_m - judge.rays().at(u, v).along_m);
	return edge;
}

int sum(const std::array<int, kMaxBins>& counts, std::size_t first, std::size_t end)
{
	int total = 0;
	for (std::size_t i = first; i < std::min(end, kMaxBins); ++i) total += counts.at(i);
	return total;
}

/** Mean distance before the plane of what lies right beside the edge, as far as a casing reaches. */
double reliefAt(const EdgeHistogram& edge, std::size_t bin)
{
	const std::size_t end = std::min(edge.bins, bin + static_cast<std::size_t>(kCasing_m / kBin_m));
	const int rays = sum(edge.near_plane, bin, end);
	if (rays < kFewOfJamb) return 0.0;
	const auto first = edge.front_sum_m.begin();
	const float front_m =
	    std::accumulate(first + static_cast<std::ptrdiff_t>(bin), first + static_cast<std::ptrdiff_t>(end), 0.0F);
	return std::clamp(static_cast<double>(front_m) / rays, 0.0, kThickest_m);
}

/** The jamb at an edge: what stands in the strip beyond it. */
Jamb jambAt(const EdgeHistogram& edge, const std::array<int, kMaxBins>& standing, std::size_t bin, JambKind kind,
            const JambConfig& config)
{
	const double strip_m = std::max(config.support_m, 3.0 * edge.ray_width_m);
	const std::size_t end = std::min(edge.bins, bin + static_cast<std::size_t>(strip_m / kBin_m));
	Jamb jamb;
	jamb.kind = kind;
	jamb.rays = sum(edge.all, bin, end);
	// A nearer edge casts a shadow without returns on the wall behind; that says nothing about the wall.
	const int missing = sum(edge.missing, bin, end);
	const int counted = jamb.rays - missing >= kFewOfJamb ? jamb.rays - missing : jamb.rays;
	jamb.support = counted == 0 ? 0.0 : static_cast<double>(sum(standing, bin, end)) / counted;
	jamb.relief_m = reliefAt(edge, bin);
	const auto inward = static_cast<std::size_t>(std::max(kFace_m, 3.0 * edge.ray_width_m) / kBin_m);
	const std::size_t first = bin > inward ? bin - inward : 0;
	const int inside = sum(edge.inside, first, bin);
	jamb.face = inside == 0 ? 0.0 : static_cast<double>(sum(edge.shallow, first, bin)) / inside;
	return jamb;
}
}  // namespace

Jamb fitJamb(const RayJudge& judge, double guess_m, JambSide side, const RayEvidenceConfig& band,
             const JambConfig& config)
{
	constexpr double kStands = 0.35;  // of the rays beside the opening: plants and holes take their share
	const EdgeHistogram edge = histogramAround(judge, guess_m, side, band, config);
	const auto back_off = static_cast<std::size_t>(0.5 * edge.ray_width_m / kBin_m);
	// Nothing leads behind (black, glass): the edge is where the wall begins, against no return at all.
	const bool leads_on = sum(edge.inside, 0, edge.bins) >= kFewOfJamb;
	std::array<int, kMaxBins> inside = edge.inside;
	if (!leads_on)
		for (std::size_t i = 0; i < edge.bins; ++i) inside.at(i) = edge.all.at(i) - edge.outside.at(i);

	const auto placed = [&](Jamb jamb, std::size_t bin)
	{
		const double from_guess_m = (static_cast<double>(bin) - 0.5 * static_cast<double>(edge.bins)) * kBin_m;
		jamb.along_m =
		    config.full_resolution ? guess_m + (side == JambSide::right ? from_guess_m : -from_guess_m) : guess_m;
		return jamb;
	};
	const EdgeChoice on_plane = bestEdge(edge.near_plane, inside, edge.bins, back_off);
	const Jamb wall = jambAt(edge, edge.near_plane, on_plane.bin, JambKind::wall, config);
	if (wall.rays >= kFewOfJamb && wall.support >= kStands)
	{
		const Jamb own = jambAt(edge, edge.on_wall, on_plane.bin, JambKind::wall, config);
		if (own.support >= 0.5 * wall.support) return placed(wall, on_plane.bin);
	}

	const EdgeChoice any = bestEdge(edge.outside, inside, edge.bins, back_off);
	Jamb other = jambAt(edge, edge.outside, any.bin, JambKind::hidden, config);
	if (other.rays < kFewOfJamb) return placed({0.0, JambKind::out_of_view, 0.0, other.rays}, any.bin);
	if (other.support < kStands) return placed({0.0, JambKind::nothing, other.support, other.rays}, any.bin);
	// A surface across meets the wall's plane right at the edge; what merely hides the jamb stands off.
	const auto reach = static_cast<std::size_t>(std::max(kOnEdge_m, 2.0 * edge.ray_width_m) / kBin_m);
	const int touching = sum(edge.near_plane, any.bin, any.bin + reach),
	          there = sum(edge.outside, any.bin, any.bin + reach);
	if (config.corners && 3 * touching >= there) other.kind = JambKind::corner;
	return placed(other, any.bin);
}
}  // namespace explore

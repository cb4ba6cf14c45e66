#include <explore/perception/wall_lines.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>

namespace explore
{
namespace
{
constexpr int kHypotheses = 400;
constexpr double kHalo = 1.6;   // times the tolerance: noise of this wall, not another one behind it
constexpr double kSharp = 0.4;  // of the tolerance
constexpr double kBreak_m = 0.2;

using Values = Eigen::Map<const Eigen::ArrayXf>;

Values valuesOf(const std::vector<float>& values)
{
	return {values.data(), static_cast<Eigen::Index>(values.size())};
}

std::optional<PlanLine> lineThrough(const PlanScan& scan, std::size_t a, std::size_t b)
{
	const auto step = static_cast<double>(scan.slope[b] - scan.slope[a]);
	const double per_slope = static_cast<double>(scan.inverse[b] - scan.inverse[a]) / step;
	return planLineOf(static_cast<double>(scan.inverse[a]) - per_slope * static_cast<double>(scan.slope[a]), per_slope);
}

struct Hypothesis
{
	PlanLine line;
	double bound;  ///< score when there were at least as many points left as now
};

/** Σ weight · (1 − (distance / tolerance)²) over the points within tolerance (MSAC, Torr & Zisserman 2000). */
double scoreOf(const PlanScan& scan, const Eigen::ArrayXf& weight, const PlanLine& line,
               const UprightWallConfig& config)
{
	const auto nx = static_cast<float>(line.normal.x()), ny = static_cast<float>(line.normal.y());
	const auto offset = static_cast<float>(line.offset_m);
	const auto base = static_cast<float>(pointTolerance(line, 0.0, config));
	const float growth = static_cast<float>(pointTolerance(line, 1.0, config)) - base;
	const auto off = (nx * valuesOf(scan.x) + ny * valuesOf(scan.y) + offset) / (base + growth * valuesOf(scan.noise));
	return static_cast<double>((weight * (1.0F - off.square()).max(0.0F)).sum());
}

/** Pairs of points of nearby directions: they lie on the same surface with some probability. */
std::vector<Hypothesis> drawHypotheses(const PlanScan& scan, const Eigen::ArrayXf& weight,
                                       const UprightWallConfig& config, unsigned seed)
{
	std::mt19937 random(seed);
	const auto below = [&](std::size_t n)
	{ return static_cast<std::size_t>((static_cast<std::uint64_t>(random()) * n) >> 32); };
	std::vector<Hypothesis> hypotheses;
	hypotheses.reserve(kHypotheses);
	for (int draw = 0; draw < kHypotheses; ++draw)
	{
		const std::size_t a = below(scan.size());
		const int gap = 2 + static_cast<int>(below(std::size_t{4} << below(4)));  // 2–5, 2–9, 2–17 or 2–33
		const auto [first, last] =
		    std::equal_range(scan.bin.begin() + static_cast<std::ptrdiff_t>(a), scan.bin.end(), scan.bin[a] + gap);
		if (first == last) continue;
		const auto b =
		    static_cast<std::size_t>(first - scan.bin.begin()) + below(static_cast<std::size_t>(last - first));
		if (const auto line = lineThrough(scan, a, b))
			hypotheses.push_back({*line, scoreOf(scan, weight, *line, config)});
	}
	return hypotheses;
}

/** Hypotheses whose score can have become the best one are scored again until the best is known. */
std::optional<std::size_t> bestOf(std::vector<Hypothesis>& hypotheses, const PlanScan& scan,
                                  const Eigen::ArrayXf& weight, const UprightWallConfig& config)
{
	while (true)
	{
		const auto best = std::max_element(hypotheses.begin(), hypotheses.end(),
		                                   [](const auto& a, const auto& b) { return a.bound < b.bound; });
		if (best == hypotheses.end() || best->bound < 0.5 * config.min_samples) return std::nullopt;
		const double now = scoreOf(scan, weight, best->line, config);
		const bool unchanged = now >= 0.98 * best->bound;
		best->bound = now;
		if (unchanged) return static_cast<std::size_t>(best - hypotheses.begin());
	}
}

std::vector<int> pointsLeft(const Eigen::ArrayXf& weight)
{
	std::vector<int> left;
	left.reserve(static_cast<std::size_t>(weight.size()));
	for (Eigen::Index i = 0; i < weight.size(); ++i)
		if (weight(i) > 0.0F) left.push_back(static_cast<int>(i));
	return left;
}

/** The line once more from those nearest to it, where they are most: what stands a little before or behind the wall no
 *  longer turns it. */
PlanLine sharpened(const PlanScan& scan, const PlanLine& line, const std::vector<int>& left,
                   const UprightWallConfig& config)
{
	if (!config.range_tolerance) return line;
	UprightWallConfig narrow = config;
	narrow.tolerance_m *= kSharp;
	narrow.tolerance_sigmas *= kSharp;
	PlanLine sharp = line;
	for (int round = 0; round < 2; ++round) sharp = fitLine(scan, membersOf(scan, sharp, left, narrow), sharp, narrow);
	const auto near = membersOf(scan, sharp, left, narrow), far = membersOf(scan, line, left, config);
	return 2 * near.size() > far.size() ? sharp : line;
}

bool isWall(const PlanScan& scan, const WallLine& wall, const UprightWallConfig& config)
{
	double samples = 0;
	int upright = 0;
	for (const int i : wall.members)
	{
		const auto point = static_cast<std::size_t>(i);
		samples += static_cast<double>(scan.samples[point]);
		upright +=
		    static_cast<int>(static_cast<double>(scan.top_m[point] - scan.bottom_m[point]) >= config.min_height_m);
	}
	if (samples < config.min_samples || upright < 2) return false;
	for (const LinePiece& piece : piecesOf(scan, wall.line, wall.members))
		if (piece.points >= 3 && piece.to_m - piece.from_m >= config.min_length_m) return true;
	return false;
}

/** The members are gone, and what is only just too far off to be one. */
void takeOut(const PlanScan& scan, const WallLine& wall, const std::vector<int>& left, const UprightWallConfig& config,
             Eigen::ArrayXf& weight)
{
	for (const int i : wall.members) weight(i) = 0.0F;
	if (!config.range_tolerance) return;
	const auto pieces = piecesOf(scan, wall.line, wall.members);
	for (const int i : left)
	{
		if (std::abs(distanceFrom(scan, wall.line, i)) > kHalo * toleranceAt(scan, wall.line, i, config)) continue;
		const double along = alongOf(scan, wall.line, i);
		for (const LinePiece& piece : pieces)
			if (along > piece.from_m - kBreak_m && along < piece.to_m + kBreak_m) weight(i) = 0.0F;
	}
}
}  // namespace

std::vector<WallLine> findLines(const PlanScan& scan, const UprightWallConfig& config, unsigned seed)
{
	std::vector<WallLine> walls;
	if (scan.size() < 3) return walls;
	Eigen::ArrayXf weight = valuesOf(scan.samples);
	auto hypotheses = drawHypotheses(scan, weight, config, seed);
	while (const auto best = bestOf(hypotheses, scan, weight, config))
	{
		WallLine wall{hypotheses[*best].line, {}};
		hypotheses[*best].bound = 0;
		const auto left = pointsLeft(weight);
		for (int round = 0; round < 3; ++round)
			wall.line = fitLine(scan, membersOf(scan, wall.line, left, config), wall.line, config);
		wall.line = sharpened(scan, wall.line, left, config);
		wall.members = membersOf(scan, wall.line, left, config);
		if (!isWall(scan, wall, config)) continue;
		takeOut(scan, wall, left, config, weight);
		walls.push_back(std::move(wall));
	}
	return walls;
}
}  // namespace explore

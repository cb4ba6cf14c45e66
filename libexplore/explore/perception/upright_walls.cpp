#include <explore/perception/upright_walls.h>
#include <explore/perception/wall_lines.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace explore
{
namespace
{
constexpr double kSameRelief_m = 0.012;  // coplanar walls may be this far apart: skirting, plaster
constexpr double kSameNoise = 0.5;       // and this share of σ, as disparity steps do not average out
constexpr double kShortest_m = 0.06;     // pieces shorter than this say nothing about where a wall ends

std::vector<int> allPoints(const PlanScan& scan)
{
	std::vector<int> points(scan.size());
	std::iota(points.begin(), points.end(), 0);
	return points;
}

/** Mean distance of members from the line, and what it may be for one and the same surface. */
bool liesOn(const PlanScan& scan, const std::vector<int>& members, const PlanLine& line)
{
	double sum = 0, noise = 0, samples = 0, square = 0;
	for (const int i : members)
	{
		const auto point = static_cast<std::size_t>(i);
		const auto weight = static_cast<double>(scan.samples[point]);
		const double off = distanceFrom(scan, line, i);
		sum += weight * off;
		square += weight * off * off;
		noise += weight * static_cast<double>(scan.noise[point]);
		samples += weight;
	}
	const double allowed = kSameRelief_m + kSameNoise * line.offset_m * noise / samples;
	return std::abs(sum) <= allowed * samples && square <= 2.0 * allowed * allowed * samples;
}

/** Both as one wall, where one line goes through both. */
std::optional<WallLine> merged(const PlanScan& scan, const WallLine& a, const WallLine& b,
                               const UprightWallConfig& config)
{
	if (a.line.normal.dot(b.line.normal) < 0.8) return std::nullopt;
	WallLine both{a.line, {}};
	both.members.reserve(a.members.size() + b.members.size());
	std::merge(a.members.begin(), a.members.end(), b.members.begin(), b.members.end(),
	           std::back_inserter(both.members));
	UprightWallConfig wide = config;
	wide.tolerance_m *= 3.0;
	wide.tolerance_sigmas *= 2.0;
	both.line = fitLine(scan, both.members, a.line, wide);
	if (!liesOn(scan, a.members, both.line) || !liesOn(scan, b.members, both.line)) return std::nullopt;
	return both;
}

void mergeCoplanar(const PlanScan& scan, std::vector<WallLine>& walls, const UprightWallConfig& config)
{
	for (std::size_t a = 0; a < walls.size(); ++a)
		for (std::size_t b = a + 1; b < walls.size();)
		{
			if (auto both = merged(scan, walls[a], walls[b], config))
			{
				walls[a] = std::move(*both);
				walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(b));
				b = a + 1;
			}
			else
				++b;
		}
}

/** Where two walls cross the points belong to the one whose piece there is longer. */
void shareOut(const PlanScan& scan, std::vector<WallLine>& walls, const UprightWallConfig& config)
{
	const auto all = allPoints(scan);
	std::vector<int> owner(scan.size(), -1);
	std::vector<double> size_of_owner(scan.size(), 0.0);
	for (std::size_t w = 0; w < walls.size(); ++w)
	{
		WallLine whole{walls[w].line, membersOf(scan, walls[w].line, all, config)};
		std::size_t member = 0;
		for (const LinePiece& piece : piecesOf(scan, whole.line, whole.members))
			for (int n = 0; n < piece.points; ++n, ++member)
			{
				const auto point = static_cast<std::size_t>(whole.members[member]);
				if (piece.samples <= size_of_owner[point]) continue;
				owner[point] = static_cast<int>(w);
				size_of_owner[point] = piece.samples;
			}
		walls[w].members.clear();
	}
	for (const int i : all)
		if (const int w = owner[static_cast<std::size_t>(i)]; w >= 0)
			walls[static_cast<std::size_t>(w)].members.push_back(i);
}

std::optional<UprightWall> wallOf(const PlanScan& scan, const WallLine& line, const UprightWallConfig& config)
{
	UprightWall wall{line.line.normal, line.line.offset_m, 1e9, -1e9, 0, 0.0};
	double samples = 0;
	for (const LinePiece& piece : piecesOf(scan, line.line, line.members))
	{
		if (piece.to_m - piece.from_m < kShortest_m) continue;
		wall.from_m = std::min(wall.from_m, piece.from_m);
		wall.to_m = std::max(wall.to_m, piece.to_m);
		wall.longest_piece_m = std::max(wall.longest_piece_m, piece.to_m - piece.from_m);
		samples += piece.samples;
	}
	if (samples < config.min_samples || wall.to_m - wall.from_m < config.min_length_m) return std::nullopt;
	wall.samples = static_cast<std::size_t>(samples);
	return wall;
}
}  // namespace

void describe(FieldVisitor& fields, UprightWallConfig& config)
{
	fields.real("wall_range", config.max_range_m, {0.5, 100.0}, "m", "Walls are made of what is nearer than this.");
	fields.real("wall_tolerance", config.tolerance_m, {0.001, 0.5}, "m",
	            "A sample belongs to a wall within wall_tolerance + wall_sigmas * sigma(z) of its plane.");
	fields.real("wall_sigmas", config.tolerance_sigmas, {0.0, 10.0}, "", "See wall_tolerance.");
	fields.real("wall_min_height", config.min_height_m, {0.05, 3.0}, "m", "Lower things are no walls.");
	fields.real("wall_min_length", config.min_length_m, {0.02, 5.0}, "m", "Shorter things are no walls.");
	fields.integer("wall_min_samples", config.min_samples, {6, 1e5}, "samples",
	               "Of about 19,200 that an image is thinned to, a wall has at least these.");
}

double wallTolerance(const UprightWall& wall, const Eigen::Vector2d& point, double depth_m,
                     const UprightWallConfig& config, const SensorNoiseConfig& noise)
{
	if (!config.range_tolerance) return 0.05;
	const double across = std::abs(wall.normal.dot(point)) / std::max(depth_m, 1e-6);
	return config.tolerance_m + config.tolerance_sigmas * depthSigma(depth_m, noise) * across;
}

std::vector<UprightWall> findUprightWalls(const LevelView& view, const UprightWallConfig& config,
                                          const SensorNoiseConfig& noise, unsigned seed)
{
	const PlanScan scan = planScan(view, {config.max_range_m, config.min_height_m}, noise);
	auto lines = findLines(scan, config, seed);
	if (config.range_tolerance) mergeCoplanar(scan, lines, config);
	shareOut(scan, lines, config);
	std::vector<UprightWall> walls;
	walls.reserve(lines.size());
	for (const WallLine& line : lines)
		if (const auto wall = wallOf(scan, line, config)) walls.push_back(*wall);
	std::stable_sort(walls.begin(), walls.end(), [](const auto& a, const auto& b) { return a.samples > b.samples; });
	return walls;
}
}  // namespace explore

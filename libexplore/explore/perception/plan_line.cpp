#include <explore/perception/plan_line.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kPaperTolerance_m = 0.05;
constexpr double kMeanShare = 0.6;     // of one sample's noise that is left in the mean of many: it is correlated
constexpr double kRelief_m = 0.004;    // plaster
constexpr double kStepShare = 0.25;    // of σ that no averaging removes: disparity steps
constexpr double kMaxAveraged = 16;    // samples of one point that are independent
constexpr double kMinOffset_m = 0.08;  // a plane through the camera is an edge of something
constexpr int kRefits = 4;
constexpr double kBreak_m = 0.2;
constexpr int kBreakBins = 3;

/** 1 / variance of a point's inverse distance. */
double weightOf(const PlanScan& scan, const PlanLine& line, int i)
{
	const auto point = static_cast<std::size_t>(i);
	const auto inverse = static_cast<double>(scan.inverse[point]);
	const double noise = inverse * static_cast<double>(scan.noise[point]);
	const double averaged = 1.0 / std::min(static_cast<double>(scan.samples[point]), kMaxAveraged);
	const double relief = kRelief_m * inverse / line.offset_m;
	return 1.0 / (noise * noise * (averaged + kStepShare * kStepShare) + relief * relief + 1e-12);
}

}  // namespace

std::optional<PlanLine> planLineOf(double at_zero, double per_slope)
{
	const double length = std::hypot(at_zero, per_slope);
	if (!(length * kMinOffset_m < 1.0) || length < 1e-6) return std::nullopt;
	return PlanLine{Eigen::Vector2d(-at_zero, -per_slope) / length, 1.0 / length};
}

double distanceFrom(const PlanScan& scan, const PlanLine& line, int i)
{
	const auto point = static_cast<std::size_t>(i);
	return line.normal.x() * static_cast<double>(scan.x[point]) + line.normal.y() * static_cast<double>(scan.y[point]) +
	       line.offset_m;
}

double toleranceAt(const PlanScan& scan, const PlanLine& line, int i, const UprightWallConfig& config)
{
	return pointTolerance(line, static_cast<double>(scan.noise[static_cast<std::size_t>(i)]), config);
}

double pointTolerance(const PlanLine& line, double point_noise, const UprightWallConfig& config)
{
	if (!config.range_tolerance) return kPaperTolerance_m;
	return config.tolerance_m + kMeanShare * config.tolerance_sigmas * point_noise * line.offset_m;
}

double alongOf(const PlanScan& scan, const PlanLine& line, int i)
{
	const auto point = static_cast<std::size_t>(i);
	return line.normal.x() * static_cast<double>(scan.y[point]) - line.normal.y() * static_cast<double>(scan.x[point]);
}

PlanLine fitLine(const PlanScan& scan, const std::vector<int>& members, const PlanLine& start,
                 const UprightWallConfig& config)
{
	PlanLine line = start;
	for (int round = 0; round < kRefits; ++round)
	{
		double sw = 0, ss = 0, si = 0, sss = 0, ssi = 0;
		for (const int i : members)
		{
			const double off = distanceFrom(scan, line, i) / toleranceAt(scan, line, i, config);
			const double near = std::max(0.0, 1.0 - off * off);
			const double weight = near * near * weightOf(scan, line, i);
			const auto slope = static_cast<double>(scan.slope[static_cast<std::size_t>(i)]);
			const auto inverse = static_cast<double>(scan.inverse[static_cast<std::size_t>(i)]);
			sw += weight;
			ss += weight * slope;
			si += weight * inverse;
			sss += weight * slope * slope;
			ssi += weight * slope * inverse;
		}
		const double spread = sw * sss - ss * ss;
		if (!(spread > 1e-12 * sw * sw)) return line;
		const double per_slope = (sw * ssi - ss * si) / spread;
		const auto fitted = planLineOf((si - per_slope * ss) / sw, per_slope);
		if (!fitted) return line;
		line = *fitted;
	}
	return line;
}

std::vector<int> membersOf(const PlanScan& scan, const PlanLine& line, const std::vector<int>& candidates,
                           const UprightWallConfig& config)
{
	std::vector<int> members;
	members.reserve(candidates.size());
	for (const int i : candidates)
		if (std::abs(distanceFrom(scan, line, i)) <= toleranceAt(scan, line, i, config)) members.push_back(i);
	return members;
}

std::vector<LinePiece> piecesOf(const PlanScan& scan, const PlanLine& line, const std::vector<int>& members)
{
	std::vector<LinePiece> pieces;
	int last_bin = 0;
	for (const int i : members)
	{
		const auto point = static_cast<std::size_t>(i);
		const double along = alongOf(scan, line, i);
		// half of what one direction covers of the wall
		const auto x = static_cast<double>(scan.x[point]);
		const double half = 0.5 * scan.bin_width * x * std::hypot(1.0, scan.slope[point]) *
		                    std::hypot(along, line.offset_m) / line.offset_m;
		const bool apart = pieces.empty() || (scan.bin[point] > last_bin + kBreakBins &&
		                                      std::max(pieces.back().from_m - along - half,
		                                               along - half - pieces.back().to_m) > kBreak_m);
		if (apart) pieces.push_back({along - half, along + half, 0, 0.0});
		LinePiece& piece = pieces.back();
		piece.from_m = std::min(piece.from_m, along - half);
		piece.to_m = std::max(piece.to_m, along + half);
		++piece.points;
		piece.samples += static_cast<double>(scan.samples[point]);
		last_bin = scan.bin[point];
	}
	return pieces;
}

}  // namespace explore

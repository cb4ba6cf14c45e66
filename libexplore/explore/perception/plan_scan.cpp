#include <explore/perception/plan_scan.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace explore
{
namespace
{
constexpr float kLowest_m = 0.1F;      // the floor and what lies on it
constexpr double kUprightRun_m = 0.1;  // so much of a vertical line must be seen
constexpr double kMinRun_samples = 3.0;
constexpr double kInverseBin = 0.006;  // three sigma of the sensor
constexpr double kMaxInverse = 2.5;    // 0.4 m
constexpr int kMaxBins = 400;          // directions; a wide view pitched steeply
constexpr int kLongestRun = 8;         // inverse bins of one point
constexpr float kMinX_m = 0.2F;
constexpr std::uint16_t kNone = 0xFFFF;

/** Bins of direction × inverse distance. */
struct Bins
{
	float first_slope = 0, per_slope = 0, per_inverse = 0;
	int directions = 0, inverses = 0;

	[[nodiscard]] std::size_t count() const
	{
		return static_cast<std::size_t>(directions) * static_cast<std::size_t>(inverses);
	}
};

struct PlanSample
{
	float slope, inverse;
	std::uint32_t sample;  ///< index into LevelSamples
	std::uint32_t cell;
};

std::vector<PlanSample> standingSamples(const LevelSamples& samples, float max_range_m)
{
	std::vector<PlanSample> standing;
	standing.reserve(samples.size());
	for (std::size_t i = 0; i < samples.size(); ++i)
	{
		if (samples.z[i] < kLowest_m || samples.depth_m[i] > max_range_m || samples.x[i] < kMinX_m) continue;
		const float inverse = 1.0F / samples.x[i];
		standing.push_back({samples.y[i] * inverse, inverse, static_cast<std::uint32_t>(i), 0});
	}
	return standing;
}

Bins binsFor(const std::vector<PlanSample>& standing, double bin_width)
{
	const auto [low, high] = std::minmax_element(standing.begin(), standing.end(),
	                                             [](const auto& a, const auto& b) { return a.slope < b.slope; });
	Bins bins;
	bins.per_slope = static_cast<float>(1.0 / bin_width);
	const float widest = static_cast<float>(kMaxBins) / bins.per_slope;
	bins.first_slope = std::max(low->slope, -0.5F * widest);
	const float last = std::min(high->slope, 0.5F * widest);
	bins.directions = std::max(1, static_cast<int>((last - bins.first_slope) * bins.per_slope) + 1);
	bins.per_inverse = static_cast<float>(1.0 / kInverseBin);
	bins.inverses = static_cast<int>(kMaxInverse / kInverseBin) + 2;
	return bins;
}

/** Gives each sample its cell; those outside all bins go. */
void assignCells(std::vector<PlanSample>& standing, const Bins& bins)
{
	std::size_t kept = 0;
	for (PlanSample sample : standing)
	{
		const auto direction = static_cast<int>(std::floor((sample.slope - bins.first_slope) * bins.per_slope));
		const auto inverse = static_cast<int>(sample.inverse * bins.per_inverse);
		if (direction < 0 || direction >= bins.directions || inverse >= bins.inverses - 1) continue;
		sample.cell = static_cast<std::uint32_t>(direction * bins.inverses + inverse);
		standing[kept++] = sample;
	}
	standing.resize(kept);
}

/** Samples that a vertical line of kUprightRun_m has in each inverse bin. */
std::vector<float> runThresholds(const Bins& bins, double samples_per_unit_slope)
{
	std::vector<float> thresholds;
	thresholds.reserve(static_cast<std::size_t>(bins.inverses));
	for (int i = 0; i < bins.inverses; ++i)
		thresholds.push_back(static_cast<float>(
		    std::max(kMinRun_samples, kUprightRun_m * samples_per_unit_slope * (i + 0.5) * kInverseBin)));
	return thresholds;
}

struct Runs
{
	std::vector<std::uint16_t> point_of_cell;
	std::vector<int> direction_of_point;
};

/** Cells of one direction that have enough samples, in runs of at most kLongestRun. */
Runs findRuns(const std::vector<std::uint16_t>& counts, const Bins& bins, const std::vector<float>& thresholds)
{
	Runs runs;
	runs.point_of_cell.assign(bins.count(), kNone);
	const auto inverses = static_cast<std::size_t>(bins.inverses);
	for (int direction = 0; direction < bins.directions; ++direction)
	{
		const std::size_t start = static_cast<std::size_t>(direction) * inverses;
		const std::uint16_t* column = counts.data() + start;
		int length = 0;
		for (std::size_t i = 1; i + 1 < inverses; ++i)
		{
			const int sum = column[i - 1] + column[i] + column[i + 1];
			if (static_cast<float>(sum) < thresholds[i])
			{
				length = 0;
				continue;
			}
			if (length == 0 && runs.direction_of_point.size() < kNone) runs.direction_of_point.push_back(direction);
			runs.point_of_cell[start + i] = static_cast<std::uint16_t>(runs.direction_of_point.size() - 1);
			length = (length + 1) % kLongestRun;
		}
	}
	return runs;
}

struct Sums
{
	double slope = 0, inverse = 0, noise = 0, samples = 0;
	float bottom = 1e9F, top = -1e9F;
};

std::vector<Sums> sumUp(const std::vector<PlanSample>& standing, const Runs& runs, const LevelSamples& samples,
                        const SensorNoiseConfig& noise)
{
	std::vector<Sums> sums(runs.direction_of_point.size());
	for (const PlanSample& sample : standing)
	{
		const std::uint16_t point = runs.point_of_cell[sample.cell];
		if (point == kNone) continue;
		Sums& sum = sums[point];
		const auto depth = static_cast<double>(samples.depth_m[sample.sample]);
		sum.slope += static_cast<double>(sample.slope);
		sum.inverse += static_cast<double>(sample.inverse);
		sum.noise += depthSigma(depth, noise) / depth;
		sum.samples += 1;
		sum.bottom = std::min(sum.bottom, samples.z[sample.sample]);
		sum.top = std::max(sum.top, samples.z[sample.sample]);
	}
	return sums;
}

void append(PlanScan& scan, int direction, const Sums& sum)
{
	const double slope = sum.slope / sum.samples, inverse = sum.inverse / sum.samples;
	scan.bin.push_back(direction);
	scan.slope.push_back(static_cast<float>(slope));
	scan.inverse.push_back(static_cast<float>(inverse));
	scan.x.push_back(static_cast<float>(1.0 / inverse));
	scan.y.push_back(static_cast<float>(slope / inverse));
	scan.noise.push_back(static_cast<float>(sum.noise / sum.samples));
	scan.samples.push_back(static_cast<float>(sum.samples));
	scan.bottom_m.push_back(sum.bottom);
	scan.top_m.push_back(sum.top);
}
}  // namespace

PlanScan planScan(const LevelView& view, const PlanScanConfig& config, const SensorNoiseConfig& noise)
{
	PlanScan scan;
	if (view.samples.size() == 0) return scan;
	auto standing = standingSamples(view.samples, static_cast<float>(config.max_range_m));
	if (standing.empty()) return scan;
	const CameraIntrinsics& camera = view.image->intrinsics;
	scan.bin_width = view.samples.stride / camera.fx_px;
	const Bins bins = binsFor(standing, scan.bin_width);
	assignCells(standing, bins);

	std::vector<std::uint16_t> counts(bins.count(), 0);
	for (const PlanSample& sample : standing) ++counts[sample.cell];
	const Runs runs = findRuns(counts, bins, runThresholds(bins, camera.fy_px / view.samples.stride));
	const auto sums = sumUp(standing, runs, view.samples, noise);
	for (std::size_t i = 0; i < sums.size(); ++i)
		if (sums[i].samples >= kMinRun_samples && static_cast<double>(sums[i].top) >= config.min_height_m)
			append(scan, runs.direction_of_point[i], sums[i]);
	return scan;
}
}  // namespace explore

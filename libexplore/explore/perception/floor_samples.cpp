#include <explore/perception/floor_samples.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore
{
namespace
{
constexpr float kNearest_m = 0.08F;
constexpr double kBin_m = 0.025;
constexpr std::size_t kBins = 240;  // 6 m
constexpr double kSmear_m = 0.05;   // samples whose height is surer than this count in full
constexpr int kApart = 4;           // bins between two peaks

using Histogram = std::array<double, kBins>;

Histogram histogramOf(const std::vector<FloorSample>& samples, double tilt_sigma_rad)
{
	Histogram bins{};
	const auto sure_m = static_cast<float>(kSmear_m / std::max(tilt_sigma_rad, 1e-4));
	for (const FloorSample& sample : samples)
	{
		const auto bin = static_cast<std::size_t>(static_cast<double>(sample.below_m) / kBin_m);
		if (bin < kBins) bins.at(bin) += static_cast<double>(std::min(1.0F, sure_m / sample.depth_m));
	}
	return bins;
}

Histogram smoothed(const Histogram& bins)
{
	Histogram sums{};
	for (std::size_t i = 1; i + 1 < kBins; ++i) sums.at(i) = bins.at(i - 1) + bins.at(i) + bins.at(i + 1);
	return sums;
}

/** Centre of mass of the bins around `bin`. */
double heightAt(const Histogram& bins, std::size_t bin)
{
	double sum = 0, weighted = 0;
	for (std::size_t i = bin - 1; i <= bin + 1; ++i)
	{
		sum += bins.at(i);
		weighted += bins.at(i) * (static_cast<double>(i) + 0.5) * kBin_m;
	}
	return weighted / sum;
}

bool isPeak(const Histogram& sums, std::size_t bin)
{
	const auto first = sums.begin() + std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(bin) - kApart);
	const auto last = sums.begin() + std::min<std::ptrdiff_t>(kBins, static_cast<std::ptrdiff_t>(bin) + kApart + 1);
	return std::max_element(first, last) == sums.begin() + static_cast<std::ptrdiff_t>(bin);
}
}  // namespace

std::vector<FloorSample> levelSamples(const SampleGrid& grid, const Eigen::Vector3d& up_in_camera, double max_tilt_rad)
{
	const Eigen::Vector3f up = up_in_camera.cast<float>();
	const auto min_cosine = static_cast<float>(std::cos(max_tilt_rad));
	std::vector<FloorSample> samples;
	samples.reserve(grid.size());
	const auto columns = static_cast<std::size_t>(grid.columns);
	for (std::size_t row = 0; row < static_cast<std::size_t>(grid.rows); ++row)
	{
		const float part = up.x() + up.z() * grid.ray_z[row];
		for (std::size_t column = 0; column < columns; ++column)
		{
			const std::size_t i = row * columns + column;
			const float cosine = grid.normal_x[i] * up.x() + grid.normal_y[i] * up.y() + grid.normal_z[i] * up.z();
			const float below = -grid.depth_m[i] * (part + up.y() * grid.ray_y[column]);
			if (cosine >= min_cosine && below >= kNearest_m)
				samples.push_back({grid.depth_m[i], grid.ray_y[column], grid.ray_z[row], below});
		}
	}
	return samples;
}

std::vector<HeightPeak> heightPeaks(const std::vector<FloorSample>& samples, double tilt_sigma_rad, double min_support)
{
	const Histogram bins = histogramOf(samples, tilt_sigma_rad);
	const Histogram sums = smoothed(bins);
	std::vector<HeightPeak> peaks;
	for (std::size_t bin = kBins - 2; bin > 0; --bin)
		if (sums.at(bin) >= std::max(1.0, min_support) && isPeak(sums, bin))
			peaks.push_back({heightAt(bins, bin), sums.at(bin)});
	return peaks;
}
}  // namespace explore

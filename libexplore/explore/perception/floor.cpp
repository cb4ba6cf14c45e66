#include <explore/core/geometry.h>
#include <explore/perception/floor.h>
#include <explore/perception/floor_samples.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kFacingUp = 25 * kDegree_rad;  // a sample's normal is that uncertain
constexpr double kUneven_m = 0.004;             // floors are not flat
constexpr double kCorrelatedSamples = 40.0;     // so many samples count as one against the prior
constexpr double kSigmas = 2.5;

/** Which samples a fit takes: within base + slope · depth + noise of the plane. */
struct Gate
{
	double base_m, slope;
};

struct FloorFit
{
	Eigen::Vector3d slope = Eigen::Vector3d::UnitZ();  ///< normal / height: slope · point = −1 on the floor
	Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
	std::size_t samples = 0;

	[[nodiscard]] double height_m() const { return 1.0 / slope.norm(); }
	[[nodiscard]] Eigen::Vector3d normal() const { return slope.normalized(); }
};

/** In inverse depth a plane is linear, 1/z = −slope · ray, and the noise of a structured-light camera nearly the same
 *  everywhere: one weighted linear least squares step, held near the prior's up. */
FloorFit refit(const std::vector<FloorSample>& samples, const FloorFit& start, const Gate& gate, const UpPrior& up,
               const SensorNoiseConfig& noise)
{
	const double height = start.height_m();
	Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
	Eigen::Vector3d right = Eigen::Vector3d::Zero();
	FloorFit fit;
	for (const FloorSample& sample : samples)
	{
		const Eigen::Vector3d ray(1.0, static_cast<double>(sample.ray_y), static_cast<double>(sample.ray_z));
		const auto depth = static_cast<double>(sample.depth_m);
		const double inverse = 1.0 / depth, sigma = depthSigma(depth, noise);
		const double above = depth * height * (inverse + start.slope.dot(ray));
		if (std::abs(above) > gate.base_m + gate.slope * depth + kSigmas * sigma * height * inverse) continue;
		const double deviation = inverse * std::hypot(sigma * inverse, kUneven_m / height);
		const double weight = 1.0 / (kCorrelatedSamples * deviation * deviation);
		information += weight * ray * ray.transpose();
		right -= weight * inverse * ray;
		++fit.samples;
	}
	const double hold = height * height / (up.sigma_rad * up.sigma_rad);
	information += hold * (Eigen::Matrix3d::Identity() - up.up * up.up.transpose());
	fit.covariance = (information + 1e-9 * Eigen::Matrix3d::Identity()).inverse();
	fit.slope = fit.covariance * right;
	return fit;
}

std::optional<FloorFit> fitAt(const HeightPeak& peak, const std::vector<FloorSample>& samples, const UpPrior& up,
                              const FloorConfig& config, const SensorNoiseConfig& noise)
{
	const double slope = std::max(up.sigma_rad, 0.3 * kDegree_rad);
	FloorFit fit;
	fit.slope = up.up / peak.below_m;
	for (const Gate& gate : {Gate{0.05, 0.3 * slope}, Gate{0.03, 0.6 * slope}, Gate{0.02, 0.004}, Gate{0.015, 0.002}})
	{
		fit = refit(samples, fit, gate, up, noise);
		if (fit.samples < static_cast<std::size_t>(config.min_samples) || !fit.slope.allFinite()) return std::nullopt;
		if (fit.slope.dot(up.up) <= 0.5 * fit.slope.norm()) return std::nullopt;
	}
	return fit;
}

Floor floorOf(const FloorFit& fit)
{
	const Eigen::Vector3d normal = fit.normal();
	const double height = fit.height_m();
	const Eigen::Matrix3d level = Eigen::Matrix3d::Identity() - normal * normal.transpose();
	const Eigen::Matrix3d tilt = level * fit.covariance * level;
	const double largest =
	    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tilt, Eigen::EigenvaluesOnly).eigenvalues()(2);
	return {{normal, height},
	        fit.samples,
	        std::max(0.2 * kDegree_rad, height * std::sqrt(std::max(0.0, largest))),
	        std::max(0.005, height * height * std::sqrt(normal.dot(fit.covariance * normal)))};
}

/** Shares of the valid samples on the floor and clearly below it. */
struct Support
{
	double on = 0, below = 0;
};

Support supportOf(const Floor& floor, const SampleGrid& grid)
{
	const Eigen::Vector3f n = floor.plane_in_camera.normal.cast<float>();
	const auto height = static_cast<float>(floor.plane_in_camera.d_m);
	std::size_t valid = 0, below = 0, i = 0;
	for (const float ray_z : grid.ray_z)
		for (const float ray_y : grid.ray_y)
		{
			const float depth = grid.depth_m[i++];
			const float above = depth * (n.x() + n.y() * ray_y + n.z() * ray_z) + height;
			valid += static_cast<std::size_t>(depth > 0.0F);
			below += static_cast<std::size_t>(depth > 0.0F && above < -0.08F - 0.03F * depth);
		}
	const auto all = static_cast<double>(std::max<std::size_t>(valid, 1));
	return {static_cast<double>(floor.samples) / all, static_cast<double>(below) / all};
}

/** Tables and boxes must not pass for the floor. Where nothing tells the height there is next to nothing below the
 *  floor, or it is large. Against what is known it takes both, and one higher than expected must fill the view. */
bool isConvincing(const Floor& floor, const SampleGrid& grid, const CameraHeight& height, bool contradicts)
{
	const Support support = supportOf(floor, grid);
	if (!contradicts)
		return (support.on > 0.015 && support.below < 0.005) || (support.on > 0.08 && support.below < 0.1);
	const bool higher = height.expected_m && floor.plane_in_camera.d_m < *height.expected_m;
	return support.on > (higher ? 0.4 : 0.12) && support.below < 0.03;
}

/** The peaks worth trying, best first; those from the returned number on contradict what is known. */
std::size_t rank(std::vector<HeightPeak>& peaks, const CameraHeight& height, const FloorConfig& config)
{
	if (height.expected_m)
	{
		const auto is_expected = [&](const HeightPeak& peak)
		{ return std::abs(peak.below_m - *height.expected_m) <= height.tolerance_m; };
		const auto others = std::stable_partition(peaks.begin(), peaks.end(), is_expected);
		std::stable_sort(peaks.begin(), others, [](const auto& a, const auto& b) { return a.support > b.support; });
		return static_cast<std::size_t>(others - peaks.begin());
	}
	double largest = 0;
	const auto is_possible = [&](const HeightPeak& peak)
	{ return peak.below_m >= height.min_m && peak.below_m <= height.max_m; };
	for (const HeightPeak& peak : peaks)
		if (is_possible(peak)) largest = std::max(largest, peak.support);
	const auto others = std::stable_partition(
	    peaks.begin(), peaks.end(),
	    [&](const HeightPeak& peak) { return is_possible(peak) && peak.support >= config.dominant_share * largest; });
	return static_cast<std::size_t>(others - peaks.begin());
}
}  // namespace

void describe(FieldVisitor& fields, FloorConfig& config)
{
	fields.real("floor_height_tolerance", config.height_tolerance_m, {0.01, 1.0}, "m",
	            "The floor is this near to the wheels' level, or to where it was.");
	fields.integer("floor_min_samples", config.min_samples, {10, 10000}, "samples",
	               "A floor has at least this many of about 19,200 samples.");
	fields.real("floor_dominant_share", config.dominant_share, {0.01, 1.0}, "",
	            "The lowest level surface with this share of the largest one's samples is the floor.");
}

std::optional<Floor> findFloor(const SampleGrid& grid, const UpPrior& up_in_camera, const CameraHeight& height,
                               const FloorConfig& config, const SensorNoiseConfig& noise)
{
	const auto samples = levelSamples(grid, up_in_camera.up, kFacingUp);
	auto peaks = heightPeaks(samples, up_in_camera.sigma_rad, 0.5 * config.min_samples);
	const std::size_t trusted = rank(peaks, height, config);
	for (std::size_t i = 0; i < peaks.size(); ++i)
	{
		const auto fit = fitAt(peaks[i], samples, up_in_camera, config, noise);
		if (!fit) continue;
		const Floor floor = floorOf(*fit);
		const bool contradicts = i >= trusted;
		if ((height.expected_m && !contradicts) || isConvincing(floor, grid, height, contradicts)) return floor;
	}
	return std::nullopt;
}
}  // namespace explore

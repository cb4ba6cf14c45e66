#include <explore/perception/planes.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr std::size_t kScoringPoints = 2048;  // hypotheses are compared on a sample of this size
constexpr double kMissProbability = 0.01;     // of stopping before a better plane was drawn
constexpr int kAttemptsPerHypothesis = 20;    // with a cone most random triples are refused before they cost anything
constexpr int kRefinements = 4;

struct PlaneF
{
	float a, b, c, d;
	explicit PlaneF(const Plane& plane)
	    : a(static_cast<float>(plane.normal.x())),
	      b(static_cast<float>(plane.normal.y())),
	      c(static_cast<float>(plane.normal.z())),
	      d(static_cast<float>(plane.d_m))
	{
	}
	[[nodiscard]] float distance(const PointCloud& points, std::size_t i) const
	{
		return a * points.x[i] + b * points.y[i] + c * points.z[i] + d;
	}
};

/** Number of points with low ≤ signed distance ≤ high. */
int countBetween(const PointCloud& points, const PlaneF& plane, float low, float high)
{
	int count = 0;
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const float distance = plane.distance(points, i);
		count += static_cast<int>(distance >= low) & static_cast<int>(distance <= high);
	}
	return count;
}

/** Every n-th point, so that all of the cloud is represented. */
PointCloud scoringSample(const PointCloud& points)
{
	if (points.size() <= kScoringPoints) return points;
	PointCloud sample;
	sample.reserve(kScoringPoints);
	const double stride = static_cast<double>(points.size()) / static_cast<double>(kScoringPoints);
	for (std::size_t i = 0; i < kScoringPoints; ++i)
		sample.push_back(points[static_cast<std::size_t>(static_cast<double>(i) * stride)]);
	return sample;
}

std::size_t randomIndex(RandomEngine& random, std::size_t n)
{
	// Not std::uniform_int_distribution: its values differ between standard libraries.
	return static_cast<std::size_t>((static_cast<std::uint64_t>(random()) * n) >> 32);
}

bool insideCone(const Plane& plane, const std::optional<NormalCone>& cone)
{
	return !cone || std::abs(plane.normal.dot(cone->axis)) >= std::cos(cone->max_angle_rad);
}

std::optional<Plane> planeOfRandomTriple(const PointCloud& points, RandomEngine& random)
{
	const Eigen::Vector3d p = points[randomIndex(random, points.size())].cast<double>();
	const Eigen::Vector3d q = points[randomIndex(random, points.size())].cast<double>();
	const Eigen::Vector3d r = points[randomIndex(random, points.size())].cast<double>();
	const Eigen::Vector3d normal = (q - p).cross(r - p);
	if (normal.squaredNorm() < 1e-8) return std::nullopt;  // the same point twice, or three in a line
	return planeThrough(p, normal);
}

/** How good a hypothesis is: its inliers; with a cone, its contrast. */
int score(const PointCloud& points, const Plane& plane, const PlaneSearchConfig& config,
          const std::optional<NormalCone>& cone)
{
	if (cone) return contrast(points, plane, config.tolerance_m);
	const auto tolerance = static_cast<float>(config.tolerance_m);
	return countBetween(points, PlaneF(plane), -tolerance, tolerance);
}

/** Draws after which a plane that holds `share` of the points was drawn with probability 1 − kMissProbability. */
double drawsNeeded(double share)
{
	const double all_three = std::clamp(share * share * share, 1e-12, 1.0 - 1e-12);
	return std::log(kMissProbability) / std::log(1.0 - all_three);
}

std::optional<Plane> bestHypothesis(const PointCloud& points, const PlaneSearchConfig& config, RandomEngine& random,
                                    const std::optional<NormalCone>& cone)
{
	const PointCloud sample = scoringSample(points);
	const int limit = config.max_iterations * (cone ? kAttemptsPerHypothesis : 1);
	std::optional<Plane> best;
	int best_score = 0;
	double needed = limit;
	for (int draw = 0; draw < limit && draw < needed; ++draw)
	{
		const auto plane = planeOfRandomTriple(points, random);
		if (!plane || !insideCone(*plane, cone)) continue;
		const int plane_score = score(sample, *plane, config, cone);
		if (plane_score <= best_score) continue;
		best = plane;
		best_score = plane_score;
		needed = drawsNeeded(static_cast<double>(best_score) / static_cast<double>(sample.size()));
	}
	return best;
}

/** Least squares on the points within half the tolerance, a few times over: what stands on the plane or beside it lies
 *  further out and would tilt a fit to all inliers. */
FoundPlane refined(const PointCloud& points, const Plane& hypothesis, const PlaneSearchConfig& config)
{
	Plane plane = hypothesis;
	for (int i = 0; i < kRefinements; ++i)
	{
		const auto core = inliersOf(points, plane, 0.5 * config.tolerance_m);
		if (core.size() < 3) break;
		plane = fitPlane(points, core);
	}
	return {plane, inliersOf(points, plane, config.tolerance_m)};
}
}  // namespace

void describe(FieldVisitor& fields, PlaneSearchConfig& config)
{
	fields.real("plane_tolerance", config.tolerance_m, {0.001, 0.5}, "m",
	            "RANSAC: points nearer than this belong to the plane.");
	fields.real("alpha", config.alpha, {0.0, 1.0}, "",
	            "Plane extraction stops when this share of the filtered points is left (paper: 0.2).");
	fields.integer("min_inliers", config.min_inliers, {3, 1e6}, "voxels",
	               "Planes with fewer points are not looked at.");
	fields.integer("max_iterations", config.max_iterations, {1, 1e5}, "", "RANSAC hypotheses per plane, at most.");
}

std::optional<FoundPlane> dominantPlane(const PointCloud& points, const PlaneSearchConfig& config, RandomEngine& random,
                                        const std::optional<NormalCone>& cone)
{
	const auto enough = static_cast<std::size_t>(config.min_inliers);
	if (points.size() < enough) return std::nullopt;
	const auto hypothesis = bestHypothesis(points, config, random, cone);
	if (!hypothesis) return std::nullopt;
	FoundPlane found = refined(points, *hypothesis, config);
	if (found.inliers.size() < enough) return std::nullopt;
	return found;
}

std::vector<std::uint32_t> inliersOf(const PointCloud& points, const Plane& plane, double tolerance_m)
{
	const PlaneF plane_f(plane);
	const auto tolerance = static_cast<float>(tolerance_m);
	std::vector<std::uint32_t> inliers;
	for (std::size_t i = 0; i < points.size(); ++i)
		if (std::abs(plane_f.distance(points, i)) <= tolerance) inliers.push_back(static_cast<std::uint32_t>(i));
	return inliers;
}

int contrast(const PointCloud& points, const Plane& plane, double tolerance_m)
{
	const PlaneF plane_f(plane);
	const auto tolerance = static_cast<float>(tolerance_m);
	const float outside = std::nextafter(tolerance, 2 * tolerance);
	const int above = countBetween(points, plane_f, outside, 3 * tolerance);
	const int below = countBetween(points, plane_f, -3 * tolerance, -outside);
	return countBetween(points, plane_f, -tolerance, tolerance) - std::max(above, below);
}

Plane fitPlane(const PointCloud& points, const std::vector<std::uint32_t>& indices)
{
	Eigen::Vector3d mean = Eigen::Vector3d::Zero();
	for (const auto i : indices) mean += points[i].cast<double>();
	mean /= static_cast<double>(indices.size());
	Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
	for (const auto i : indices)
	{
		const Eigen::Vector3d offset = points[i].cast<double>() - mean;
		scatter += offset * offset.transpose();
	}
	const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);  // eigenvalues ascending
	return planeThrough(mean, axes.eigenvectors().col(0));
}

PointCloud projectOnto(const Plane& plane, const PointCloud& points, const std::vector<std::uint32_t>& indices)
{
	PointCloud projected;
	projected.reserve(indices.size());
	for (const auto i : indices) projected.push_back(plane.project(points[i].cast<double>()).cast<float>());
	return projected;
}

PointCloud without(const PointCloud& points, const std::vector<std::uint32_t>& indices)
{
	PointCloud rest;
	rest.reserve(points.size() - indices.size());
	auto next = indices.begin();
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		if (next != indices.end() && *next == i)
			++next;
		else
			rest.push_back(points[i]);
	}
	return rest;
}
}  // namespace explore

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
constexpr int kSampleRefits = 2;

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

int countWithin(const PointCloud& points, const PlaneF& plane, float tolerance_m)
{
	int count = 0;
	for (std::size_t i = 0; i < points.size(); ++i)
		count += static_cast<int>(std::abs(plane.distance(points, i)) <= tolerance_m);
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
	return countWithin(points, PlaneF(plane), static_cast<float>(config.tolerance_m));
}

/** Draws after which a plane that holds `share` of the points was drawn with probability 1 − kMissProbability. */
double drawsNeeded(double share)
{
	const double all_three = std::clamp(share * share * share, 1e-12, 1.0 - 1e-12);
	return std::log(kMissProbability) / std::log(1.0 - all_three);
}

std::optional<Plane> bestHypothesis(const PointCloud& points, const PointCloud& sample, const PlaneSearchConfig& config,
                                    RandomEngine& random, const std::optional<NormalCone>& cone)
{
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

/** Least squares on the points within half the tolerance: what stands on the plane or beside it lies further out and
 * would tilt a fit to all inliers. */
Plane refitted(const PointCloud& points, const Plane& plane, double tolerance_m)
{
	const auto core = inliersOf(points, plane, 0.5 * tolerance_m);
	return core.size() < 3 ? plane : fitPlane(points, core);
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
	const PointCloud sample = scoringSample(points);
	auto plane = bestHypothesis(points, sample, config, random, cone);
	if (!plane) return std::nullopt;
	// The sample leads close to the optimum, all points give it its precision.
	for (int i = 0; i < kSampleRefits; ++i) *plane = refitted(sample, *plane, config.tolerance_m);
	*plane = refitted(points, *plane, config.tolerance_m);
	FoundPlane found{*plane, inliersOf(points, *plane, config.tolerance_m)};
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
	int inside = 0, above = 0, below = 0;
	for (std::size_t i = 0; i < points.size();
	     ++i)  // one pass without branches, because it is where RANSAC spends its time
	{
		const float distance = plane_f.distance(points, i);
		inside += static_cast<int>(std::abs(distance) <= tolerance);
		above += static_cast<int>(distance > tolerance) & static_cast<int>(distance <= 3 * tolerance);
		below += static_cast<int>(distance < -tolerance) & static_cast<int>(distance >= -3 * tolerance);
	}
	return inside - std::max(above, below);
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

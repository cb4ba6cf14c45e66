#include <explore/core/geometry.h>
#include <explore/perception/wall_bend.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace explore
{
namespace
{
constexpr double kMinLength_m = 1.0;
constexpr std::size_t kMinSamples = 600;
constexpr double kSquare_rad = 8 * kDegree_rad;  // rooms are square; what is further off is another room's wall
constexpr double kMinLever_m = 0.8;              // between the lateral distances of two walls
constexpr double kMinCosine = 0.966;             // of the view's elevation, 15°
constexpr double kBuilding_per_m = 0.0015;       // walls 2 m apart are parallel to 0.2° or so
constexpr std::size_t kMinFrames = 20;
constexpr double kSigmas = 3.0;
constexpr double kWorthSaying_per_m = 0.004;  // 10 cm at 5 m

bool isLong(const UprightWall& wall)
{
	return wall.samples >= kMinSamples && wall.to_m - wall.from_m >= kMinLength_m;
}

/** How fast a wall's normal turns with k: its lateral distance. */
double leverOf(const UprightWall& wall)
{
	return wall.normal.y() * wall.offset_m;
}

double directionOf(const UprightWall& wall)
{
	return std::atan2(wall.normal.y(), wall.normal.x());
}
}  // namespace

double WallBend::sigmaPerM() const
{
	if (!(weight > 0)) return 1.0;
	const double variance = std::max(0.0, weighted_squares / weight - curvaturePerM() * curvaturePerM());
	return std::hypot(kBuilding_per_m, std::sqrt(variance / static_cast<double>(frames)));
}

WallBend withFrame(const WallBend& bend, std::span<const UprightWall> walls, const LevelPose& pose)
{
	if (pose.level_from_camera.linear()(0, 0) < kMinCosine) return bend;
	double weight = 0, weighted = 0;
	for (std::size_t a = 0; a < walls.size(); ++a)
		for (std::size_t b = a + 1; b < walls.size(); ++b)
		{
			if (!isLong(walls[a]) || !isLong(walls[b])) continue;
			const double lever = leverOf(walls[b]) - leverOf(walls[a]);
			if (std::abs(lever) < kMinLever_m) continue;
			const double turn = std::remainder(directionOf(walls[b]) - directionOf(walls[a]), 0.5 * std::numbers::pi);
			if (std::abs(turn) > kSquare_rad) continue;
			weight += lever * lever;
			weighted -= lever * turn;
		}
	if (!(weight > 0)) return bend;
	const double curvature = weighted / weight;
	// frames count alike: many walls in one view share their errors
	return {bend.frames + 1, bend.weight + 1.0, bend.weighted + curvature,
	        bend.weighted_squares + curvature * curvature};
}

std::optional<std::string> bentWallRemark(const WallBend& bend)
{
	const double curvature = bend.curvaturePerM();
	if (bend.frames < kMinFrames || std::abs(curvature) < kWorthSaying_per_m) return std::nullopt;
	if (std::abs(curvature) < kSigmas * bend.sigmaPerM()) return std::nullopt;
	std::ostringstream text;
	text << std::fixed << std::setprecision(0) << "Walls that should be square look bent, as if depths were "
	     << 100.0 * 25.0 * std::abs(curvature) << " cm too " << (curvature > 0 ? "large" : "small")
	     << " at 5 m: change [camera] depth_quadratic by " << std::setprecision(4) << std::showpos << -curvature
	     << std::noshowpos << " (seen in " << bend.frames << " frames, +-" << bend.sigmaPerM()
	     << "), and depth_scale where known distances are wrong as well";
	return text.str();
}
}  // namespace explore

#include <explore/perception/corridor_end_evidence.h>

#include <algorithm>
#include <numeric>

namespace explore
{
namespace
{
constexpr double kPastEdge_m = 2.0;      ///< a door is no wider
constexpr double kEdge_m = 0.1;          ///< past an edge that may still be it
constexpr double kFloorBehind_m = 0.05;  ///< floor further behind a side's plane is not that before it
constexpr double kFloorBeyond_m = 0.15;  ///< the same for the end itself
constexpr double kBefore_m = 0.25;       ///< what stands so near before the end stands in it
constexpr double kBesideWall_m = 0.08;   ///< what is so near to a side wall's edge is that wall
constexpr double kTop_m = 1.7;           ///< no robot is higher

/** Sorts rays into the lanes of an end. */
class LaneCounter
{
public:
	LaneCounter(const EndLine& end, double free_beyond_m) : m_end(end), m_free_beyond_m(free_beyond_m)
	{
		const auto count = static_cast<std::size_t>(std::ceil(end.width_m() / EndLanes::kLane_m));
		m_lanes.through.resize(count);
		m_lanes.stopped.resize(count);
	}
	void addUpright(double along_m, double across_m)
	{
		const double line = lineAt(across_m);
		if (along_m < line - kBefore_m || along_m <= 0) return;
		const bool side_wall = across_m < kBesideWall_m - m_end.right_m || across_m > m_end.left_m - kBesideWall_m;
		if (side_wall && along_m < line + kBesideWall_m) return;
		count(along_m > line + m_free_beyond_m ? m_lanes.through : m_lanes.stopped, along_m, across_m);
	}
	/** Floor that is seen beyond says that a ray goes on; floor before it says nothing. */
	void addFloor(double along_m, double across_m)
	{
		if (along_m > lineAt(across_m) + kFloorBeyond_m) count(m_lanes.through, along_m, across_m);
	}
	[[nodiscard]] EndLanes take() { return std::move(m_lanes); }

private:
	[[nodiscard]] double lineAt(double across_m) const
	{
		return m_end.alongAt(std::clamp(across_m, -m_end.right_m, m_end.left_m));
	}
	/** The lane in which the ray passes the end; what stands before it is taken where it is. */
	void count(std::vector<int>& lanes, double along_m, double across_m)
	{
		const double passes = across_m * std::min(1.0, lineAt(across_m) / along_m);
		const double lane = (passes + m_end.right_m) / EndLanes::kLane_m;
		if (lane >= 0 && lane < static_cast<double>(lanes.size())) ++lanes[static_cast<std::size_t>(lane)];
	}

	const EndLine& m_end;
	double m_free_beyond_m;
	EndLanes m_lanes;
};

/** Thinned pixels without return whose rays pass the end between floor and robot's height. */
int countNoReturns(const EndLine& end, const Eigen::Vector2d& direction, const LevelView& view)
{
	const Eigen::Matrix3d level_from_camera = view.pose.level_from_camera.linear();
	const Eigen::Vector2d left = leftOf(direction);
	const CameraIntrinsics& camera = view.image->intrinsics;
	const double middle_along = 0.5 * (end.left_along_m + end.right_along_m);
	int count = 0;
	for (int v = 0; v < camera.height_px; v += view.samples.stride)
		for (int u = 0; u < camera.width_px; u += view.samples.stride)
		{
			if (view.image->at(u, v) > 0) continue;
			const Eigen::Vector3d ray = level_from_camera * rayOfPixel(camera, u, v);
			const double reach = middle_along / direction.dot(ray.head<2>());
			const double across = reach * left.dot(ray.head<2>()),
			             height = view.pose.cameraHeight_m() + reach * ray.z();
			if (reach > 0 && across > -end.right_m && across < end.left_m && height > 0 && height < kTop_m) ++count;
		}
	return count;
}
}  // namespace

EndSide sideOf(const FacingWalls& walls, Side side, double edge_m)
{
	return side == Side::left ? EndSide{1.0, edge_m, walls.left_m} : EndSide{-1.0, edge_m, walls.right_m};
}

EndSide sideOf(const EndLine& end, Side side)
{
	return side == Side::left ? EndSide{1.0, end.left_along_m, end.left_m}
	                          : EndSide{-1.0, end.right_along_m, end.right_m};
}

double shallowLength(const EndSide& side, const CorridorScan& scan, double wider_m, const UprightWallConfig& walls)
{
	const TurnedPoints& turned = scan.turned_upright;
	const double spacing = sampleSpacing(scan.view);
	SideProfile shallow;
	for (std::size_t i = 0; i < scan.upright.size(); ++i)
	{
		const double behind = side.behind_m(turned.across[i]);
		if (behind > wider_m || turned.along[i] < side.edge_m) continue;
		const double tolerance = toleranceAcross(turned.across[i], scan.upright.sigma_per_m[i], walls);
		if (behind < tolerance || !runsAlong(i, scan.upright, turned, spacing)) continue;
		const double strip = (turned.along[i] - SideProfile::kFirst_m) / SideProfile::kStrip_m;
		if (strip < static_cast<double>(SideProfile::kStrips)) ++shallow.points[static_cast<std::size_t>(strip)];
	}
	return shallow.pointsBetween(side.edge_m, side.edge_m + kPastEdge_m);
}

int floorBehind(const EndSide& side, const CorridorScan& scan)
{
	const TurnedPoints& turned = scan.turned_floor;
	int count = 0;
	for (std::size_t i = 0; i < turned.along.size(); ++i)
		if (side.behind_m(turned.across[i]) > kFloorBehind_m && turned.along[i] > side.edge_m) ++count;
	return count;
}

double wallAgain(const EndSide& side, const SideProfile& profile, double spacing_rad)
{
	// An edge is good to one sample.
	const double reach = kEdge_m + spacing_rad * (side.edge_m * side.edge_m / side.distance_m + side.distance_m);
	return profile.pointsBetween(side.edge_m + reach, side.edge_m + reach + kPastEdge_m);
}

int EndLanes::passed() const
{
	return std::accumulate(through.begin(), through.end(), 0);
}

double EndLanes::throughShare() const
{
	const int all = passed() + std::accumulate(stopped.begin(), stopped.end(), 0);
	return all > 0 ? static_cast<double>(passed()) / all : 0.0;
}

double EndLanes::laneShare() const
{
	const auto open = std::ranges::count_if(through, [](int rays) { return rays > 0; });
	return through.empty() ? 0.0 : static_cast<double>(open) / static_cast<double>(through.size());
}

double EndLanes::widestClear_m() const
{
	constexpr double kStray = 0.1;  // of a lane's rays: noise at the edges of what is behind
	std::size_t run = 0, widest = 0;
	for (std::size_t lane = 0; lane < through.size(); ++lane)
	{
		const bool clear = stopped[lane] <= kStray * through[lane] + 1;
		run = clear ? run + 1 : 0;
		widest = std::max(widest, run);
	}
	return static_cast<double>(widest) * kLane_m;
}

EndLanes endLanes(const EndLine& end, const Eigen::Vector2d& direction, const CorridorScan& scan, double free_beyond_m)
{
	LaneCounter counter(end, free_beyond_m);
	for (std::size_t i = 0; i < scan.upright.size(); ++i)
		if (scan.view.samples.z[scan.upright.sample[i]] < kTop_m)
			counter.addUpright(scan.turned_upright.along[i], scan.turned_upright.across[i]);
	for (std::size_t i = 0; i < scan.floor.size(); ++i)
		counter.addFloor(scan.turned_floor.along[i], scan.turned_floor.across[i]);
	EndLanes lanes = counter.take();
	lanes.no_return = countNoReturns(end, direction, scan.view);
	return lanes;
}
}  // namespace explore

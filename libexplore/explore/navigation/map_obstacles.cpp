#include <explore/navigation/map_obstacles.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore
{
namespace
{
/** Unknown space that the body touches all but: it stands there, and gets away from it as it moves. */
constexpr double kTouch_cells = 2.5;

bool isEdgeOfUnknown(const BodyLayers& layers, const LayerCell& cell)
{
	static constexpr std::array<std::array<int, 2>, 4> kBeside{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
	return std::any_of(kBeside.begin(), kBeside.end(),
	                   [&](const std::array<int, 2>& step)
	                   {
		                   const LayerCell next{cell.column + step[0], cell.row + step[1], cell.layer};
		                   return layers.stateOf(next) == CellState::free;
	                   });
}

bool blocks(const BodyLayers& layers, const LayerCell& cell)
{
	const CellState state = layers.stateOf(cell);
	if (state == CellState::unknown) return isEdgeOfUnknown(layers, cell);
	return state != CellState::free;
}
}  // namespace

PointCloud mapObstacles(const BodyLayers& layers, const Eigen::Isometry3d& map_from_robot, const RobotConfig& robot,
                        double range_m, bool unknown_blocks)
{
	PointCloud points;
	const LayerFrame& frame = layers.frame();
	const Eigen::Vector3d at = map_from_robot.translation();
	const LayerCell middle = frame.cellAt(at.head<2>(), frame.nearestLayer(at.z()));
	const int reach = static_cast<int>(std::ceil(range_m / frame.resolution_m));
	const double z_m = robot.kind == RobotKind::ground ? at.z() + 0.5 * robot.height_m : at.z();
	const Eigen::Isometry3d robot_from_map = map_from_robot.inverse();
	for (int row = middle.row - reach; row <= middle.row + reach; ++row)
		for (int column = middle.column - reach; column <= middle.column + reach; ++column)
		{
			const LayerCell cell{column, row, middle.layer};
			if (!blocks(layers, cell)) continue;
			const Eigen::Vector2d centre =
			    frame.corner_in_map + frame.resolution_m * Eigen::Vector2d(column + 0.5, row + 0.5);
			const bool touches = (centre - at.head<2>()).norm() < robot.radius_m + kTouch_cells * frame.resolution_m;
			if (layers.stateOf(cell) == CellState::unknown && (touches || !unknown_blocks)) continue;
			const Eigen::Vector3d point(centre.x(), centre.y(), z_m);
			points.push_back((robot_from_map * point).cast<float>());
		}
	return points;
}
}  // namespace explore

#include <explore/core/errors.h>
#include <explore/memory/body_layers.h>
#include <mrpt/core/format.h>

#include <cmath>
#include <numeric>
#include <utility>

namespace explore
{
namespace
{
constexpr int kMaxCount = 255;

/** The range, moved outward to whole steps. */
KeyRange inSteps(const KeyRange& range, int step)
{
	// Numbers are those of an octree, thus not negative.
	return {range.first / step * step, (range.last / step + 1) * step - 1};
}

/** The numbers of the voxels that the disc reaches, along x or y. */
KeyRange reachOf(double centre_m, double radius_m, double resolution_m)
{
	return keysBetween(centre_m - radius_m, centre_m + radius_m, resolution_m);
}
}  // namespace

BodyLayers::BodyLayers(const BodyLayersConfig& config, const RobotConfig& robot, double resolution_m)
    : m_config(config), m_robot(robot)
{
	m_frame.resolution_m = resolution_m;
	const auto keys = [&](double low_m, double high_m)
	{ return keysBetween(config.floor_z_m + low_m, config.floor_z_m + high_m, resolution_m); };
	if (robot.kind == RobotKind::ground)
	{
		const double lowest_m = lowestOfBody(config, resolution_m);
		addLayer(config.floor_z_m + 0.5 * (lowest_m + robot.height_m),
		         {.body = keys(lowest_m, robot.height_m),
		          .floor = keys(-config.floor_tolerance_m, config.floor_tolerance_m),
		          .deep = keys(-config.drop_reach_m, -config.drop_m)});
		return;
	}
	const double half_m = 0.5 * robot.height_m + config.body_margin_m;
	const auto add = [&](double altitude_m)
	{
		addLayer(config.floor_z_m + altitude_m,
		         {.body = keys(altitude_m - half_m, altitude_m + half_m), .floor = {}, .deep = {}});
	};
	constexpr double kSame_m = 1e-6;
	for (int i = 0; robot.min_altitude_m + i * config.layer_step_m < robot.max_altitude_m - kSame_m; ++i)
		add(robot.min_altitude_m + i * config.layer_step_m);
	add(robot.max_altitude_m);
}

void BodyLayers::addLayer(double altitude_in_map_m, const Bands& bands)
{
	const int layer = m_frame.layers();
	m_frame.altitudes_m.push_back(altitude_in_map_m);
	m_bands.push_back(bands);
	const KeyRange reach = bands.body.with(bands.floor).with(bands.deep);
	m_heights = m_heights.with(reach);
	m_layers_at.resize(static_cast<std::size_t>(m_heights.size()), {layer, layer - 1});
	for (int key = reach.first; key <= reach.last; ++key)
		m_layers_at[static_cast<std::size_t>(key - m_heights.first)].last = layer;
	const int most = std::max({bands.body.size(), bands.floor.size(), bands.deep.size()});
	if (most > kMaxCount)
		throw ConfigError(
		    mrpt::format("a layer of %d voxels is too high, at most %d: [map] resolution = %g is too small for the "
		                 "robot's height",
		                 most, kMaxCount, m_frame.resolution_m));
}

void BodyLayers::grow(const KeyRange& x, const KeyRange& y)
{
	if (x.size() == 0 || y.size() == 0) return;
	const int step = std::max(1, static_cast<int>(std::ceil(m_config.growth_m / m_frame.resolution_m)));
	const Eigen::Vector2i first = m_frame.first.array() + kOriginKey;
	// A cell more: what is free at the edge has unknown space beside it.
	const KeyRange columns =
	    inSteps({x.first - 1, x.last + 1}, step).with({first.x(), first.x() + m_frame.columns - 1});
	const KeyRange rows = inSteps({y.first - 1, y.last + 1}, step).with({first.y(), first.y() + m_frame.rows - 1});
	if (columns.size() == m_frame.columns && rows.size() == m_frame.rows) return;
	const double edge_m = m_frame.resolution_m * std::max(columns.size(), rows.size());
	if (edge_m > m_config.max_edge_m)
		throw InputError(mrpt::format("the map reaches over %.1f m, [layers] max_edge = %g allows no more", edge_m,
		                              m_config.max_edge_m));
	LayerFrame grown = m_frame;
	grown.first = Eigen::Vector2i(columns.first, rows.first).array() - kOriginKey;
	grown.corner_in_map = m_frame.resolution_m * grown.first.cast<double>();
	grown.columns = columns.size();
	grown.rows = rows.size();
	m_counts = movedCells(m_counts, m_frame, grown, {});
	m_states = movedCells(m_states, m_frame, grown, CellState::unknown);
	m_frame = std::move(grown);
}

KeyRange BodyLayers::layersAt(const KeyRange& z) const
{
	const KeyRange seen = z.common(m_heights);
	if (seen.size() == 0) return {};
	const auto at = [&](int key) { return m_layers_at[static_cast<std::size_t>(key - m_heights.first)]; };
	return {at(seen.first).first, at(seen.last).last};
}

void BodyLayers::include(const KeyBox& voxels, VoxelState state, int sign)
{
	if (state == VoxelState::unknown) return;
	const Eigen::Vector2i first = m_frame.first.array() + kOriginKey;
	const KeyRange layers = layersAt(voxels.z);
	for (int layer = layers.first; layer <= layers.last; ++layer)
	{
		const Bands& bands = m_bands[static_cast<std::size_t>(layer)];
		const bool occupied = state == VoxelState::occupied;
		const int in_body = sign * voxels.z.common(bands.body).size();
		const int below = sign * voxels.z.common(occupied ? bands.floor : bands.deep).size();
		if (in_body == 0 && below == 0) continue;
		for (int y = voxels.y.first; y <= voxels.y.last; ++y)
			for (int x = voxels.x.first; x <= voxels.x.last; ++x)
			{
				const std::size_t index = m_frame.indexOf({x - first.x(), y - first.y(), layer});
				Counts& counts = m_counts[index];
				const auto add = [](std::uint8_t& count, int more) { count = static_cast<std::uint8_t>(count + more); };
				add(occupied ? counts.occupied : counts.free, in_body);
				add(occupied ? counts.floor_occupied : counts.deep_free, below);
				touch(index);
			}
	}
}

void BodyLayers::growFor(KeyRange x, KeyRange y)
{
	for (const Eigen::Vector3d& place : m_stood)
	{
		x = x.with(reachOf(place.x(), m_robot.radius_m, m_frame.resolution_m));
		y = y.with(reachOf(place.y(), m_robot.radius_m, m_frame.resolution_m));
	}
	grow(x, y);
}

void BodyLayers::update(std::span<const VoxelChange> changes)
{
	KeyRange x, y;
	for (const VoxelChange& change : changes)
	{
		if (!m_heights.contains(change.key[2])) continue;
		x = x.with({change.key[0], change.key[0]});
		y = y.with({change.key[1], change.key[1]});
	}
	growFor(x, y);
	for (const VoxelChange& change : changes)
	{
		const octomap::OcTreeKey& key = change.key;
		if (!m_heights.contains(key[2])) continue;
		const KeyBox voxel{{key[0], key[0]}, {key[1], key[1]}, {key[2], key[2]}};
		include(voxel, change.before, -1);
		include(voxel, change.after, 1);
	}
	settle();
}

void BodyLayers::rebuild(const octomap::OcTree& map)
{
	KeyRange x, y;
	forEachLeaf(map,
	            [&](const KeyBox& leaf, bool)
	            {
		            if (leaf.z.common(m_heights).size() == 0) return;
		            x = x.with(leaf.x);
		            y = y.with(leaf.y);
	            });
	growFor(x, y);
	std::ranges::fill(m_counts, Counts{.touched = true});
	m_touched.resize(m_counts.size());
	std::iota(m_touched.begin(), m_touched.end(), std::size_t{0});
	forEachLeaf(map, [&](const KeyBox& leaf, bool occupied)
	            { include(leaf, occupied ? VoxelState::occupied : VoxelState::free, 1); });
	settle();
}

void BodyLayers::stood(const Eigen::Vector3d& robot_in_map)
{
	m_stood.push_back(robot_in_map);
}

std::optional<int> BodyLayers::layerOf(double z_m) const
{
	if (m_robot.kind == RobotKind::ground) return 0;
	const std::vector<double>& altitudes_m = m_frame.altitudes_m;
	const auto nearest =
	    std::ranges::min_element(altitudes_m, {}, [&](double altitude_m) { return std::abs(altitude_m - z_m); });
	if (!(std::abs(*nearest - z_m) <= 0.5 * m_config.layer_step_m)) return std::nullopt;
	return static_cast<int>(nearest - altitudes_m.begin());
}

void BodyLayers::standAt(const Eigen::Vector3d& robot_in_map)
{
	const std::optional<int> layer = layerOf(robot_in_map.z());
	if (!layer) return;
	const Eigen::Vector2d reach = Eigen::Vector2d::Constant(m_robot.radius_m);
	const LayerCell low = m_frame.cellAt(robot_in_map.head<2>() - reach, *layer);
	const LayerCell high = m_frame.cellAt(robot_in_map.head<2>() + reach, *layer);
	for (LayerCell cell = low; cell.row <= high.row; ++cell.row)
		for (cell.column = low.column; cell.column <= high.column; ++cell.column)
		{
			if (!m_frame.holds(cell)) continue;
			const std::size_t index = m_frame.indexOf(cell);
			if ((m_frame.centreOf(index) - robot_in_map.head<2>()).norm() > m_robot.radius_m) continue;
			m_counts[index].stood = true;
			touch(index);
		}
}

void BodyLayers::touch(std::size_t index)
{
	if (!std::exchange(m_counts[index].touched, true)) m_touched.push_back(index);
}

CellState BodyLayers::stateFrom(const Counts& counts)
{
	if (counts.occupied > 0) return CellState::occupied;
	if (counts.stood) return CellState::free;
	if (counts.deep_free > 0 && counts.floor_occupied == 0) return CellState::drop;
	return counts.free > 0 ? CellState::free : CellState::unknown;
}

void BodyLayers::settle()
{
	for (const Eigen::Vector3d& place : m_stood) standAt(place);
	m_stood.clear();
	m_changed.clear();
	for (const std::size_t index : m_touched)
	{
		m_counts[index].touched = false;
		const CellState now = stateFrom(m_counts[index]);
		if (std::exchange(m_states[index], now) != now) m_changed.push_back(index);
	}
	m_touched.clear();
	++m_revision;
}
}  // namespace explore

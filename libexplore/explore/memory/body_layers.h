// What a robot's body would meet at each place: cells seen from above, kept up to date from the changed voxels alone.
#pragma once

#include <explore/core/robot.h>
#include <explore/memory/body_layers_config.h>
#include <explore/memory/layer_frame.h>
#include <explore/memory/occupancy.h>

#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace explore
{
enum class CellState : std::uint8_t
{
	unknown,
	free,
	occupied,
	drop,  ///< ground robot: nothing carries it there
};

/** A ground robot has one layer, from config.lowest_m to its height above the floor; a MAV one for each altitude of its
 *  flight band, config.layer_step_m apart and one at the top, from half its height plus config.body_margin_m below to
 *  as much above.
 *
 *  A cell is occupied where any voxel of its column in the layer is; else free where at least one is, as in
 * floor_map.h, and unknown otherwise. For a ground robot it is a drop, not free or unknown, where free voxels lie lower
 * below the floor than config.drop_m and no voxel of the floor is occupied. What the body stood on is free for good
 * wherever it is not occupied: the camera does not see its own feet.
 *
 *  Memory: 7 bytes a cell, 2.8 kB a square metre and layer at 5 cm. */
class BodyLayers
{
public:
	/** Throws ConfigError where a layer would be more than 255 voxels high. */
	BodyLayers(const BodyLayersConfig& config, const RobotConfig& robot, double resolution_m);

	/** Takes what an insertion changed; all changes since the map was empty, or since rebuild(), must come, in order.
	 *  Throws InputError, nothing changed, where the cells would reach over more than config.max_edge_m. */
	void update(std::span<const VoxelChange> changes);
	/** The body is or was there: z of the floor below a ground robot (it does not count), of the body's centre for a
	 *  MAV, whose nearest layer it is; nothing where none is within half a step. Counts from the next update() or
	 *  rebuild() on. */
	void stood(const Eigen::Vector3d& robot_in_map);
	/** Starts again from a map that was loaded or corrected. Places that the body stood on before the last update() are
	 *  forgotten: say them again, as corrected, before the call. Throws as update() does. */
	void rebuild(const octomap::OcTree& map);

	/** It grows as the map does and never shrinks; indices of cells change with it. Everything beyond it is unknown. */
	[[nodiscard]] const LayerFrame& frame() const { return m_frame; }
	/** By LayerFrame::indexOf. */
	[[nodiscard]] const std::vector<CellState>& cells() const { return m_states; }
	/** Unknown beyond the frame. */
	[[nodiscard]] CellState stateOf(const LayerCell& cell) const
	{
		return m_frame.holds(cell) ? m_states[m_frame.indexOf(cell)] : CellState::unknown;
	}
	/** Indices of the cells whose state the last update() or rebuild() changed, each once. */
	[[nodiscard]] const std::vector<std::size_t>& changedCells() const { return m_changed; }
	/** How many calls of update() and rebuild() there were. */
	[[nodiscard]] std::uint64_t revision() const { return m_revision; }

	/** Writes or reads all that goes on from call to call, for layers that were made alike. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_frame), archive(m_states), archive(m_stood), archive(m_changed), archive(m_revision);
		static_assert(std::has_unique_object_representations_v<Counts>, "its bytes are its value");
		m_counts.resize(m_states.size());
		archive.raw(m_counts.data(), m_counts.size() * sizeof(Counts));
	}

private:
	/** Numbers of voxels along z. */
	struct Bands
	{
		KeyRange body, floor, deep;
	};
	/** How many voxels there are of a kind in a cell's column. */
	struct Counts
	{
		std::uint8_t occupied = 0, free = 0, floor_occupied = 0, deep_free = 0;
		bool stood = false, touched = false;
	};

	/** From the lowest to the highest. */
	void addLayer(double altitude_in_map_m, const Bands& bands);
	/** The layers, from the first to the last, that look at any of these heights. */
	[[nodiscard]] KeyRange layersAt(const KeyRange& z) const;
	void grow(const KeyRange& x, const KeyRange& y);
	/** For voxels in these ranges and for the places that the body stood on. */
	void growFor(KeyRange x, KeyRange y);
	/** Counts the voxels in, or out again: `sign` is 1 or −1. The frame holds them. */
	void include(const KeyBox& voxels, VoxelState state, int sign);
	[[nodiscard]] std::optional<int> layerOf(double z_m) const;
	void standAt(const Eigen::Vector3d& robot_in_map);
	void touch(std::size_t index);
	static CellState stateFrom(const Counts& counts);
	/** Gives the touched cells their states. */
	void settle();

	BodyLayersConfig m_config;
	RobotConfig m_robot;
	LayerFrame m_frame;
	std::vector<Bands> m_bands;         ///< of each layer
	KeyRange m_heights;                 ///< all that any layer looks at
	std::vector<KeyRange> m_layers_at;  ///< the layers that look at each of these heights; higher ones come later
	std::vector<Counts> m_counts;
	std::vector<CellState> m_states;
	std::vector<Eigen::Vector3d> m_stood;  ///< since the last update
	std::vector<std::size_t> m_touched, m_changed;
	std::uint64_t m_revision = 0;
};
}  // namespace explore

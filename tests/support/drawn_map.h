// Maps drawn as text, as the layers that a robot's body moves in.
#pragma once

#include <explore/memory/frontier_memory.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace explore::test
{
/** '#' is occupied, 'v' a drop, '?' and ' ' are unknown; all else is free, letters being places that can be asked for.
 *  The last row has the smallest y, the lower left corner is the map's origin. MAVs find the same at every height. */
class DrawnMap
{
public:
	/** Each character is a square of cells of 5 cm, `character_m` wide; rows that are shorter end unknown. */
	explicit DrawnMap(std::vector<std::string> rows, double character_m = 0.05);

	/** Middle of the first character that is `mark`, on the floor. Throws std::out_of_range without one. */
	[[nodiscard]] Eigen::Vector3d at(char mark) const;
	/** Middle of a character on the floor; row 0 is the last one. */
	[[nodiscard]] Eigen::Vector3d middleOf(int column, int row) const;
	/** The character at a point; '?' beyond the drawing. */
	[[nodiscard]] char on(const Eigen::Vector2d& point_in_map) const;
	[[nodiscard]] int columns() const;
	[[nodiscard]] int rows() const { return static_cast<int>(m_rows.size()); }
	[[nodiscard]] char character(int column, int row) const;
	/** From a point to the square of a character, on the floor; 0 inside. */
	[[nodiscard]] double distanceTo(int column, int row, const Eigen::Vector3d& point_in_map) const;
	void set(int column, int row, char character);
	/** Sets the character at a point of the drawing. */
	void show(const Eigen::Vector2d& point_in_map, char character);
	/** The same with a character changed. */
	[[nodiscard]] DrawnMap with(int column, int row, char character) const;

	/** From `before`, which is as large, to this. */
	[[nodiscard]] std::vector<VoxelChange> changesSince(const DrawnMap& before, RobotKind kind) const;
	/** From an empty map to this. */
	[[nodiscard]] std::vector<VoxelChange> changes(RobotKind kind) const;

private:
	std::vector<std::string> m_rows;  ///< the last one first
	double m_character_m;
};

BodyLayers layersOf(const DrawnMap& map, const RobotConfig& robot = {});

/** The layers and frontiers of a memory that knows what is drawn, and nothing else. */
FrontierMemory memoryOf(const DrawnMap& map, const RobotConfig& robot = {});
/** Takes the memory from one drawing, which it was made of, to another. */
void change(FrontierMemory& memory, const DrawnMap& before, const DrawnMap& after, const RobotConfig& robot = {});
}  // namespace explore::test

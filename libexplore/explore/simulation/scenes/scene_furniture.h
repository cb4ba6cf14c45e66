// Things that stand about in made-up buildings: furniture, bins, plants, people.
#pragma once

#include <explore/simulation/scenes/scene_sketch.h>

#include <span>
#include <string>
#include <string_view>

namespace explore::simulation
{
/** A thing before it is put somewhere. Its frame: origin on the floor below its middle, x to its right, y to its back,
 *  z up. */
struct Piece
{
	std::string kind;
	Eigen::Vector3d size_m;  ///< of the box around it
};

/** Kinds that have their back to a wall, and those that stand anywhere. */
std::span<const std::string_view> wallKinds();
std::span<const std::string_view> freeKinds();

/** One of that kind, its size drawn. Throws std::out_of_range for a kind that does not exist. */
Piece drawPiece(Random& random, std::string_view kind);
/** Builds it, takes the floor under it and labels it as an obstacle; `body` empty = its kind. */
void putPiece(Sketch& sketch, const Piece& piece, const Eigen::Isometry3d& building_from_piece,
              const std::string& body = {});
/** putPiece() where nothing that was reserved is in its way; false where something is. */
bool tryPiece(Sketch& sketch, const Piece& piece, const Eigen::Isometry3d& building_from_piece);
}  // namespace explore::simulation

#include "scene_furniture.h"

#include <explore/simulation/scenes/scene_pieces.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace explore::simulation
{
namespace
{
struct Kind
{
	std::string_view name;
	Eigen::Vector3d smallest_m, largest_m;
	bool round;  ///< as deep as it is wide
	void (*build)(PieceMaker&);
};

const std::array<Kind, 16> kKinds = {{
    {"pedestrian", {0.42, 0.42, 1.5}, {0.56, 0.56, 1.95}, true, makePedestrian},
    {"box", {0.25, 0.25, 0.2}, {0.7, 0.6, 0.9}, false, makeBox},
    {"swivel_chair", {0.55, 0.55, 0.85}, {0.68, 0.68, 1.15}, true, makeSwivelChair},
    {"four_legged_chair", {0.38, 0.4, 0.8}, {0.5, 0.52, 1.0}, false, makeFourLeggedChair},
    {"armchair", {0.7, 0.7, 0.75}, {0.95, 0.9, 1.05}, false, makeArmchair},
    {"stool", {0.3, 0.3, 0.42}, {0.42, 0.42, 0.78}, true, makeStool},
    {"table", {0.8, 0.6, 0.68}, {1.8, 0.9, 0.78}, false, makeTable},
    {"desk", {1.1, 0.6, 0.7}, {1.7, 0.8, 0.76}, false, makeDesk},
    {"shelf", {0.6, 0.25, 0.9}, {1.4, 0.42, 2.1}, false, makeShelf},
    {"cabinet", {0.4, 0.35, 0.6}, {1.2, 0.55, 1.5}, false, makeCabinet},
    {"wardrobe", {0.6, 0.45, 1.7}, {1.4, 0.65, 2.2}, false, makeCabinet},
    {"bin", {0.22, 0.22, 0.25}, {0.4, 0.4, 0.75}, true, makeBin},
    {"plant", {0.35, 0.35, 0.6}, {0.8, 0.8, 1.8}, true, makePlant},
    {"lamp", {0.25, 0.25, 1.3}, {0.4, 0.4, 1.8}, true, makeLamp},
    {"conference_table", {1.8, 0.9, 0.7}, {3.2, 1.4, 0.78}, false, makeTable},
    {"pillar", {0.2, 0.2, 2.2}, {0.45, 0.45, 3.4}, true, makeBin},
}};

constexpr std::array<std::string_view, 7> kWallKinds = {"shelf", "cabinet", "wardrobe", "desk",
                                                        "table", "box",     "armchair"};
constexpr std::array<std::string_view, 9> kFreeKinds = {
    "box", "swivel_chair", "four_legged_chair", "armchair", "stool", "table", "bin", "plant", "lamp"};

const Kind& kindNamed(std::string_view name)
{
	const auto* kind =
	    std::find_if(kKinds.begin(), kKinds.end(), [name](const Kind& each) { return each.name == name; });
	if (kind == kKinds.end())
		throw std::out_of_range(std::string("there is no furniture of kind '").append(name).append("'"));
	return *kind;
}
}  // namespace

std::span<const std::string_view> wallKinds()
{
	return kWallKinds;
}

std::span<const std::string_view> freeKinds()
{
	return kFreeKinds;
}

Piece drawPiece(Random& random, std::string_view kind)
{
	const Kind& drawn = kindNamed(kind);
	Piece piece{std::string(kind), {}};
	for (int axis = 0; axis < 3; ++axis)
		piece.size_m[axis] = random.uniform(drawn.smallest_m[axis], drawn.largest_m[axis]);
	if (drawn.round) piece.size_m.y() = piece.size_m.x();
	return piece;
}

void putPiece(Sketch& sketch, const Piece& piece, const Eigen::Isometry3d& building_from_piece, const std::string& body)
{
	const std::string name = body.empty() ? piece.kind : body;
	PieceMaker maker(sketch, name, piece.size_m, building_from_piece);
	kindNamed(piece.kind).build(maker);
	sketch.floor_use.take(footprint(building_from_piece, piece.size_m.head<2>()));
	sketch.world.obstacles.push_back(
	    {piece.kind, building_from_piece.translation(), 0.5 * piece.size_m.head<2>().norm(), piece.size_m.z()});
}

bool tryPiece(Sketch& sketch, const Piece& piece, const Eigen::Isometry3d& building_from_piece)
{
	if (!sketch.floor_use.isFree(footprint(building_from_piece, piece.size_m.head<2>()), piece.size_m.z()))
		return false;
	putPiece(sketch, piece, building_from_piece);
	return true;
}
}  // namespace explore::simulation

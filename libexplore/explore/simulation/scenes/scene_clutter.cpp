#include "scene_clutter.h"

#include <explore/simulation/scenes/scene_furniture.h>

#include <algorithm>

namespace explore::simulation
{
namespace
{
constexpr int kTries = 6;
constexpr double kKeepFromWall_m = 0.05;

std::string_view oneOf(Random& random, std::span<const std::string_view> kinds)
{
	return kinds[static_cast<std::size_t>(random.integer(0, static_cast<int>(kinds.size()) - 1))];
}

bool putAtWall(Sketch& sketch, const Space& space, const Piece& piece)
{
	Random& random = sketch.random;
	const auto side = static_cast<Side>(random.integer(0, 3));
	const Span reach = Span{0, lengthOf(space, side)}.grown(-0.5 * piece.size_m.x() - kKeepFromWall_m);
	if (reach.length() <= 0) return false;
	const double gap_m = std::max(sketch.style.skirting_depth_m, random.uniform(0.0, 0.06)) + 0.005;
	const WallFrame face = faceOf(space, side);
	return tryPiece(sketch, piece, face.pose(sketch.draw(reach), -(0.5 * piece.size_m.y() + gap_m)));
}

bool putAnywhere(Sketch& sketch, const Space& space, const Piece& piece)
{
	const double half_m = 0.5 * piece.size_m.head<2>().norm() + kKeepFromWall_m;
	const Span along = space.along.grown(-half_m), behind = space.behind.grown(-half_m);
	if (along.length() <= 0 || behind.length() <= 0) return false;
	const double along_m = sketch.draw(along), behind_m = sketch.draw(behind);
	return tryPiece(sketch, piece,
	                space.frame.pose(along_m, behind_m, 0, sketch.random.uniform(0, 2 * std::numbers::pi)));
}

void hang(Sketch& sketch, const WallFrame& face, double length_m)
{
	Random& random = sketch.random;
	const bool radiator = random.chance(0.3);
	const double width_m = random.uniform(0.3, 1.4);
	if (length_m < width_m + 0.2) return;
	const Span along = around(random.uniform(0.1 + 0.5 * width_m, length_m - 0.1 - 0.5 * width_m), width_m);
	const double low_m = radiator ? random.uniform(0.1, 0.18) : random.uniform(1.1, 1.6);
	const Span z{low_m, low_m + (radiator ? random.uniform(0.45, 0.7) : random.uniform(0.25, 0.8))};
	const Span behind{radiator ? -random.uniform(0.07, 0.13) : -random.uniform(0.01, 0.035), -0.001};
	const Outline outline = rectangleOutline(face, along, behind);
	if (z.high > sketch.style.wall_height_m || !sketch.floor_use.isFree(outline, 0)) return;
	sketch.block(radiator ? "radiator" : "picture", face, along, behind, z, sketch.paint());
	if (radiator) sketch.floor_use.take(outline);
}
}  // namespace

void furnish(Sketch& sketch, const Space& space, int things)
{
	Random& random = sketch.random;
	for (int i = 0; i < things; ++i)
	{
		const bool at_wall = random.chance(0.6);
		const Piece piece = drawPiece(random, oneOf(random, at_wall ? wallKinds() : freeKinds()));
		for (int attempt = 0; attempt < kTries; ++attempt)
			if (at_wall ? putAtWall(sketch, space, piece) : putAnywhere(sketch, space, piece)) break;
	}
}

void decorate(Sketch& sketch, const Space& space, std::initializer_list<Side> sides)
{
	for (const Side side : sides)
		for (int i = sketch.random.integer(0, 2); i > 0; --i) hang(sketch, faceOf(space, side), lengthOf(space, side));
}
}  // namespace explore::simulation

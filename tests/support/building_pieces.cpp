#include "support/building_pieces.h"

#include <algorithm>
#include <cmath>

namespace explore::test
{
namespace
{
using Eigen::Vector3d;

void legs(Sketch& sketch, const char* name, Look look, const Place& place, const PlanSize& size, double leg_m,
          double height_m)
{
	for (const double x : {-0.5, 0.5})
		for (const double y : {-0.5, 0.5})
			sketch.box(name, look, place, {x * (size.x() - leg_m), y * (size.y() - leg_m), 0.5 * height_m},
			           {leg_m, leg_m, height_m});
}

void obstacle(Sketch& sketch, const char* kind, const Place& place, const PlanSize& size, double height_m)
{
	sketch.obstacles.push_back({kind, place.origin, 0.5 * size.norm(), height_m});
}
}  // namespace

void buildTable(Sketch& sketch, const Place& place, const PlanSize& size, double height_m, Dice& dice)
{
	const Look look = dice.chance(0.6) ? Look::wood : Look::white;
	const double top_m = dice.between(0.02, 0.04);
	sketch.box("table", look, place, {0, 0, height_m - 0.5 * top_m}, {size.x(), size.y(), top_m});
	legs(sketch, "table", Look::metal, place, size - PlanSize(0.04, 0.04), dice.between(0.03, 0.07), height_m - top_m);
	if (dice.chance(0.3))
		sketch.box("table", look, place, {-0.45 * size.x(), 0, 0.45 * height_m},
		           {0.02, size.y() - 0.2, 0.5 * height_m});
	if (dice.chance(0.4))
	{
		sketch.box("screen", Look::black, place, {-0.2 * size.x(), 0, height_m + 0.32}, {0.03, 0.55, 0.33});
		sketch.box("screen", Look::metal, place, {-0.2 * size.x(), 0, height_m + 0.08}, {0.03, 0.05, 0.16});
	}
	obstacle(sketch, "table", place, size, height_m);
}

void buildChair(Sketch& sketch, const Place& place, Dice& dice)
{
	const double seat_m = dice.between(0.43, 0.48), back_m = dice.between(0.80, 1.0);
	const PlanSize size(0.42, 0.42);
	sketch.box("chair", Look::wood, place, {0, 0, seat_m - 0.015}, {size.x(), size.y(), 0.03});
	legs(sketch, "chair", Look::wood, place, size, dice.between(0.022, 0.04), seat_m - 0.03);
	for (const double y : {-0.19, 0.19})
		sketch.box("chair", Look::wood, place, {-0.2, y, 0.5 * (seat_m + back_m)}, {0.025, 0.03, back_m - seat_m});
	sketch.box("chair", Look::wood, place, {-0.2, 0, back_m - 0.1}, {0.02, 0.38, 0.2});
	obstacle(sketch, "chair", place, size, back_m);
}

void buildSwivelChair(Sketch& sketch, const Place& place, Dice& dice)
{
	constexpr int kArms = 5;
	for (int i = 0; i < kArms; ++i)
		sketch.box("swivel", Look::metal, place.then({0, 0}, 2 * std::acos(-1.0) * i / kArms), {0.15, 0, 0.07},
		           {0.30, 0.04, 0.03});
	sketch.cylinder("swivel", Look::metal, place, {0, 0, 0.25}, 0.03, 0.36);
	sketch.box("swivel", Look::fabric, place, {0, 0, 0.46}, {0.48, 0.48, 0.08});
	sketch.box("swivel", Look::fabric, place, {-0.24, 0, 0.80}, {0.07, 0.44, dice.between(0.4, 0.6)}, 0, -0.15);
	obstacle(sketch, "swivel_chair", place, {0.6, 0.6}, 1.05);
}

void buildShelf(Sketch& sketch, const Place& place, const PlanSize& size, double height_m, Dice& dice)
{
	const bool back = dice.chance(0.5);
	const int boards = std::max(2, static_cast<int>(height_m / dice.between(0.30, 0.42)));
	for (const double y : {-0.5, 0.5})
		sketch.box("shelf", Look::wood, place, {0, y * (size.y() - 0.02), 0.5 * height_m}, {size.x(), 0.02, height_m});
	for (int i = 0; i <= boards; ++i)
	{
		const double z = 0.05 + (height_m - 0.07) * i / boards;
		sketch.box("shelf", Look::wood, place, {0, 0, z}, {size.x(), size.y() - 0.04, 0.02});
		for (double y = -0.5 * size.y() + 0.03; i < boards && y < 0.5 * size.y() - 0.3;)
		{
			const double wide = dice.between(0.1, 0.5), high = dice.between(0.15, 0.26);
			if (dice.chance(0.6) && y + wide < 0.5 * size.y() - 0.03)
				sketch.box("books", Look::cardboard, place, {-0.03, y + 0.5 * wide, z + 0.01 + 0.5 * high},
				           {size.x() - 0.08, wide, high});
			y += wide + dice.between(0.02, 0.2);
		}
	}
	if (back)
		sketch.box("shelf", Look::wood, place, {-0.5 * size.x() + 0.005, 0, 0.5 * height_m},
		           {0.01, size.y(), height_m});
	obstacle(sketch, "shelf", place, size, height_m);
}

void buildCupboard(Sketch& sketch, const Place& place, const PlanSize& size, double height_m, Dice& dice)
{
	const Look look = dice.chance(0.07) ? Look::black : (dice.chance(0.5) ? Look::wood : Look::white);
	const double foot = dice.chance(0.5) ? dice.between(0.05, 0.12) : 0;
	sketch.block("cupboard", look, place, {-0.5 * size.x(), -0.5 * size.y(), foot},
	             {0.5 * size.x(), 0.5 * size.y(), height_m});
	if (foot > 0) legs(sketch, "cupboard", Look::wood, place, size - PlanSize(0.06, 0.06), 0.04, foot);
	for (const double y : {-0.05, 0.05})
		sketch.box("knob", Look::metal, place, {0.5 * size.x() + 0.015, y, 0.5 * height_m}, {0.03, 0.015, 0.15});
	obstacle(sketch, "cupboard", place, size, height_m);
}

void buildSofa(Sketch& sketch, const Place& place, const PlanSize& size)
{
	sketch.box("sofa", Look::fabric, place, {0, 0, 0.25}, {size.x(), size.y(), 0.34});
	sketch.box("sofa", Look::fabric, place, {-0.5 * size.x() + 0.12, 0, 0.6}, {0.24, size.y(), 0.45}, 0, -0.1);
	for (const double y : {-0.5, 0.5})
		sketch.box("sofa", Look::fabric, place, {0, y * (size.y() - 0.18), 0.35}, {size.x(), 0.18, 0.5});
	obstacle(sketch, "sofa", place, size, 0.82);
}

void buildBed(Sketch& sketch, const Place& place, const PlanSize& size)
{
	sketch.box("bed", Look::wood, place, {0, 0, 0.22}, {size.x(), size.y(), 0.16});
	sketch.box("bed", Look::white, place, {0, 0, 0.42}, {size.x() - 0.06, size.y() - 0.04, 0.24});
	sketch.box("bed", Look::wood, place, {-0.5 * size.x() + 0.02, 0, 0.5}, {0.04, size.y(), 1.0});
	legs(sketch, "bed", Look::wood, place, size, 0.07, 0.14);
	obstacle(sketch, "bed", place, size, 1.0);
}

void buildPlant(Sketch& sketch, const Place& place, Dice& dice)
{
	const double pot_m = dice.between(0.12, 0.22), height = dice.between(0.8, 1.9);
	sketch.cylinder("pot", Look::cardboard, place, {0, 0, pot_m}, pot_m, 2 * pot_m);
	sketch.cylinder("stem", Look::wood, place, {0, 0, 0.5 * height}, 0.015, height);
	for (int i = 0; i < 14; ++i)
	{
		const double angle = dice.between(0, 6.28), off = dice.between(0.03, 0.12);
		sketch.box("foliage", Look::leaves, place.then({0, 0}, angle), {off, 0, dice.between(2 * pot_m + 0.1, height)},
		           {dice.between(0.12, 0.25), dice.between(0.04, 0.1), 0.01}, 0, dice.between(-0.9, 0.9));
	}
	obstacle(sketch, "plant", place, {0.6, 0.6}, height);
}

void buildLamp(Sketch& sketch, const Place& place, Dice& dice)
{
	const double height = dice.between(1.4, 1.8);
	sketch.cylinder("lamp", Look::metal, place, {0, 0, 0.015}, 0.14, 0.03);
	sketch.cylinder("lamp", Look::metal, place, {0, 0, 0.5 * height}, 0.0125, height);
	sketch.cylinder("lamp", Look::fabric, place, {0, 0, height}, 0.18, 0.28);
	obstacle(sketch, "lamp", place, {0.28, 0.28}, height);
}

void buildRadiator(Sketch& sketch, const Place& place, const PlanSize& size)
{
	const int fins = static_cast<int>(size.y() / 0.06);
	for (int i = 0; i < fins; ++i)
		sketch.box("radiator", Look::white, place, {0, (i + 0.5) * size.y() / fins - 0.5 * size.y(), 0.42},
		           {size.x(), 0.04, 0.56});
	for (const double z : {0.2, 0.64}) sketch.box("radiator", Look::white, place, {0, 0, z}, {0.03, size.y(), 0.03});
}

void buildToilet(Sketch& sketch, const Place& place)
{
	sketch.box("toilet", Look::white, place, {-0.25, 0, 0.6}, {0.16, 0.38, 0.4});
	sketch.cylinder("toilet", Look::white, place, {0.08, 0, 0.2}, 0.19, 0.4);
	sketch.box("toilet", Look::white, place, {-0.1, 0, 0.2}, {0.3, 0.25, 0.38});
}

void buildBasin(Sketch& sketch, const Place& place)
{
	sketch.box("basin", Look::white, place, {0, 0, 0.78}, {0.42, 0.55, 0.14});
	sketch.cylinder("basin", Look::white, place, {-0.1, 0, 0.36}, 0.08, 0.72);
	sketch.box("looking", Look::mirror, place, {-0.20, 0, 1.5}, {0.01, 0.5, 0.7});
}

void buildRack(Sketch& sketch, const Place& place, const PlanSize& size, double height_m, Dice& dice)
{
	const double bay = dice.between(1.8, 2.8), level = dice.between(1.2, 1.7);
	const int bays = std::max(1, static_cast<int>(size.y() / bay));
	const double wide = size.y() / bays;
	for (int i = 0; i <= bays; ++i)
		for (const double x : {-0.5, 0.5})
			sketch.box("upright", Look::metal, place,
			           {x * (size.x() - 0.08), -0.5 * size.y() + i * wide + (i == 0 ? 0.05 : -0.05), 0.5 * height_m},
			           {0.08, 0.10, height_m});
	for (double z = 0.0; z < height_m - 0.3; z += level)
	{
		if (z > 0)
			for (const double x : {-0.5, 0.5})
				sketch.box("beam", Look::metal, place, {x * (size.x() - 0.05), 0, z}, {0.05, size.y(), 0.11});
		for (int i = 0; i < bays; ++i)
			for (const double side : {-0.25, 0.25})
			{
				if (dice.chance(0.25)) continue;
				const double y = -0.5 * size.y() + (i + 0.5 + side) * wide, high = dice.between(0.4, level - 0.35);
				sketch.box("pallet", Look::wood, place, {0, y, z + 0.13}, {size.x(), 0.42 * wide, 0.14});
				sketch.box("goods", Look::cardboard, place, {0, y, z + 0.2 + 0.5 * high},
				           {size.x() * dice.between(0.8, 1), 0.40 * wide, high});
			}
	}
	obstacle(sketch, "rack", place, {size.x(), size.x()}, height_m);
}

void buildPallet(Sketch& sketch, const Place& place, Dice& dice)
{
	for (const double y : {-0.35, 0.0, 0.35}) sketch.box("pallet", Look::wood, place, {0, y, 0.05}, {1.2, 0.1, 0.1});
	sketch.box("pallet", Look::wood, place, {0, 0, 0.12}, {1.2, 0.8, 0.04});
	const double high = dice.between(0, 1.4);
	if (high > 0.2) sketch.box("goods", Look::cardboard, place, {0, 0, 0.14 + 0.5 * high}, {1.1, 0.75, high});
	obstacle(sketch, "pallet", place, {1.2, 0.8}, 0.14 + high);
}

void buildAlcove(Sketch& sketch, const Place& place, const PlanSize& size, double opening_m, double ceiling_m,
                 Dice& dice)
{
	const double half = 0.5 * size.y(), x = 0.5 * size.x(), shift = dice.between(-0.3, 0.3) * (size.y() - opening_m);
	const double top = std::min(dice.between(1.9, 2.2), ceiling_m - 0.1);
	sketch.block("pilaster", Look::wall, place, {-x, -half, 0}, {x, shift - 0.5 * opening_m, ceiling_m});
	sketch.block("pilaster", Look::wall, place, {-x, shift + 0.5 * opening_m, 0}, {x, half, ceiling_m});
	sketch.block("pilaster", Look::wall, place, {-x, shift - 0.5 * opening_m, top},
	             {x, shift + 0.5 * opening_m, ceiling_m});
	if (dice.chance(0.3))
		for (double z = 0.4; z < top - 0.2; z += 0.35)
			sketch.block("board", Look::wood, place, {-x, shift - 0.5 * opening_m, z},
			             {x - 0.05, shift + 0.5 * opening_m, z + 0.02});
}

void buildPerson(Sketch& sketch, const Place& place, const std::string& name, Dice& dice)
{
	const double height = dice.between(1.65, 1.9), wide = dice.between(0.9, 1.1);
	for (const double side : {-1.0, 1.0})
	{
		sketch.cylinder(name, Look::fabric, place, {0, side * 0.10 * wide, 0.25 * height}, 0.07 * wide, 0.46 * height);
		sketch.box(name, Look::metal, place, {0.05, side * 0.10 * wide, 0.04}, {0.26, 0.09, 0.08});
		sketch.capsule(name, Look::fabric, place, {0, side * 0.21 * wide, 0.63 * height}, 0.045, 0.30 * height);
	}
	sketch.capsule(name, Look::fabric, place, {0, 0, 0.64 * height}, 0.15 * wide, 0.20 * height);
	sketch.box(name, Look::fabric, place, {0, 0, 0.76 * height}, {0.18, 0.40 * wide, 0.12 * height});
	sketch.cylinder(name, Look::skin, place, {0, 0, 0.85 * height}, 0.05, 0.06 * height);
	sketch.sphere(name, Look::skin, place, {0, 0, 0.93 * height}, 0.07 * height / 1.0);
	sketch.obstacles.push_back({"person", place.origin, 0.25, height});
}
}  // namespace explore::test

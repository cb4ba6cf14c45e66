#include "scene_pieces.h"

#include <explore/simulation/shapes.h>

#include <algorithm>
#include <cmath>

namespace explore::simulation
{
namespace
{
const Eigen::Vector3f kSteel(0.5F, 0.52F, 0.55F), kCloth(0.35F, 0.35F, 0.45F), kLeaves(0.2F, 0.5F, 0.22F);

Eigen::Isometry3d moved(double x, double y, double z, double turn_rad = 0)
{
	return Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ());
}
}  // namespace

void PieceMaker::mesh(const TriangleMesh& mesh, const Eigen::Isometry3d& piece_from_mesh, std::size_t material)
{
	m_sketch.place(m_body, mesh, m_frame * piece_from_mesh, material);
}

void PieceMaker::box(const Span& x, const Span& y, const Span& z, std::size_t material)
{
	mesh(boxMesh({x.length(), y.length(), z.length()}), moved(x.middle(), y.middle(), z.middle()), material);
}

void PieceMaker::pole(const Eigen::Vector2d& at, const Span& z, double radius_m, std::size_t material, int sides)
{
	mesh(cylinderMesh(radius_m, z.length(), sides), moved(at.x(), at.y(), z.middle()), material);
}

void PieceMaker::ball(const Eigen::Vector3d& center, double radius_m, std::size_t material)
{
	mesh(sphereMesh(radius_m, 6), moved(center.x(), center.y(), center.z()), material);
}

void PieceMaker::spoke(double angle_rad, double length_m, const Span& z, double width_m, std::size_t material)
{
	mesh(boxMesh({length_m, width_m, z.length()}),
	     moved(0.5 * length_m * std::cos(angle_rad), 0.5 * length_m * std::sin(angle_rad), z.middle(), angle_rad),
	     material);
}

void PieceMaker::legs(double thickness_m, double height_m, std::size_t material)
{
	const double x_m = 0.5 * (m_size.x() - thickness_m), y_m = 0.5 * (m_size.y() - thickness_m);
	for (const double side_x : {-x_m, x_m})
		for (const double side_y : {-y_m, y_m})
			box(around(side_x, thickness_m), around(side_y, thickness_m), {0, height_m}, material);
}

void makeSwivelChair(PieceMaker& make)
{
	const std::size_t steel = make.material("steel", kSteel), cloth = make.material("cloth", kCloth);
	const double half_m = 0.5 * make.size().x(), seat_m = std::min(0.48, 0.5 * make.top());
	const double turn_rad = make.random().uniform(0, 1.2);
	for (int leg = 0; leg < 5; ++leg)
		make.spoke(turn_rad + 2 * std::numbers::pi * leg / 5, half_m, {0.04, 0.09}, 0.045, steel);
	make.pole({0, 0}, {0.05, seat_m - 0.06}, 0.03, steel);
	make.box(around(0, 0.8 * make.size().x()), around(0, 0.8 * make.size().y()), {seat_m - 0.07, seat_m}, cloth);
	make.box(around(0, 0.06), around(0.38 * make.size().y(), 0.04), {seat_m - 0.05, seat_m + 0.2}, steel);
	make.box(around(0, 0.7 * make.size().x()), around(0.4 * make.size().y(), 0.06), {seat_m + 0.15, make.top()}, cloth);
	if (!make.random().chance(0.6)) return;
	for (const double side : {-1.0, 1.0})
	{
		const Span x = around(side * 0.44 * make.size().x(), 0.05);
		make.box(x, around(0.05, 0.04), {seat_m - 0.05, seat_m + 0.22}, steel);
		make.box(x, around(0, 0.26), {seat_m + 0.2, seat_m + 0.24}, cloth);
	}
}

void makeFourLeggedChair(PieceMaker& make)
{
	const std::size_t wood = make.paint();
	const double seat_m = 0.5 * make.top(), leg_m = 0.035;
	make.legs(leg_m, seat_m, wood);
	make.box(make.x(), make.y(), {seat_m - 0.035, seat_m}, wood);
	const Span back{make.y().high - leg_m, make.y().high};
	for (const double x_m : {make.x().low + 0.5 * leg_m, make.x().high - 0.5 * leg_m})
		make.box(around(x_m, leg_m), back, {seat_m, make.top()}, wood);
	make.box(make.x(), back, {make.top() - 0.16, make.top() - 0.02}, wood);
	make.box(make.x(), back, {make.top() - 0.32, make.top() - 0.24}, wood);
}

void makeArmchair(PieceMaker& make)
{
	const std::size_t cloth = make.paint();
	const double arm_m = 0.16, back_m = 0.2, seat_m = 0.45 * make.top();
	make.box(make.x(), make.y(), {0.06, seat_m - 0.12}, cloth);
	make.box({make.x().low + arm_m, make.x().high - arm_m}, {make.y().low, make.y().high - back_m},
	         {seat_m - 0.12, seat_m}, make.material("cloth", kCloth));
	make.box(make.x(), {make.y().high - back_m, make.y().high}, {0.06, make.top()}, cloth);
	for (const Span& arm : {Span{make.x().low, make.x().low + arm_m}, Span{make.x().high - arm_m, make.x().high}})
		make.box(arm, make.y(), {0.06, seat_m + 0.18}, cloth);
	make.legs(0.05, 0.07, make.material("steel", kSteel));
}

void makeStool(PieceMaker& make)
{
	const std::size_t wood = make.paint();
	const double radius_m = 0.5 * make.size().x();
	make.pole({0, 0}, {make.top() - 0.045, make.top()}, radius_m, wood, 16);
	const int legs = make.random().integer(3, 4);
	for (int leg = 0; leg < legs; ++leg)
	{
		const double angle_rad = 2 * std::numbers::pi * leg / legs;
		make.pole({0.8 * radius_m * std::cos(angle_rad), 0.8 * radius_m * std::sin(angle_rad)}, {0, make.top() - 0.04},
		          0.018, wood, 8);
	}
}

void makeTable(PieceMaker& make)
{
	const std::size_t wood = make.paint();
	make.box(make.x(), make.y(), {make.top() - 0.03, make.top()}, wood);
	make.legs(0.05, make.top() - 0.03, make.random().chance(0.5) ? wood : make.material("steel", kSteel));
}

void makeDesk(PieceMaker& make)
{
	const std::size_t wood = make.paint(), steel = make.material("steel", kSteel);
	make.box(make.x(), make.y(), {make.top() - 0.03, make.top()}, wood);
	make.box({make.x().low, make.x().low + 0.4}, make.y(), {0.02, make.top() - 0.03}, wood);
	make.box({make.x().high - 0.03, make.x().high}, make.y(), {0, make.top() - 0.03}, wood);
	make.box(make.x(), {make.y().high - 0.02, make.y().high}, {0.35, make.top() - 0.03}, wood);
	// A screen on its foot.
	const double x_m = make.random().uniform(-0.25, 0.25);
	make.box(around(x_m, 0.2), around(0.05, 0.16), {make.top(), make.top() + 0.015}, steel);
	make.box(around(x_m, 0.05), around(0.08, 0.03), {make.top(), make.top() + 0.2}, steel);
	make.box(around(x_m, 0.5), around(0.05, 0.03), {make.top() + 0.12, make.top() + 0.43}, steel);
}

void makeShelf(PieceMaker& make)
{
	const std::size_t wood = make.paint();
	const double board_m = 0.025;
	for (const Span& side : {Span{make.x().low, make.x().low + board_m}, Span{make.x().high - board_m, make.x().high}})
		make.box(side, make.y(), {0, make.top()}, wood);
	if (make.random().chance(0.6)) make.box(make.x(), {make.y().high - 0.012, make.y().high}, {0, make.top()}, wood);
	const int boards = std::max(2, static_cast<int>(make.top() / 0.36));
	for (int i = 0; i <= boards; ++i)
	{
		const double z_m = 0.05 + (make.top() - 0.05 - board_m) * i / boards;
		make.box(make.x(), make.y(), {z_m, z_m + board_m}, wood);
		if (i == boards) break;
		// Books or boxes on part of the board.
		double from_m = make.x().low + board_m;
		while (from_m < make.x().high - 0.15)
		{
			const double to_m = std::min(from_m + make.random().uniform(0.08, 0.3), make.x().high - board_m);
			if (make.random().chance(0.7))
			{
				const Span y{make.y().low + make.random().uniform(0.01, 0.1), make.y().high - 0.02};
				const Span z{z_m + board_m, z_m + make.random().uniform(0.12, 0.3)};
				make.box({from_m, to_m}, y, z, make.paint());
			}
			from_m = to_m;
		}
	}
}

void makeCabinet(PieceMaker& make)
{
	const std::size_t body = make.paint(), front = make.paint();
	make.box(make.x(), {make.y().low + 0.02, make.y().high}, {0, make.top()}, body);
	const int doors = make.size().x() > 0.6 ? 2 : 1;
	for (int i = 0; i < doors; ++i)
	{
		const double from_m = make.x().low + make.size().x() * i / doors;
		const double to_m = make.x().low + make.size().x() * (i + 1) / doors;
		make.box({from_m + 0.004, to_m - 0.004}, {make.y().low, make.y().low + 0.02}, {0.06, make.top() - 0.005},
		         front);
	}
}

void makeBox(PieceMaker& make)
{
	make.box(make.x(), make.y(), {0, make.top()}, make.paint());
}

void makeBin(PieceMaker& make)
{
	make.pole({0, 0}, {0, make.top()}, 0.5 * make.size().x(), make.paint(), 16);
}

void makePlant(PieceMaker& make)
{
	const std::size_t leaves = make.material("leaves", kLeaves);
	const double radius_m = 0.5 * make.size().x(), pot_m = 0.28 * make.top();
	make.pole({0, 0}, {0, pot_m}, 0.6 * radius_m, make.paint(), 12);
	make.pole({0, 0}, {pot_m, 0.7 * make.top()}, 0.015, leaves, 6);
	for (int i = 0; i < 7; ++i)
	{
		const double ball_m = radius_m * make.random().uniform(0.35, 0.55);
		const double angle_rad = make.random().uniform(0, 2 * std::numbers::pi);
		const double out_m = make.random().uniform(0, radius_m - ball_m);
		make.ball({out_m * std::cos(angle_rad), out_m * std::sin(angle_rad),
		           make.random().uniform(pot_m + 0.5 * ball_m, make.top() - ball_m)},
		          ball_m, leaves);
	}
}

void makeLamp(PieceMaker& make)
{
	const std::size_t steel = make.material("steel", kSteel);
	make.pole({0, 0}, {0, 0.03}, 0.5 * make.size().x(), steel);
	make.pole({0, 0}, {0.03, make.top()}, 0.015, steel, 8);
	make.pole({0, 0}, {make.top() - 0.25, make.top()}, 0.45 * make.size().x(), make.paint());
}

void makePedestrian(PieceMaker& make)
{
	// Faces its front, which is −y.
	make.mesh(personMesh(make.top(), 0.5 * make.size().x()), moved(0, 0, 0, -std::numbers::pi / 2),
	          make.material("clothes", kCloth));
}
}  // namespace explore::simulation

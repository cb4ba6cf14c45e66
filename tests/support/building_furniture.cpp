#include "support/building_furniture.h"

#include "support/building_pieces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;
using Build = std::function<void(const Place&)>;

class RoomFurnisher
{
public:
	RoomFurnisher(Sketch& sketch, const Plan& plan, Room& room, Dice& dice)
	    : m_sketch(sketch), m_plan(plan), m_room(room), m_dice(dice)
	{
	}

	void run()
	{
		corridorsOfRoom();
		switch (m_room.use)
		{
			case Use::living:
				living();
				break;
			case Use::bedroom:
				bedroom();
				break;
			case Use::guest:
				bedroom();
				break;
			case Use::kitchen:
				kitchen();
				break;
			case Use::bath:
				bath();
				break;
			case Use::office:
				office();
				break;
			case Use::meeting:
				meeting();
				break;
			case Use::classroom:
				classroom();
				break;
			case Use::corridor:
				corridor();
				break;
			case Use::hall:
				hall();
				break;
			case Use::storage:
				storage();
				break;
			case Use::warehouse:
				warehouse();
				break;
			default:
				break;
		}
	}

private:
	/** Facing walls at most 4 m apart are what the truth calls a corridor, where they are long enough. */
	void corridorsOfRoom()
	{
		const Vector2d size = m_room.inside.sizes(), middle = m_room.inside.center();
		for (const int axis : {0, 1})
		{
			const double width = size[1 - axis];
			if (width < 0.8 || width > 4.0) continue;
			PlannedCorridor corridor{middle, middle, width};
			corridor.from[axis] = m_room.inside.min()[axis];
			corridor.to[axis] = m_room.inside.max()[axis];
			m_sketch.corridors.push_back(corridor);
		}
	}

	bool take(const Area& area, double apart_m = 0)
	{
		Area wider = area;
		wider.min() -= Vector2d(apart_m, apart_m);
		wider.max() += Vector2d(apart_m, apart_m);
		if (!m_room.inside.contains(area)) return false;
		for (const Area& taken : m_room.taken)
			if (taken.intersects(wider)) return false;
		m_room.taken.push_back(area);
		return true;
	}

	/** With its back (−x) to a wall. */
	bool atWall(const PlanSize& size, const Build& build, double apart_m = 0.02, double gap_m = 0.01)
	{
		for (int trial = 0; trial < 12; ++trial)
		{
			const int side = m_dice.whole(0, 3);
			const int axis = side < 2 ? 0 : 1;  // across the wall
			const double wall = m_room.inside.sizes()[1 - axis];
			if (wall < size.y() + 0.1) continue;
			const double off = m_dice.between(0.5 * size.y() + 0.02, wall - 0.5 * size.y() - 0.02);
			const double deep = 0.5 * size.x() + gap_m;
			Vector2d at;
			at[1 - axis] = m_room.inside.min()[1 - axis] + off;
			at[axis] = side % 2 == 0 ? m_room.inside.min()[axis] + deep : m_room.inside.max()[axis] - deep;
			const double yaw = (axis == 0 ? 0 : std::numbers::pi / 2) + (side % 2 == 0 ? 0 : std::numbers::pi);
			Vector2d half;
			half[axis] = 0.5 * size.x();
			half[1 - axis] = 0.5 * size.y();
			if (!take(Area(Vector2d(at - half), Vector2d(at + half)), apart_m)) continue;
			build({at, yaw});
			return true;
		}
		return false;
	}

	/** Somewhere in the room, turned as it likes. */
	bool free(const PlanSize& size, const Build& build, double from_wall_m = 0.5, bool turned = true)
	{
		for (int trial = 0; trial < 12; ++trial)
		{
			const double yaw =
			    turned ? m_dice.between(0, 2 * std::numbers::pi) : m_dice.whole(0, 3) * std::numbers::pi / 2;
			const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
			const Vector2d half(0.5 * (c * size.x() + s * size.y()), 0.5 * (s * size.x() + c * size.y()));
			const Vector2d low = m_room.inside.min() + half + Vector2d(from_wall_m, from_wall_m);
			const Vector2d high = m_room.inside.max() - half - Vector2d(from_wall_m, from_wall_m);
			if ((high - low).minCoeff() < 0) continue;
			const Vector2d at(m_dice.between(low.x(), high.x()), m_dice.between(low.y(), high.y()));
			if (!take(Area(Vector2d(at - half), Vector2d(at + half)), 0.05)) continue;
			build({at, yaw});
			return true;
		}
		return false;
	}

	void cupboards(int count, double most_high_m)
	{
		for (int i = 0; i < count; ++i)
		{
			const PlanSize size(m_dice.between(0.35, 0.6), m_dice.between(0.5, 1.6));
			const double height = m_dice.between(0.7, std::min(most_high_m, m_plan.height_m - 0.1));
			const bool open = m_dice.chance(0.4);
			atWall(size,
			       [&](const Place& place)
			       {
				       if (open)
					       buildShelf(m_sketch, place, size, height, m_dice);
				       else
					       buildCupboard(m_sketch, place, size, height, m_dice);
			       });
		}
	}

	void chairs(int count)
	{
		for (int i = 0; i < count; ++i)
			free(
			    {0.5, 0.5}, [&](const Place& place) { buildChair(m_sketch, place, m_dice); }, 0.1);
	}

	/** A table with chairs around it. */
	void tableGroup(const PlanSize& size, bool turned)
	{
		const PlanSize all(size.x() + 1.2, size.y() + 0.2);
		free(
		    all,
		    [&](const Place& place)
		    {
			    buildTable(m_sketch, place, size, m_dice.between(0.71, 0.77), m_dice);
			    const int a_side = std::max(1, static_cast<int>(size.y() / 0.65));
			    for (const double side : {-1.0, 1.0})
				    for (int i = 0; i < a_side; ++i)
					    if (m_dice.chance(0.85))
						    buildChair(m_sketch,
						               place.then({side * (0.5 * size.x() + m_dice.between(0.05, 0.25)),
						                           (i + 0.5) * size.y() / a_side - 0.5 * size.y()},
						                          (side > 0 ? std::numbers::pi : 0) + m_dice.between(-0.3, 0.3)),
						               m_dice);
		    },
		    0.3, turned);
	}

	void decorate()
	{
		for (int i = m_dice.whole(0, 3); i > 0; --i)
		{
			const PlanSize size(0.03, m_dice.between(0.4, 1.4));
			const double middle = m_dice.between(1.4, 1.7), high = m_dice.between(0.3, 0.9);
			const Look look = m_dice.chance(0.2) ? Look::black : Look::fabric;
			atWall(size,
			       [&](const Place& place) {
				       m_sketch.box("picture", look, place, {0, 0, middle}, {size.x(), size.y(), high});
			       });
		}
		if (m_dice.chance(0.4)) atWall({0.5, 0.5}, [&](const Place& place) { buildPlant(m_sketch, place, m_dice); });
		if (m_dice.chance(0.35))
			atWall({0.1, m_dice.between(0.6, 1.8)},
			       [&](const Place& place) {
				       buildRadiator(m_sketch, place, {0.09, 1.0});
			       });
		if (m_dice.chance(0.25))
			atWall({0.3, 0.3},
			       [&](const Place& place) {
				       m_sketch.cylinder("bin", Look::metal, place, {0, 0, 0.2}, 0.13, 0.4);
			       });
		if (m_dice.chance(0.2)) people(1);
		if (m_dice.chance(0.2))
		{
			const PlanSize size(m_dice.between(0.35, 0.6), m_dice.between(1.5, 2.4));
			atWall(size,
			       [&](const Place& place)
			       {
				       buildAlcove(m_sketch, place, size, m_dice.between(0.75, 1.1),
				                   m_plan.height_m > 4 ? 2.5 : m_plan.height_m, m_dice);
			       });
		}
	}

	void curtains(int count)
	{
		for (int i = 0; i < count; ++i)
		{
			const double wide = m_dice.between(0.3, 1.2), top = std::min(2.3, m_plan.height_m - 0.1);
			atWall({0.12, wide},
			       [&](const Place& place)
			       {
				       for (double y = -0.5 * wide; y < 0.5 * wide; y += 0.08)
					       m_sketch.box("drape", Look::fabric, place, {0, y, 0.5 * top + 0.02},
					                    {0.012, 0.1, top - 0.04}, std::fmod(std::abs(y), 0.16) < 0.08 ? 0.5 : -0.5);
			       });
		}
	}

	void people(int count)
	{
		for (int i = 0; i < count; ++i)
			free(
			    {0.5, 0.5}, [&](const Place& place) { buildPerson(m_sketch, place, "person", m_dice); }, 0.1);
	}

	void columns(int count)
	{
		const double side = m_dice.between(0.25, 0.5);
		const bool round = m_dice.chance(0.5);
		const double height = m_plan.height_m;
		for (int i = 0; i < count; ++i)
			free(
			    {side, side},
			    [&](const Place& place)
			    {
				    if (round)
					    m_sketch.cylinder("column", Look::wall, place, {0, 0, 0.5 * height}, 0.5 * side, height);
				    else
					    m_sketch.box("column", Look::wall, {place.origin, 0}, {0, 0, 0.5 * height},
					                 {side, side, height});
			    },
			    0.35, false);
	}

	void carpet()
	{
		const Vector2d size = 0.5 * m_room.inside.sizes();
		if (!m_dice.chance(0.4) || size.minCoeff() < 0.8) return;
		m_sketch.box("carpet", Look::fabric, {m_room.inside.center(), 0}, {0, 0, 0.005}, {size.x(), size.y(), 0.01});
	}

	void living()
	{
		carpet();
		const double wide = m_dice.between(1.5, 2.3);
		atWall({0.9, wide}, [&](const Place& place) { buildSofa(m_sketch, place, {0.88, wide}); });
		tableGroup({0.9, m_dice.between(1.2, 2.0)}, m_dice.chance(0.3));
		free({0.6, 1.0}, [&](const Place& place) { buildTable(m_sketch, place, {0.6, 1.0}, 0.42, m_dice); });
		if (m_dice.chance(0.6)) atWall({0.4, 0.4}, [&](const Place& place) { buildLamp(m_sketch, place, m_dice); });
		cupboards(m_dice.whole(1, 3), 2.2);
		curtains(1);
		decorate();
	}
	void bedroom()
	{
		const double wide = m_dice.between(0.95, 1.85);
		atWall({2.05, wide}, [&](const Place& place) { buildBed(m_sketch, place, {2.04, wide}); });
		cupboards(m_dice.whole(1, 2), 2.3);
		if (m_dice.chance(0.5)) desk();
		curtains(m_dice.whole(0, 1));
		decorate();
	}
	void kitchen()
	{
		for (int i = 0; i < 2; ++i)
		{
			const double wide = m_dice.between(1.2, 2.6);
			atWall({0.6, wide},
			       [&](const Place& place)
			       {
				       m_sketch.box("kitchen", Look::white, place, {0, 0, 0.48}, {0.58, wide, 0.78});
				       m_sketch.box("kitchen", Look::white, place, {-0.03, 0, 0.05}, {0.5, wide, 0.10});
				       m_sketch.box("worktop", Look::wood, place, {0, 0, 0.89}, {0.6, wide, 0.04});
				       m_sketch.box("kitchen", Look::white, place, {-0.12, 0, 1.75}, {0.34, wide, 0.7});
			       });
		}
		atWall({0.62, 0.6}, [&](const Place& place) { buildCupboard(m_sketch, place, {0.6, 0.6}, 1.8, m_dice); });
		tableGroup({0.8, 1.2}, false);
		decorate();
	}
	void bath()
	{
		atWall({0.66, 0.5}, [&](const Place& place) { buildToilet(m_sketch, place); });
		atWall({0.46, 0.6}, [&](const Place& place) { buildBasin(m_sketch, place); });
		if (m_room.inside.volume() > 6)
			atWall({0.75, 1.7},
			       [&](const Place& place) {
				       m_sketch.box("tub", Look::white, place, {0, 0, 0.28}, {0.74, 1.68, 0.56});
			       });
	}
	void desk()
	{
		const PlanSize size(0.8, m_dice.between(1.2, 1.8));
		atWall(
		    {size.x() + 0.6, size.y()},
		    [&](const Place& place)
		    {
			    buildTable(m_sketch, place.then({-0.3, 0}), size, m_dice.between(0.70, 0.76), m_dice);
			    buildSwivelChair(m_sketch, place.then({0.35, m_dice.between(-0.2, 0.2)}, m_dice.between(2, 4)), m_dice);
		    });
	}
	void office()
	{
		for (int i = std::max(1, static_cast<int>(m_room.inside.volume() / 9)); i > 0; --i) desk();
		cupboards(m_dice.whole(1, 3), 2.1);
		decorate();
	}
	void meeting()
	{
		tableGroup({1.1, std::max(1.4, 0.45 * m_room.inside.sizes().minCoeff())}, m_dice.chance(0.3));
		cupboards(1, 1.2);
		decorate();
	}
	void classroom()
	{
		const Area inside = m_room.inside;
		for (double x = inside.min().x() + 1.6; x < inside.max().x() - 1.2; x += 1.9)
			for (double y = inside.min().y() + 1.6; y < inside.max().y() - 1.2; y += 1.6)
			{
				if (m_dice.chance(0.15)) continue;
				const Place place{{x + m_dice.between(-0.1, 0.1), y}, m_dice.between(-0.1, 0.1)};
				if (!take(Area(Vector2d(place.origin - Vector2d(0.7, 0.72)),
				               Vector2d(place.origin + Vector2d(0.7, 0.72)))))
					continue;
				buildTable(m_sketch, place, {0.55, 1.3}, 0.74, m_dice);
				for (const double side : {-0.33, 0.33})
					buildChair(m_sketch, place.then({0.45, side}, std::numbers::pi), m_dice);
			}
		atWall({0.06, 3.0},
		       [&](const Place& place) {
			       m_sketch.box("writing_board", Look::leaves, place, {0, 0, 1.5}, {0.05, 3.0, 1.2});
		       });
		cupboards(m_dice.whole(1, 3), 2.0);
		decorate();
	}
	void corridor()
	{
		const double width = m_room.inside.sizes().minCoeff(), spare = width - 1.3;
		if (spare > 0.25)
			for (int i = m_dice.whole(0, 5); i > 0; --i)
			{
				const PlanSize size(std::min(spare, m_dice.between(0.25, 0.5)), m_dice.between(0.8, 2.4));
				const double height = m_dice.chance(0.5) ? m_dice.between(1.6, 1.95) : 0.45;
				atWall(size, [&](const Place& place) { buildCupboard(m_sketch, place, size, height, m_dice); });
			}
		decorate();
		if (m_dice.chance(0.4)) people(1);
	}
	void hall()
	{
		columns(m_dice.whole(0, 4));
		for (int i = m_dice.whole(0, 2); i > 0; --i) tableGroup({0.8, m_dice.between(0.8, 1.6)}, true);
		for (int i = m_dice.whole(0, 2); i > 0; --i)
			atWall({0.85, 1.6}, [&](const Place& place) { buildSofa(m_sketch, place, {0.84, 1.58}); });
		free({0.7, 2.2},
		     [&](const Place& place) {
			     m_sketch.box("desk", Look::wood, place, {0, 0, 0.55}, {0.7, 2.2, 1.1});
		     });
		chairs(m_dice.whole(0, 4));
		people(m_dice.whole(0, 3));
		cupboards(m_dice.whole(0, 2), 2.0);
		decorate();
	}
	void storage()
	{
		cupboards(m_dice.whole(1, 4), 2.2);
		for (int i = m_dice.whole(0, 3); i > 0; --i)
			atWall({0.6, 0.6},
			       [&](const Place& place) {
				       m_sketch.box("carton", Look::cardboard, place, {0, 0, 0.25}, {0.5, 0.45, 0.5});
			       });
	}
	void warehouse()
	{
		const double deep = m_dice.between(0.9, 1.2), aisle = m_dice.between(2.4, 3.6),
		             height = m_dice.between(2.5, 4.5);
		for (double y = m_room.inside.min().y() + 2.5; y + deep < m_room.inside.max().y() - 2; y += deep + aisle)
			for (double x = m_room.inside.min().x() + 2.5; x + 4 < m_room.inside.max().x() - 2.5;)
			{
				const double length = m_dice.between(4, 8), to = std::min(x + length, m_room.inside.max().x() - 2.5);
				const Area area(Vector2d(x, y), Vector2d(to, y + deep));
				if (to - x > 2 && m_dice.chance(0.8) && take(area))
					buildRack(m_sketch, {area.center(), std::numbers::pi / 2}, {deep, to - x}, height, m_dice);
				x = to + m_dice.between(1.5, 3);
			}
		columns(m_dice.whole(0, 4));
		for (int i = m_dice.whole(2, 8); i > 0; --i)
			free(
			    {1.3, 0.9}, [&](const Place& place) { buildPallet(m_sketch, place, m_dice); }, 0.2, m_dice.chance(0.3));
		people(m_dice.whole(1, 3));
	}

	Sketch& m_sketch;
	const Plan& m_plan;
	Room& m_room;
	Dice& m_dice;
};
}  // namespace

void furnish(Sketch& sketch, Plan& plan, Room& room, Dice& dice)
{
	RoomFurnisher(sketch, plan, room, dice).run();
}
}  // namespace explore::test

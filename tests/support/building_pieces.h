// Single pieces of furniture and people, each around the origin of its place: x to its front, y to its left.
#pragma once

#include "support/building_sketch.h"

#include <string>

namespace explore::test
{
using PlanSize = Eigen::Vector2d;  ///< depth (x) and width (y) of a piece [m]

void buildTable(Sketch& sketch, const Place& place, const PlanSize& size, double height_m, Dice& dice);
void buildChair(Sketch& sketch, const Place& place, Dice& dice);
void buildSwivelChair(Sketch& sketch, const Place& place, Dice& dice);
void buildShelf(Sketch& sketch, const Place& place, const PlanSize& size, double height_m, Dice& dice);
void buildCupboard(Sketch& sketch, const Place& place, const PlanSize& size, double height_m, Dice& dice);
void buildSofa(Sketch& sketch, const Place& place, const PlanSize& size);
void buildBed(Sketch& sketch, const Place& place, const PlanSize& size);
void buildPlant(Sketch& sketch, const Place& place, Dice& dice);
void buildLamp(Sketch& sketch, const Place& place, Dice& dice);
void buildRadiator(Sketch& sketch, const Place& place, const PlanSize& size);
void buildToilet(Sketch& sketch, const Place& place);
void buildBasin(Sketch& sketch, const Place& place);
/** A storage rack with pallets, goods and gaps. */
void buildRack(Sketch& sketch, const Place& place, const PlanSize& size, double height_m, Dice& dice);
void buildPallet(Sketch& sketch, const Place& place, Dice& dice);
/** Two pilasters and a header: an alcove of a door's size before the wall. */
void buildAlcove(Sketch& sketch, const Place& place, const PlanSize& size, double opening_m, double ceiling_m,
                 Dice& dice);
/** Somebody who stands there. */
void buildPerson(Sketch& sketch, const Place& place, const std::string& name, Dice& dice);
}  // namespace explore::test

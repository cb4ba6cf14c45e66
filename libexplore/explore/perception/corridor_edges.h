// Where the wall at a corridor's side ends at a true edge, to the pixel.
#pragma once

#include <explore/perception/corridor_walls.h>

#include <optional>

namespace explore
{
/** A vertical edge of a corridor's side wall: wall before it, nothing of it behind. */
struct SideEdge
{
	double along_m = 0;                  ///< along the corridor, 0 = the camera
	int rows = 0;                        ///< thinned rows of the image that show it
	int rows_behind = 0;                 ///< of these: something further away is seen next to it; else no return
	double lowest_m = 0, highest_m = 0;  ///< heights above the floor in which they do
};

enum class Side
{
	left,
	right
};

/** What makes an edge. */
struct SideEdgeConfig
{
	int min_rows = 6;           ///< thinned rows that show it with something behind it
	int min_sharp_rows = 24;    ///< the same where nothing behind it returns: noise frays a wall's far end
	double min_height_m = 0.4;  ///< between its lowest and highest row
	double max_along_m = 5.5;
	double apart_m = 0.1;       ///< rows agree within this and two pixels
	int min_floor_samples = 8;  ///< of the floor behind the plane, where nothing else returns
};
/** Field list of the above; without a section of its own. */
void describe(FieldVisitor& fields, SideEdgeConfig& config);

/** The furthest edge of that side. From each sample of the wall that has none beside it the row is followed pixel by
 *  pixel to the last one on the wall; the edge is the median of the rows that agree. */
std::optional<SideEdge> furthestEdge(Side side, const FacingWalls& pair, const LevelView& view,
                                     const PlanPoints& points, const TurnedPoints& turned, const SideEdgeConfig& config,
                                     const UprightWallConfig& walls);

/** Whether the wall ends there rather than fades: something or `floor_samples` of floor are seen behind its plane, or
 *  else the edge is too sharp to be noise. */
bool isTrueEdge(const SideEdge& edge, int floor_samples, const SideEdgeConfig& config);
}  // namespace explore

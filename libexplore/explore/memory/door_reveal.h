// The faces of the wall inside an opening: a wall has a thickness, a mirror on it has none.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/memory/door_place.h>

#include <functional>

namespace explore
{
/** Rows of pixels across jambs that turn their inner face to the camera, in which that face covers some pixels. */
struct RevealRows
{
	int rows = 0;
	/** Sum over the rows of how far behind the wall's face the last surface ends, before the room behind [m]. */
	double depth_m = 0;

	[[nodiscard]] double meanDepth_m() const { return rows > 0 ? depth_m / rows : 0.0; }
	RevealRows& operator+=(const RevealRows& other)
	{
		rows += other.rows;
		depth_m += other.depth_m;
		return *this;
	}
};

using RevealQuery = std::function<RevealRows(const DoorPlace&)>;

/** What `frame` shows of the inner faces of both jambs of the opening at `place`; nothing without an image. */
RevealRows revealOf(const DepthFrame& frame, const DoorPlace& place);
/** revealOf() in `frame`, which must outlive the result. */
RevealQuery revealQuery(const DepthFrame& frame);
}  // namespace explore

// The faces of the wall inside an opening: a wall has a thickness, a mirror on it has none.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/memory/door_place.h>

#include <functional>

namespace explore
{
/** Rows of pixels across jambs that turn their inner face to the camera, in which that face would cover some pixels. */
struct RevealRows
{
	int flat = 0;   ///< the wall ends where its outer face does
	int thick = 0;  ///< it goes on as far as a thin wall is thick, and ends there

	/** Of the rows that tell, 0–1; 0 without any. */
	[[nodiscard]] double flatShare() const { return flat > 0 ? static_cast<double>(flat) / (flat + thick) : 0.0; }
	RevealRows& operator+=(const RevealRows& other)
	{
		flat += other.flat;
		thick += other.thick;
		return *this;
	}
};

using RevealQuery = std::function<RevealRows(const DoorPlace&)>;

/** What `frame` shows of the inner faces of both jambs of the opening at `place`; nothing without an image. */
RevealRows revealOf(const DepthFrame& frame, const DoorPlace& place);
/** revealOf() in `frame`, which must outlive the result. */
RevealQuery revealQuery(const DepthFrame& frame);
}  // namespace explore

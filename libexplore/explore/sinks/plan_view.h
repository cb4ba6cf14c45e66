// The right half of a frame picture: the same frame seen from above, robot at the bottom, ahead is up.
#pragma once

#include <explore/sinks/picture_style.h>

namespace explore
{
/** Fills `area` of the canvas. */
void drawPlanView(Canvas& canvas, const CanvasArea& area, const DepthFrame& frame, const StepResult& result,
                  const PictureConfig& config, const PictureNotes& notes = {});
}  // namespace explore

// The left half of a frame picture: the depth image with everything that was found drawn into it.
#pragma once

#include <explore/sinks/picture_style.h>

namespace explore
{
/** Fills `area` of the canvas; an unorganised cloud has no image and gets a note instead. */
void drawCameraView(Canvas& canvas, const CanvasArea& area, const DepthFrame& frame, const StepResult& result,
                    const PictureConfig& config, const PictureNotes& notes = {});
}  // namespace explore

// explore-eval gallery: a page with a picture of each log's first scene.
#pragma once

#include <explore-eval/options.h>

namespace explore::app
{
/** Writes DIR/scene-pictures.md and DIR/images/scenes/. Returns 0. Throws the errors of core/errors.h; InputError also
 *  for a log without truth. */
int makeGallery(const EvalOptions& options);
}  // namespace explore::app

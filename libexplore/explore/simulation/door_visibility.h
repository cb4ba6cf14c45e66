// How much of a labelled opening a camera sees.
#pragma once

#include <explore/core/truth.h>
#include <explore/simulation/truth_view.h>

namespace explore::simulation
{
/** Both jambs of a visible door are at most this far from the camera, on the floor plan. */
inline constexpr double kVisibleRange_m = 5.0;

/** Fills in the normal, shares, lintel and visibility of `door`; no value for an opening wholly behind the camera.
 *
 *  - Rays go to 12 × 20 points of the opening between sill and lintel (2 m above the floor without one, or where it is
 *    higher), and to 40 points of each jamb and 25 of the lintel, 3 cm inside the edge. All lie 2 cm before the wall's
 *    face on the camera's side, so that neither the reveal nor a moulding hides them, nor what stands in the opening.
 *  - Bodies called `<id>_leaf…` are the door's own leaf and hide nothing of it, as long as a quarter of the opening's
 *    rays get past it: a leaf on the camera's side that covers more makes the door `ignored`. Panes of glass hide a
 *    door only half: what is seen through them makes it `ignored`, not `visible`, and adds to no share.
 *  - visible_share counts rays that miss the image as not visible. A jamb is in view when at least half of those of its
 *    points that are within the image are seen.
 *  - visible: both jambs in view and within kVisibleRange_m, visible_share ≥ 0.5, a quarter past the leaf. hidden: less
 * than a tenth of the rays arrive, panes of glass left aside. ignored: all else, with it a door of which one jamb is
 * out of the image. */
std::optional<TruthDoor> doorInView(const DoorLabel& label, const TruthView& view);
}  // namespace explore::simulation

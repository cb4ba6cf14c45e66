// How much infrared light a pane of window glass lets through.
#pragma once

namespace explore::simulation
{
/** Share of the light that comes back through a pane, there and back at this incidence, of what comes back at normal
 *  incidence: 1 at cosine 1, falling to 0 at cosine 0 (Fresnel's equations, index 1.52, both faces). */
double paneTransmission(double cosine);
}  // namespace explore::simulation

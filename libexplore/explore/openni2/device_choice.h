// Which of the cameras that are plugged in is meant.
#pragma once

#include <explore/openni2/library.h>

#include <string>

namespace explore::openni2
{
/** The URI of the camera that `wanted` names: "" = the first, a number in the list, a URI, or a serial number, for
 * which the cameras are opened one by one. A URI that is gone is taken for that of the only camera of its model: a
 * camera that is plugged in anew gets another one. Throws SensorLost that lists what there is, and what to check. */
std::string chooseDevice(const std::string& wanted);
}  // namespace explore::openni2

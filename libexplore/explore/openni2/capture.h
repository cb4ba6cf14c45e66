// Reads one camera into a mailbox, and opens it again as long as it is away.
#pragma once

#include <explore/openni2/mailbox.h>
#include <explore/sources/source_config.h>

#include <memory>

namespace explore::openni2
{
/** Returns when the mailbox says stop, or when the camera cannot be opened the first time, which the mailbox is told. A
 *  camera that is unplugged, or silent for a second, is closed and opened again: after 0.25 s, then twice that, up to 2
 * s; at once when one is plugged in. */
void capture(const Openni2Config& config, Mailbox& mailbox);
}  // namespace explore::openni2

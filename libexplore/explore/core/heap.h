// A process setting for programs that run the perception frame after frame.
#pragma once

namespace explore
{
/** Keeps freed memory in the process. A frame's clouds take a few MB that are freed again; handing them back to the
 * system each time costs a page fault per 4 kB, as much as the range filter itself. Does nothing where the C library
 * has no such setting. */
void keepFreedMemory();
}  // namespace explore

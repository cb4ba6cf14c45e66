// Ctrl-C and termination: noticed between two frames, so that all files end well.
#pragma once

namespace explore::app
{
/** From now on SIGINT and SIGTERM are only remembered, once each: a second one ends the program at once. Writing into a
 *  closed pipe or beyond a file size limit becomes an error of the write instead of a signal. */
void catchSignals();

/** The signal that asked the program to end; 0 = none. */
int signalReceived();
}  // namespace explore::app

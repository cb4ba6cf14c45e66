// What a program's exit code tells a script.
#pragma once

namespace explore::app
{
inline constexpr int kDone = 0, kInternalError = 1, kRequirementMissed = 1, kUsageError = 2, kInputError = 3,
                     kSensorLost = 4, kOutputError = 5,
                     kSignalBase = 128;  // plus the signal's number: 130 for SIGINT, 143 for SIGTERM
}  // namespace explore::app

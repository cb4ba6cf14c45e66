// A depth camera, or an .oni recording of one, as a source.
#pragma once

#include <explore/sources/source.h>

#include <memory>
#include <string>

namespace explore::app
{
/** The recording `config.oni`, else the camera of `config.openni2`. `logger` outlives it. Throws ConfigError, also
 * where the program was built without OpenNI2, InputError for the recording, and SensorLost for the camera. */
std::unique_ptr<FrameSource> openCamera(const SourceConfig& config, mrpt::system::COutputLogger& logger);
}  // namespace explore::app

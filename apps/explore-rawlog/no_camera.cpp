#include <explore-rawlog/record_camera.h>
#include <explore/core/errors.h>

namespace explore::app
{
int recordCamera(const CameraRecordOptions& options)
{
	throw ConfigError((options.device ? "--openni2" : "--oni") +
	                  std::string(": this program was built without cameras and .oni recordings, which need "
	                              "libopenni2-dev"));
}
}  // namespace explore::app

#include <common/camera_source.h>
#include <explore/core/errors.h>

namespace explore::app
{
std::unique_ptr<FrameSource> openCamera(const SourceConfig&, mrpt::system::COutputLogger&)
{
	throw ConfigError(
	    "[source] kind = openni2: this program was built without cameras and .oni recordings, which need "
	    "libopenni2-dev");
}
}  // namespace explore::app

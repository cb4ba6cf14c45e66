#include <common/camera_source.h>
#include <explore/openni2/oni_source.h>
#include <explore/openni2/openni2_source.h>

namespace explore::app
{
std::unique_ptr<FrameSource> openCamera(const SourceConfig& config, mrpt::system::COutputLogger& logger)
{
	if (config.oni.empty()) return std::make_unique<openni2::Openni2Source>(config, logger);
	return std::make_unique<openni2::OniSource>(config, logger);
}
}  // namespace explore::app

#include <explore/sources/rawlog_source.h>
#include <explore/sources/source.h>

namespace explore
{
std::unique_ptr<FrameSource> makeSource(const SourceConfig& config, mrpt::system::COutputLogger& logger)
{
	return std::make_unique<RawlogSource>(config, logger);
}
}  // namespace explore

#include <common/closed_loop_source.h>
#include <explore/core/errors.h>

namespace explore::app
{
std::unique_ptr<ClosedLoopSource> openSimulator(const LoadedConfig&, mrpt::system::COutputLogger&)
{
	throw ConfigError(
	    "[source] kind = simulator: this program was built without the simulator, which needs libsdformat-dev, "
	    "libassimp-dev and libembree-dev");
}
}  // namespace explore::app

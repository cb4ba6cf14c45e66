#include "layer_rules.h"

namespace explore::test
{
std::vector<Layer> projectLayers()
{
	const std::string root = "libexplore/explore/";
	return {
	    {"core", root + "core/", {}, {"mrpt", "Eigen", "malloc.h"}, true},
	    {"config", root + "config/", {"core"}, {"mrpt", "Eigen"}, false},
	    {"perception", root + "perception/", {"core", "config"}, {"mrpt", "Eigen", "octomap"}, true},
	    {"navigation", root + "navigation/", {"core", "config", "perception"}, {"mrpt", "Eigen", "octomap"}, true},
	    {"pipeline",
	     root + "pipeline/",
	     {"core", "config", "perception", "navigation"},
	     {"mrpt", "Eigen", "octomap"},
	     true},
	    {"sources", root + "sources/", {"core", "config"}, {"mrpt", "Eigen", "zlib.h"}, false},
	    {"sinks", root + "sinks/", {"core", "config", "pipeline"}, {"mrpt", "Eigen", "nlohmann", "CLI"}, false},
	    {"apps",
	     "apps/",
	     {"core", "config", "perception", "navigation", "pipeline", "sources", "sinks"},
	     {"mrpt", "Eigen", "nlohmann", "CLI"},
	     false},
	};
}
}  // namespace explore::test

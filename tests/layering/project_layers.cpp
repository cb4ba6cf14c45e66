#include "layer_rules.h"

namespace explore::test
{
std::vector<Layer> projectLayers()
{
	const std::string root = "libexplore/explore/";
	return {
	    // The truth about a simulated world: what looks for doors, remembers or steers must not see it.
	    {"truth", root + "core/truth.", {"core"}, {"mrpt", "Eigen"}, true},
	    {"core", root + "core/", {}, {"mrpt", "Eigen", "malloc.h"}, true},
	    {"config", root + "config/", {"core"}, {"mrpt", "Eigen"}, false},
	    {"perception", root + "perception/", {"core", "config"}, {"mrpt", "Eigen", "octomap"}, true},
	    {"memory", root + "memory/", {"core", "config", "perception"}, {"mrpt", "Eigen", "octomap"}, true},
	    {"navigation",
	     root + "navigation/",
	     {"core", "config", "perception", "memory"},
	     {"mrpt", "Eigen", "octomap"},
	     true},
	    {"pipeline",
	     root + "pipeline/",
	     {"core", "config", "perception", "memory", "navigation"},
	     {"mrpt", "Eigen", "octomap"},
	     true},
	    {"sources", root + "sources/", {"core", "config"}, {"mrpt", "Eigen", "octomap", "zlib.h"}, false},
	    {"openni2", root + "openni2/", {"core", "config", "sources"}, {"mrpt", "Eigen", "OpenNI.h", "dlfcn.h"}, false},
	    {"sinks",
	     root + "sinks/",
	     {"core", "config", "memory", "navigation", "pipeline"},
	     {"mrpt", "Eigen", "octomap", "nlohmann", "CLI"},
	     false},
	    {"evaluation",
	     root + "evaluation/",
	     {"core", "truth", "config", "perception", "memory", "navigation", "pipeline", "sinks"},
	     {"mrpt", "Eigen", "nlohmann"},
	     false},
	    {"simulation",
	     root + "simulation/",
	     {"core", "truth", "config"},
	     {"mrpt", "Eigen", "sdf", "assimp", "embree3"},
	     false},
	    {"apps",
	     "apps/",
	     {"core", "truth", "config", "perception", "memory", "navigation", "pipeline", "sources", "openni2", "sinks",
	      "evaluation", "simulation"},
	     {"mrpt", "Eigen", "nlohmann", "CLI", "zlib.h"},
	     false},
	};
}
}  // namespace explore::test

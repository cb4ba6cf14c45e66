// find_doors LOG.rawlog [N]: the doors in the N-th depth image of a recording, the first being 0.
#include <explore/perception/perceive.h>
#include <explore/sources/depth_conversion.h>
#include <mrpt/obs/CRawlog.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

int main(int argc, char** argv)
{
	mrpt::obs::CRawlog log;
	if (argc < 2 || !log.loadFromRawLogFile(argv[1])) return std::cerr << "which recording?\n", 2;
	explore::DepthConverter converter({}, argv[1]);
	long images = argc > 2 ? std::atol(argv[2]) : 0;
	for (const auto& entry : log)
	{
		const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(entry);
		if (!scan || images-- > 0) continue;
		// Robot frame: x forward, y left, z up, on the floor.
		const explore::Percepts seen = explore::perceive(converter.convert(*scan), {});
		for (const explore::Door& door : seen.doors)
			std::cout << nameOf(door.verdict) << " " << door.width_m << " m wide, "
			          << std::hypot(door.center.x(), door.center.y()) << " m away, "
			          << std::atan2(door.center.y(), door.center.x()) << " rad to the left\n";
		return 0;
	}
	return std::cerr << argv[1] << ": no such image\n", 1;
}

// [output]: which files a run leaves.
#pragma once

#include <explore/config/fields.h>

namespace explore
{
struct OutputConfig
{
	bool timing = true;                ///< timing.csv
	bool trajectory = true;            ///< trajectory.tum
	bool report = true;                ///< report.html
	bool scene = true;                 ///< scene.3Dscene
	bool annotated = false;            ///< annotated.rawlog
	int pictures_every = 0;            ///< a PNG of every n-th frame; 0 = none
	double checkpoint_period_s = 1.5;  ///< between two states that --resume can go on from; 0 = none
};
/** [output] */
void describe(FieldVisitor& fields, OutputConfig& config);
}  // namespace explore

#include "support/test_files.h"

#include <explore/sinks/timing_csv.h>

using namespace explore;

TEST(TimingCsv, OneColumnAStageAndTheTotalLast)
{
	const auto path = test::freshFolder() / "timing.csv";
	TimingCsv csv(path, {"read", "perceive"});
	csv.write(0, {{"read", 1.25}, {"perceive", 3.0}, {"total", 4.25}});
	csv.write(1, {{"perceive", 2.0}, {"total", 2.0}});
	EXPECT_EQ(test::readFile(path), "frame,read,perceive,total\n0,1.250,3.000,4.250\n1,0.000,2.000,2.000\n");
}

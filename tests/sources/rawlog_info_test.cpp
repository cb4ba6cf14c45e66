#include <explore/core/errors.h>
#include <explore/sources/rawlog_info.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
TEST(Info, TellsWhatTheLogHoldsAndThatItIsDamaged)
{
	const std::string whole = sampleBytes(Packing::gzipped);
	const RawlogInfo intact = describeRawlog(testFolder() / "whole.rawlog");
	EXPECT_TRUE(intact.compressed);
	EXPECT_FALSE(intact.damage);
	EXPECT_EQ(intact.objects, 2U * kSampleFrames);
	EXPECT_EQ(intact.sensory_frames, 0U);
	ASSERT_EQ(intact.sensors.size(), 2U);
	EXPECT_EQ(intact.sensors[0].label, "CAM");
	EXPECT_EQ(intact.sensors[0].count, static_cast<std::size_t>(kSampleFrames));
	EXPECT_NEAR(*intact.sensors[0].rate_hz(), 10.0, 1e-3);
	EXPECT_EQ(intact.sensors[0].intrinsics, sceneFrame().image.intrinsics);
	EXPECT_THAT(intact.pose_origins, testing::ElementsAre(PoseOrigin::odometry));
	EXPECT_NEAR(secondsBetween(*intact.first, *intact.last), 0.5, 1e-6);

	writeBytes(testFolder() / "cut.rawlog", whole.substr(0, whole.size() / 2));
	EXPECT_TRUE(describeRawlog(testFolder() / "cut.rawlog").damage);
	EXPECT_THAT(textOf(describeRawlog(testFolder() / "cut.rawlog")), testing::HasSubstr("damaged after"));
}

TEST(Info, RefusesAFileOfOtherObjects)
{
	writeRawlog(testFolder() / "map.rawlog", {mrpt::maps::CSimplePointsMap::Create()});
	EXPECT_THROW(describeRawlog(testFolder() / "map.rawlog"), InputError);
}
}  // namespace
}  // namespace explore::test

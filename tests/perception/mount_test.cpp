#include <explore/core/geometry.h>
#include <explore/perception/mount.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/analytic_scene.h"
#include "support/random_points.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;

/** A frame taken with mount `truth`, that claims mount `recorded`. */
DepthFrame frameWith(const CPose3D& truth, const CPose3D& recorded)
{
	DepthFrame frame = test::renderFrame(test::corridorScene(8.0, {3.0}, {}), {}, truth,
	                                     test::xtionIntrinsics(320, 240), {.axial_scale = 1.0});
	frame.robot_from_camera = recorded;
	return frame;
}

TEST(EstimateMount, HeightPitchAndRollOfRandomMounts)
{
	std::mt19937 random(41);
	for (int run = 0; run < 15; ++run)
	{
		const double height_m = test::uniform(random, 0.3, 1.3);
		const double pitch_rad = test::uniform(random, -5, 30) * kDegree_rad,
		             roll_rad = test::uniform(random, -10, 10) * kDegree_rad;
		const std::vector<DepthFrame> frames{
		    frameWith(CPose3D(0, 0, height_m, 0, pitch_rad, roll_rad), CPose3D::Identity())};
		const auto mount = estimateMount(frames, {});
		ASSERT_TRUE(mount) << "run " << run;
		EXPECT_NEAR(mount->height_m, height_m, 0.02) << "run " << run;
		EXPECT_NEAR(mount->pitch_rad, pitch_rad, 1.0 * kDegree_rad) << "run " << run;
		EXPECT_NEAR(mount->roll_rad, roll_rad, 1.0 * kDegree_rad) << "run " << run;
	}
}

TEST(EstimateMount, NoneWithoutAFloor)
{
	test::Scene scene;
	scene.wall({2, -3}, {2, 3}, 5.0);
	const std::vector<DepthFrame> frames{
	    test::renderFrame(scene, {}, CPose3D(0, 0, 2.5, 0, 0, 0), test::xtionIntrinsics(160, 120))};
	EXPECT_FALSE(estimateMount(frames, {}));
	EXPECT_THAT(mountRemark(frames, {}).value_or(""), testing::HasSubstr("no floor found in the first 1 frames"));
	EXPECT_FALSE(mountRemark({}, {}));
}

TEST(MountRemark, SilentWhenTheRecordedMountIsRight)
{
	const CPose3D mount(0.1, 0, 0.62, 0.2, 10 * kDegree_rad, 0);
	const std::vector<DepthFrame> frames{frameWith(mount, mount)};
	EXPECT_EQ(mountRemark(frames, {}).value_or(""), "");
}

TEST(MountRemark, NamesAWrongHeight)
{
	const std::vector<DepthFrame> frames{frameWith(CPose3D(0, 0, 0.62, 0, 0, 0), CPose3D(0.1, 0, 1.2, 0, 0, 0))};
	EXPECT_THAT(mountRemark(frames, {}).value_or(""),
	            testing::AllOf(testing::HasSubstr("0.6"), testing::HasSubstr("1.20")));
}

TEST(MountRemark, NamesAnOpticalFramePose)
{
	// What bag converters leave: the rotation to x right, y down, z forward.
	const std::vector<DepthFrame> frames{
	    frameWith(CPose3D(0, 0, 0.62, 0, 0, 0), CPose3D(0, 0, 0.62, -90 * kDegree_rad, 0, -90 * kDegree_rad))};
	EXPECT_THAT(mountRemark(frames, {}).value_or(""), testing::HasSubstr("recorded height 0.62 m, pitch"));
}

TEST(MountRemark, IdentitySaysNothingAboutHeight)
{
	const std::vector<DepthFrame> frames{frameWith(CPose3D(0, 0, 0.62, 0, 0, 0), CPose3D::Identity())};
	EXPECT_EQ(mountRemark(frames, {}).value_or(""), "");
}
}  // namespace
}  // namespace explore

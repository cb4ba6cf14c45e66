#include <explore/perception/wall_bend.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/analytic_scene.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;

/** What the frames of a drive along a corridor say when every depth z is measured as z + curvature · z². */
WallBend driveThroughCorridor(double curvature_per_m, int frames)
{
	const test::Scene scene = test::corridorScene(9, {}, {});
	WallBend bend;
	for (int i = 0; i < frames; ++i)
	{
		test::CameraNoise noise;
		noise.axial_scale = 1.0;
		noise.seed = static_cast<std::uint32_t>(i);
		const CPose3D map_from_robot(0.1 * i, 0.02 * (i % 9) - 0.1, 0, 0.03 * (i % 5) - 0.06, 0, 0);
		DepthFrame frame = test::renderFrame(scene, map_from_robot, CPose3D(0, 0, 0.7, 0, 0.05, 0),
		                                     test::xtionIntrinsics(160, 120), noise);
		for (float& z : frame.image.depth_m) z += static_cast<float>(curvature_per_m) * z * z;
		const LevelView view = levelView(frame, {}, {}, {}, {});
		bend = withFrame(bend, findUprightWalls(view, {}, {}, 1), view.pose);
	}
	return bend;
}

TEST(WallBend, MeasuresTheCurvatureAndNamesTheRemedy)
{
	for (const double curvature : {0.02, -0.015})
	{
		const WallBend bend = driveThroughCorridor(curvature, 25);
		EXPECT_NEAR(bend.curvaturePerM(), curvature, 0.15 * std::abs(curvature) + 0.001);
		const auto remark = bentWallRemark(bend);
		ASSERT_TRUE(remark);
		EXPECT_THAT(*remark, testing::HasSubstr("depth_quadratic"));
		EXPECT_THAT(*remark, testing::HasSubstr(curvature > 0 ? "large" : "small"));
	}
}

TEST(WallBend, SaysNothingOfACalibratedCameraNorOfAFewFrames)
{
	const WallBend straight = driveThroughCorridor(0.0, 25);
	EXPECT_GE(straight.frames, 20U);
	EXPECT_NEAR(straight.curvaturePerM(), 0.0, 0.002);
	EXPECT_FALSE(bentWallRemark(straight));
	EXPECT_FALSE(bentWallRemark(driveThroughCorridor(0.02, 8)));
	EXPECT_FALSE(bentWallRemark({}));
}

TEST(WallBend, LooksUpAndDownAreLeftOut)
{
	LevelPose pose;
	pose.level_from_camera.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()).toRotationMatrix();
	const std::vector<UprightWall> walls{{{0, -1}, 1.0, -4, -1, 3000}, {{0, 1}, 1.0, 1, 4, 3000}};
	EXPECT_EQ(withFrame({}, walls, pose).frames, 0U);
	EXPECT_EQ(withFrame({}, walls, {}).frames, 1U);
}
}  // namespace
}  // namespace explore

#include <explore/perception/range_filter.h>
#include <gtest/gtest.h>

#include "support/analytic_scene.h"
#include "support/random_points.h"

namespace explore
{
namespace
{
DepthFrame randomFrame(std::mt19937& random)
{
	DepthFrame frame;
	frame.image.intrinsics = {37, 23, test::uniform(random, 20, 60), test::uniform(random, 20, 60), 17.3, 12.1};
	for (int i = 0; i < 37 * 23; ++i)
		frame.image.depth_m.push_back(random() % 5 == 0 ? 0.0F : static_cast<float>(test::uniform(random, 0.01, 9.0)));
	frame.robot_from_camera =
	    mrpt::poses::CPose3D(test::uniform(random, -1, 1), test::uniform(random, -1, 1), test::uniform(random, 0, 1),
	                         test::uniform(random, -3, 3), test::uniform(random, -1, 1), test::uniform(random, -3, 3));
	return frame;
}

/** Pixel by pixel with MRPT's own pose composition and the equations of its CObservation3DRangeScan reference. */
PointCloud slowReference(const DepthFrame& frame, double max_range_m)
{
	PointCloud points;
	const CameraIntrinsics& k = frame.image.intrinsics;
	for (int v = 0; v < k.height_px; ++v)
		for (int u = 0; u < k.width_px; ++u)
		{
			const double depth = frame.image.at(u, v);
			if (depth <= 0 || depth > max_range_m) continue;
			double x = 0, y = 0, z = 0;
			frame.robot_from_camera.composePoint(depth, (k.cx_px - u) * depth / k.fx_px,
			                                     (k.cy_px - v) * depth / k.fy_px, x, y, z);
			points.push_back(Eigen::Vector3d(x, y, z).cast<float>());
		}
	return points;
}

TEST(RangeFilter, EqualsPixelByPixelReference)
{
	std::mt19937 random(7);
	for (int run = 0; run < 50; ++run)
	{
		const DepthFrame frame = randomFrame(random);
		const PointCloud fast = rangeFilter(frame, {5.0});
		const PointCloud slow = slowReference(frame, 5.0);
		ASSERT_EQ(fast.size(), slow.size());
		Eigen::AlignedBox3f reach = reachOf(frame, {5.0});
		reach.extend(reach.max() + Eigen::Vector3f::Constant(1e-4F))
		    .extend(reach.min() - Eigen::Vector3f::Constant(1e-4F));
		for (std::size_t i = 0; i < fast.size(); ++i) ASSERT_TRUE(reach.contains(fast[i])) << "point " << i;
		for (std::size_t i = 0; i < fast.size(); ++i) ASSERT_LT((fast[i] - slow[i]).norm(), 1e-4F) << "point " << i;
	}
}

TEST(RangeFilter, RangeOfAnImageIsDepthAlongTheAxis)
{
	DepthFrame frame;
	frame.image.intrinsics = {3, 1, 1.0, 1.0, 1.0, 0.0};  // the outer pixels look 45° to the side
	frame.image.depth_m = {4.9F, 5.1F, 4.9F};
	EXPECT_EQ(rangeFilter(frame, {5.0}).size(), 2U);
}

TEST(RangeFilter, RangeOfAnUnorganisedCloudIsDistance)
{
	DepthFrame frame;
	frame.points_in_camera.push_back({-4.0F, 0.0F, 0.0F});  // behind the sensor counts
	frame.points_in_camera.push_back({4.0F, 4.0F, 0.0F});
	frame.points_in_camera.push_back({0.0F, 0.0F, 0.0F});  // no return
	frame.robot_from_camera = mrpt::poses::CPose3D(1, 0, 0.5, 0, 0, 0);
	const PointCloud points = rangeFilter(frame, {5.0});
	ASSERT_EQ(points.size(), 1U);
	EXPECT_TRUE(points[0].isApprox(Eigen::Vector3f(-3.0F, 0.0F, 0.5F)));
}

TEST(RangeFilter, NearMeasurementsStay)
{
	DepthFrame frame;
	frame.image.intrinsics = {1, 1, 1.0, 1.0, 0.0, 0.0};
	frame.image.depth_m = {0.05F};
	EXPECT_EQ(rangeFilter(frame, {5.0}).size(), 1U);
}

TEST(RangeFilter, FrameWithoutReturnsGivesNothing)
{
	DepthFrame frame;
	frame.image.intrinsics = test::xtionIntrinsics(64, 48);
	frame.image.depth_m.assign(64 * 48, 0.0F);
	EXPECT_TRUE(rangeFilter(frame, {5.0}).empty());
	EXPECT_TRUE(rangeFilter(DepthFrame{}, {5.0}).empty());
}
}  // namespace
}  // namespace explore

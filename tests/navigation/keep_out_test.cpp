#include <explore/core/errors.h>
#include <explore/navigation/keep_out.h>
#include <gmock/gmock.h>

namespace explore
{
namespace
{
BoundsConfig keepOut(const std::string& polygons)
{
	BoundsConfig config;
	config.keep_out = polygons;
	return config;
}

TEST(AllowedArea, IsEverythingUnlessAnythingIsSaid)
{
	const AllowedArea area = allowedArea({});
	EXPECT_TRUE(area.keep_out.empty());
	for (const Eigen::Vector2d& point : {Eigen::Vector2d(0, 0), {1e6, -1e6}}) EXPECT_TRUE(area.allows(point));
}

TEST(AllowedArea, EndsAtTheBounds)
{
	const AllowedArea area =
	    allowedArea({.enabled = true, .min_x_m = -1, .max_x_m = 2, .min_y_m = -3, .max_y_m = 4, .keep_out = ""});
	for (const Eigen::Vector2d& inside : {Eigen::Vector2d(0, 0), {-1, -3}, {2, 4}, {-1, 4}})
		EXPECT_TRUE(area.inBounds(inside)) << inside.transpose();
	for (const Eigen::Vector2d& outside : {Eigen::Vector2d(-1.01, 0), {2.01, 0}, {0, -3.01}, {0, 4.01}})
		EXPECT_FALSE(area.allows(outside)) << outside.transpose();
}

TEST(AllowedArea, BoundsThatAreOffBoundNothing)
{
	const AllowedArea area =
	    allowedArea({.enabled = false, .min_x_m = 1, .max_x_m = 0, .min_y_m = 1, .max_y_m = 0, .keep_out = ""});
	EXPECT_TRUE(area.allows({100, 100}));
}

TEST(AllowedArea, LeavesOutPolygonsOfAnyShape)
{
	// An L with its inner corner at (1, 1), and a triangle.
	const AllowedArea area = allowedArea(keepOut("0 0, 2 0, 2 1, 1 1, 1 2, 0 2; 5 5, 6 5, 5.5 6"));
	ASSERT_EQ(area.keep_out.size(), 2U);
	for (const Eigen::Vector2d& inside : {Eigen::Vector2d(0.5, 0.5), {1.9, 0.9}, {0.9, 1.9}, {5.5, 5.9}, {5.1, 5.1}})
	{
		EXPECT_TRUE(area.isKeptOut(inside)) << inside.transpose();
		EXPECT_TRUE(area.inBounds(inside));
		EXPECT_FALSE(area.allows(inside));
	}
	for (const Eigen::Vector2d& outside : {Eigen::Vector2d(1.1, 1.1), {-0.1, 0.5}, {2.1, 0.5}, {5.1, 5.9}, {5.5, 4.9}})
		EXPECT_FALSE(area.isKeptOut(outside)) << outside.transpose();
}

TEST(AllowedArea, BoundsAndPolygonsCountTogether)
{
	const AllowedArea area = allowedArea(
	    {.enabled = true, .min_x_m = 0, .max_x_m = 4, .min_y_m = 0, .max_y_m = 4, .keep_out = "1 1, 2 1, 2 2, 1 2"});
	EXPECT_TRUE(area.allows({3, 3}));
	EXPECT_FALSE(area.allows({1.5, 1.5}));
	EXPECT_FALSE(area.allows({5, 3}));
}

TEST(AllowedArea, RefusesWhatIsNoPolygonAndSaysWhatIs)
{
	for (const char* wrong : {"0 0, 1 0", "0 0, 1 0, 1", "0 0, 1 0, 1 1 1", "a b, 1 0, 1 1", "0 0, 1 0, 1 1; ", ";",
	                          "0 0, 1 0, nan 1", "0 0, 1 0, 1,5 1"})
	{
		try
		{
			(void)allowedArea(keepOut(wrong));
			ADD_FAILURE() << "accepted: " << wrong;
		}
		catch (const ConfigError& error)
		{
			EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("keep_out"), testing::HasSubstr(wrong)));
		}
	}
}

TEST(AllowedArea, RefusesBoundsThatEncloseNothing)
{
	EXPECT_THROW((void)allowedArea({.enabled = true, .min_x_m = 1, .max_x_m = 1, .keep_out = ""}), ConfigError);
	EXPECT_THROW((void)allowedArea({.enabled = true, .min_y_m = 11, .keep_out = ""}), ConfigError);
}
}  // namespace
}  // namespace explore

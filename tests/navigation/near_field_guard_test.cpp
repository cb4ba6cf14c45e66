#include <explore/navigation/near_field_guard.h>
#include <gtest/gtest.h>

#include <vector>

namespace explore
{
namespace
{
constexpr double kMinRange_m = 0.4;

/** All strips see a wall 3 m away. */
NearField farWall()
{
	NearField field;
	field.organised = true;
	field.valid_pixels = 300'000;
	for (auto& sector : field.sectors) sector = {3.0F, 0.02F};
	return field;
}

NearField with(NearField field, std::size_t strip, float nearest_m, float no_return_share)
{
	field.sectors[strip].nearest_m = nearest_m;
	field.sectors[strip].no_return_share = no_return_share;
	return field;
}

NearFieldGuard after(const std::vector<NearField>& fields)
{
	NearFieldGuard guard;
	for (const NearField& field : fields) guard = updateGuard(guard, field, kMinRange_m, NearFieldGuardConfig());
	return guard;
}

TEST(NearFieldGuard, ObstacleThatSlipsUnderTheMinimumRangeIsLostUntilTheStripSeesAgain)
{
	const NearField approaching = with(farWall(), 8, 0.45F, 0.05F);
	const NearField under = with(farWall(), 8, 3.0F, 0.9F);
	NearFieldGuard guard = after({farWall(), with(farWall(), 8, 0.6F, 0.03F), approaching});
	EXPECT_FALSE(guard.lost[8]);
	guard = after({approaching, under});
	EXPECT_TRUE(guard.lost[8]);
	EXPECT_TRUE(after({approaching, under, under, under}).lost[8]) << "it has not gone";
	guard = after({approaching, under, farWall()});
	EXPECT_FALSE(guard.lost[8]);
	EXPECT_FALSE(guard.watched[8]) << "forgotten";
}

TEST(NearFieldGuard, GradualSlipIsNoticed)
{
	// The nearest part is still measured while more and more of the obstacle drops out.
	std::vector<NearField> fields;
	for (const float share : {0.02F, 0.10F, 0.18F, 0.26F, 0.34F}) fields.push_back(with(farWall(), 5, 0.42F, share));
	EXPECT_TRUE(after(fields).lost[5]);
}

TEST(NearFieldGuard, ObstacleThatLeavesIsForgotten)
{
	const NearFieldGuard guard = after({with(farWall(), 8, 0.5F, 0.1F), farWall(), with(farWall(), 8, 0.0F, 1.0F)});
	EXPECT_FALSE(guard.lost[8]) << "a dark view later on is no lost obstacle";
}

TEST(NearFieldGuard, DarkViewWithoutANearObstacleIsNotLost)
{
	EXPECT_FALSE(after({farWall(), with(farWall(), 3, 0.0F, 1.0F)}).lost[3]);
	EXPECT_FALSE(after({with(farWall(), 3, 0.71F, 0.0F), with(farWall(), 3, 0.0F, 1.0F)}).lost[3])
	    << "beyond min_range + warn_distance";
}

TEST(NearFieldGuard, StripsAreIndependent)
{
	const NearFieldGuard guard = after({with(farWall(), 8, 0.45F, 0.0F), with(farWall(), 9, 0.0F, 1.0F)});
	for (std::size_t i = 0; i < NearField::kSectors; ++i) EXPECT_FALSE(guard.lost[i]) << i;
}

TEST(NearFieldGuard, UnorganisedCloudsAreNeverWatched)
{
	NearField cloud = with(farWall(), 8, 0.45F, 0.0F);
	cloud.organised = false;
	const NearFieldGuard guard = after({cloud, with(farWall(), 8, 0.0F, 1.0F)});
	EXPECT_FALSE(guard.watched[8]);
	EXPECT_FALSE(guard.lost[8]);
}

TEST(NearFieldGuard, ObstacleThatLeftBeforeAViewWithFewReturnsIsFound)
{
	// Down a long corridor half of a strip is out of range: that is no obstacle, but more than was missing before.
	const NearField under = with(farWall(), 8, 0.0F, 1.0F), far_view = with(farWall(), 8, 7.0F, 0.55F);
	const NearField approaching = with(farWall(), 8, 0.45F, 0.0F);
	EXPECT_TRUE(after({approaching, under}).lost[8]);
	EXPECT_FALSE(after({approaching, under, far_view}).lost[8]);
	EXPECT_FALSE(after({approaching, under, far_view, under}).lost[8]) << "nothing near was seen since";
	EXPECT_TRUE(after({approaching, under, approaching, under}).lost[8]) << "it came back out and went under again";
}

TEST(NearFieldGuard, AnyLostStripStops)
{
	NearFieldGuard guard;
	EXPECT_FALSE(obstacleLost(guard));
	guard.watched[3] = 0.1F;
	EXPECT_FALSE(obstacleLost(guard));
	guard.lost[15] = 0.0F;
	EXPECT_TRUE(obstacleLost(guard));
}
}  // namespace
}  // namespace explore

#include <explore/memory/door_belief.h>
#include <gtest/gtest.h>

namespace explore::test
{
namespace
{
constexpr double kFading = 0.8;

DoorBelief after(const std::vector<DoorOpinion>& opinions)
{
	DoorBelief belief;
	for (const DoorOpinion& opinion : opinions) addOpinion(belief, opinion, kFading);
	return belief;
}

const DoorOpinion kOpen{Verdict::open, 0.9, 0.95, 1.0};
const DoorOpinion kClosed{Verdict::closed, 0.0, 0.05, 1.0};
const DoorOpinion kPartial{Verdict::partial, 0.3, 0.4, 1.0};

TEST(DoorBelief, NothingIsKnownBeforeTheFirstLook)
{
	EXPECT_EQ(verdictOf(DoorBelief()), Verdict::unknown);
	EXPECT_EQ(clearWidthOf(DoorBelief()), 0.0);
	EXPECT_DOUBLE_EQ(confidenceOf(DoorBelief()), 0.5);
}

TEST(DoorBelief, OneWrongLookDoesNotFlipIt)
{
	for (std::size_t wrong = 0; wrong < 5; ++wrong)
	{
		std::vector<DoorOpinion> looks(5, kOpen);
		looks[wrong] = kClosed;
		const DoorBelief belief = after(looks);
		EXPECT_EQ(verdictOf(belief), Verdict::open) << "look " << wrong;
		EXPECT_NEAR(clearWidthOf(belief), 0.9, 1e-12) << "the width is that of the looks that are believed";
		EXPECT_GT(confidenceOf(belief), 0.5);
	}
}

TEST(DoorBelief, ADoorThatIsClosedIsBelievedAfterSomeLooks)
{
	DoorBelief belief = after(std::vector<DoorOpinion>(50, kOpen));
	int looks = 0;
	for (; verdictOf(belief) == Verdict::open && looks < 50; ++looks) addOpinion(belief, kClosed, kFading);
	EXPECT_GE(looks, 2);
	EXPECT_LE(looks, 6);
	EXPECT_LT(confidenceOf(belief), 0.6);
	for (int i = 0; i < 5; ++i) addOpinion(belief, kClosed, kFading);
	EXPECT_LT(confidenceOf(belief), 0.2);
	EXPECT_EQ(clearWidthOf(belief), 0.0);
}

TEST(DoorBelief, WaysOfBeingOpenAreTakenTogetherAgainstTheRest)
{
	const DoorOpinion ajar{Verdict::ajar, 0.7, 0.9, 1.0}, passage{Verdict::passage, 0.9, 0.9, 1.0};
	EXPECT_EQ(verdictOf(after({kClosed, kClosed, kOpen, ajar, passage, ajar})), Verdict::ajar);
}

TEST(DoorBelief, AJambOutOfViewSaysNextToNothing)
{
	EXPECT_EQ(verdictOf(after({kOpen, kPartial, kPartial, kPartial})), Verdict::open);
	EXPECT_EQ(verdictOf(after({kPartial, kPartial, kPartial, kOpen})), Verdict::open);
	EXPECT_EQ(verdictOf(after({kPartial})), Verdict::partial);
	EXPECT_NEAR(confidenceOf(after({kOpen, kPartial})), confidenceOf(after({kOpen})), 0.03);
}

TEST(DoorBelief, NearLooksCountMoreThanFarOnes)
{
	const DoorOpinion far{Verdict::unknown, 0.9, 0.3, 0.2};
	EXPECT_EQ(verdictOf(after({far, far, far, kOpen})), Verdict::open);
	EXPECT_EQ(verdictOf(after({kOpen, far, far, far})), Verdict::open);
}

TEST(DoorBelief, ManyLooksAreSurerThanOneAndNeverMoreThanTwice)
{
	const DoorOpinion look{Verdict::open, 0.9, 0.8, 1.0};  // odds 4 : 1
	EXPECT_NEAR(confidenceOf(after({look})), 0.8, 1e-12);
	EXPECT_GT(confidenceOf(after({look, look})), 0.8);
	EXPECT_LT(confidenceOf(after(std::vector<DoorOpinion>(100, look))), 16.0 / 17.0);
}
}  // namespace
}  // namespace explore::test

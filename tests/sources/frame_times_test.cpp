// How far the source reads ahead, and what it does with times that are out of order or invalid.
#include <mrpt/system/datetime.h>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
Objects::value_type scanAt(double seconds)
{
	return scanOf(sceneFrame(), seconds);
}

std::vector<DepthFrame> framesOf(const Objects& objects, Listener& listener)
{
	const auto log = testFolder() / "times.rawlog";
	writeRawlog(log, objects, Packing::plain);
	return replay(configFor(log), nullptr, &listener);
}

TEST(LookAhead, IsBoundedAndStartsBeforeTheLogIsRead)
{
	Objects objects;
	for (int i = 0; i < 400; ++i) objects.push_back(scanAt(0.001 * i));
	const auto log = testFolder() / "long.rawlog";
	writeRawlog(log, objects, Packing::plain);
	Listener listener;
	const auto source = makeSource(configFor(log), listener);
	ASSERT_TRUE(source->next());
	EXPECT_LT(*source->progress(), 0.25);
	std::size_t count = 1;
	while (source->next()) ++count;
	EXPECT_EQ(count, 400U);
	EXPECT_EQ(*source->progress(), 1.0);
}

TEST(Times, OutOfOrderFramesAreDeliveredAsTheyComeAndSaidOnce)
{
	Listener listener;
	const auto frames = framesOf({scanAt(1), scanAt(0.5), scanAt(0.5), scanAt(2)}, listener);
	ASSERT_EQ(frames.size(), 4U);
	EXPECT_EQ(frames[1].timestamp, at(0.5));
	EXPECT_EQ(frames[2].timestamp, at(0.5));
	EXPECT_EQ(listener.warnings("order of their timestamps"), 1U);
}

TEST(Times, AnInvalidTimeBecomesThatOfTheFrameBefore)
{
	auto timeless = scanOf(sceneFrame(), 0);
	timeless->timestamp = INVALID_TIMESTAMP;
	Listener listener;
	const auto frames = framesOf({scanAt(1), timeless, timeless, scanAt(2)}, listener);
	ASSERT_EQ(frames.size(), 4U);
	EXPECT_EQ(frames[1].timestamp, at(1));
	EXPECT_EQ(frames[2].timestamp, at(1));
	EXPECT_EQ(listener.warnings("without a valid timestamp"), 1U);
}
}  // namespace
}  // namespace explore::test

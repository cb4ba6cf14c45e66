#include <explore/sinks/report/thinning.h>
#include <gtest/gtest.h>

#include <map>

using namespace explore;

TEST(Thinning, KeepsEveryFrameWhileTheyAreFewAndSmall)
{
	Thinning thinning({1000, 50, 1});
	for (std::size_t frame = 0; frame < 50; ++frame) thinning.add(frame, 20);
	EXPECT_EQ(thinning.stride(), 1U);
	thinning.add(50, 1);
	EXPECT_EQ(thinning.stride(), 2U);
	EXPECT_FALSE(thinning.wants(51));
	EXPECT_TRUE(thinning.wants(52));
}

TEST(Thinning, WhatIsKeptStaysBelowBothLimitsHoweverMuchComes)
{
	Thinning thinning({10'000, 64, 4});
	std::map<std::size_t, std::size_t> shown;
	for (std::size_t frame = 0; frame < 100'000; ++frame)
	{
		if (!thinning.wants(frame)) continue;
		const std::size_t bytes = 50 + frame % 700;
		thinning.add(frame, bytes);
		shown[frame] = bytes;
	}
	std::size_t count = 0, bytes = 0;
	for (const auto& [frame, size] : shown)
		if (thinning.wants(frame))
		{
			++count;
			bytes += size;
		}
	EXPECT_LE(count, 64U);
	EXPECT_LE(bytes, 10'000U);
	EXPECT_GE(count, 8U) << "not thinner than need be";
}

TEST(Thinning, TheFirstIsKeptWhateverItsSize)
{
	Thinning thinning({10, 5, 1});
	thinning.add(0, 1'000'000);
	EXPECT_TRUE(thinning.wants(0));
	EXPECT_EQ(thinning.stride(), 1U);
}

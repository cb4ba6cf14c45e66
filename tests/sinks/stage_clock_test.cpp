#include <explore/sinks/stage_clock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace explore;

TEST(StageClock, TotalIsTheSumOfTheStages)
{
	StageClock clock;
	clock.start();
	for (const char* stage : {"a", "b", "a"}) clock.ended(stage);
	const StageTimes& times = clock.times();
	ASSERT_EQ(times.size(), 3U);
	EXPECT_GE(times.at("a"), 0.0);
	EXPECT_DOUBLE_EQ(times.at("total"), times.at("a") + times.at("b"));
}

TEST(StageClock, AFrameStartsFromZero)
{
	StageClock clock;
	clock.start();
	clock.ended("a");
	clock.start();
	EXPECT_EQ(clock.times(), (StageTimes{{"total", 0.0}}));
}

TEST(TimingRecord, MedianAndPercentileOfKnownTimes)
{
	std::vector<double> times_ms(200);
	for (std::size_t i = 0; i < times_ms.size(); ++i) times_ms[i] = static_cast<double>(i + 1);
	std::shuffle(times_ms.begin(), times_ms.end(), std::mt19937(3));
	TimingRecord record;
	for (const double time_ms : times_ms) record.add({{"perceive", time_ms}});
	const auto statistics = record.statistics();
	EXPECT_DOUBLE_EQ(statistics.at("perceive").median_ms, 100.5);
	EXPECT_DOUBLE_EQ(statistics.at("perceive").p99_ms, 198.0);  // 198 of 200 are not larger
}

TEST(TimingRecord, OneFrameIsItsOwnMedian)
{
	TimingRecord record;
	record.add({{"perceive", 4.5}, {"total", 6.0}});
	const auto statistics = record.statistics();
	EXPECT_EQ(statistics.size(), 2U);
	EXPECT_DOUBLE_EQ(statistics.at("perceive").median_ms, 4.5);
	EXPECT_DOUBLE_EQ(statistics.at("total").p99_ms, 6.0);
}

TEST(TimingRecord, NoFramesNoStatistics)
{
	EXPECT_TRUE(TimingRecord().statistics().empty());
}

TEST(PeakMemory, IsThatOfThisProcess)
{
	const std::vector<char> block(64U << 20U, 1);
	EXPECT_GT(peakResidentMegabytes(), 64.0 + 0.001 * block.front());
	EXPECT_LT(peakResidentMegabytes(), 20000.0);
}

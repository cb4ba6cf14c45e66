// Numbers and angles survive the way through text bit for bit, in the shortest form.
#include <explore/config/number_text.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace explore
{
namespace
{
std::uint64_t bits(double number)
{
	return std::bit_cast<std::uint64_t>(number);
}

/** Any finite double, all magnitudes alike. */
double anyDouble(std::mt19937_64& random)
{
	for (;;)
		if (const auto number = std::bit_cast<double>(random()); std::isfinite(number)) return number;
}

TEST(NumberText, anyNumberComesBackBitForBit)
{
	std::mt19937_64 random(1);
	for (int i = 0; i < 20000; ++i)
	{
		const double number = anyDouble(random);
		const auto back = parseNumber(formatNumber(number));
		ASSERT_TRUE(back) << formatNumber(number);
		ASSERT_EQ(bits(*back), bits(number)) << formatNumber(number);
	}
	EXPECT_EQ(bits(*parseNumber(formatNumber(-0.0))), bits(-0.0));
}

TEST(NumberText, writesWhatAPersonWouldWrite)
{
	EXPECT_EQ(formatNumber(0.1), "0.1");
	EXPECT_EQ(formatNumber(5), "5");
	EXPECT_EQ(formatNumber(-0.05), "-0.05");
}

TEST(NumberText, readsTheUsualSpellings)
{
	EXPECT_EQ(parseNumber("+2.5"), 2.5);
	EXPECT_EQ(parseNumber("-.5"), -0.5);
	EXPECT_EQ(parseNumber("1e3"), 1000.0);
	EXPECT_EQ(parseNumber("3.333333e-01"), 0.3333333);
}

TEST(NumberText, refusesWhatIsNoFiniteNumber)
{
	for (const auto* text : {"", "abc", "2,5", "1.5x", "1 2", " 1", "nan", "NaN", "inf", "-inf", "infinity", "1e999",
	                         "0x10", "+-1", "--1", "1e", "1e+", "."})
	{
		EXPECT_FALSE(parseNumber(text)) << text;
		EXPECT_FALSE(parseDegrees(text)) << text;
	}
}

TEST(NumberText, anyAngleComesBackBitForBit)
{
	std::mt19937_64 random(2);
	std::uniform_real_distribution<double> turn_rad(-7, 7);
	for (int i = 0; i < 20000; ++i)
	{
		const double angle_rad = i % 2 == 0 ? turn_rad(random) : std::ldexp(turn_rad(random), -(i % 60));
		const auto back_rad = parseDegrees(formatDegrees(angle_rad));
		ASSERT_TRUE(back_rad) << formatDegrees(angle_rad);
		ASSERT_EQ(bits(*back_rad), bits(angle_rad)) << formatDegrees(angle_rad);
	}
	EXPECT_EQ(bits(*parseDegrees(formatDegrees(-0.0))), bits(-0.0));
}

TEST(NumberText, wholeAndHalfDegreesStayShort)
{
	for (int half_degrees = -720; half_degrees <= 720; ++half_degrees)
	{
		const double angle_deg = half_degrees / 2.0;
		EXPECT_EQ(formatDegrees(angle_deg * std::numbers::pi / 180), formatNumber(angle_deg));
	}
}

TEST(NumberText, degreesBecomeRadians)
{
	EXPECT_EQ(parseDegrees("180"), std::numbers::pi);
	EXPECT_EQ(parseDegrees("-90"), -std::numbers::pi / 2);
	EXPECT_NEAR(*parseDegrees("57.295779513082320877"), 1.0, 1e-16);
}
}  // namespace
}  // namespace explore

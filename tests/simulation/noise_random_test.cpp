#include <explore/simulation/noise_random.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace explore::simulation
{
namespace
{
std::vector<float> gaussian(NoiseKey key, std::size_t count)
{
	std::vector<float> numbers(count);
	fillGaussian(key, 0, numbers);
	return numbers;
}

TEST(NoiseRandom, GaussianHasTheMomentsAndTailsOfTheNormalDistribution)
{
	constexpr std::size_t kCount = 4'000'001;
	const std::vector<float> numbers = gaussian(noiseKey(42, 1), kCount);
	std::array<double, 5> moment{};
	std::array<double, 5> beyond{};  // share of |x| > 0, 1, 2, 3, 4
	for (const float number : numbers)
	{
		const auto x = static_cast<double>(number);
		for (std::size_t i = 1; i <= 4; ++i) moment[i] += std::pow(x, i) / kCount;
		for (std::size_t i = 0; i <= 4; ++i) beyond[i] += std::abs(x) > static_cast<double>(i) ? 1.0 / kCount : 0.0;
	}
	EXPECT_NEAR(moment[1], 0.0, 4.0 / std::sqrt(kCount));
	EXPECT_NEAR(moment[2], 1.0, 4.0 * std::sqrt(2.0 / kCount));
	EXPECT_NEAR(moment[3], 0.0, 4.0 * std::sqrt(15.0 / kCount));
	EXPECT_NEAR(moment[4], 3.0, 4.0 * std::sqrt(96.0 / kCount));
	for (std::size_t i = 1; i <= 4; ++i)
	{
		const double expected = std::erfc(static_cast<double>(i) / std::sqrt(2.0));
		EXPECT_NEAR(beyond[i], expected, 4.0 * std::sqrt(expected / kCount)) << i << " sigma";
	}
}

TEST(NoiseRandom, GaussianFollowsTheNormalDistributionEverywhere)
{
	constexpr std::size_t kCount = 1'000'000;
	constexpr int kBins = 200;
	std::array<int, kBins> bin{};
	for (const float x : gaussian(noiseKey(7, 7), kCount))
	{
		const double share = 0.5 * std::erfc(-static_cast<double>(x) / std::sqrt(2.0));
		++bin[static_cast<std::size_t>(std::min(kBins - 1, static_cast<int>(share * kBins)))];
	}
	double chi2 = 0.0;
	for (const int count : bin) chi2 += std::pow(count - 1.0 * kCount / kBins, 2) / (1.0 * kCount / kBins);
	EXPECT_LT(chi2, 282.0) << "chi-square with 199 degrees of freedom is below this but once in 10 000 cases";
	EXPECT_GT(chi2, 130.0);
}

double correlation(const std::vector<float>& a, const std::vector<float>& b, std::size_t shift)
{
	double sum = 0.0;
	for (std::size_t i = 0; i + shift < a.size(); ++i) sum += static_cast<double>(a[i] * b[i + shift]);
	return sum / static_cast<double>(a.size());
}

TEST(NoiseRandom, NumbersAreIndependentOfTheirNeighboursAndOfOtherKeys)
{
	constexpr std::size_t kCount = 400'000;
	const double bound = 4.5 / std::sqrt(kCount);
	const std::vector<float> numbers = gaussian(noiseKey(1, 1), kCount);
	for (const std::size_t shift : {1U, 2U, 3U, 640U, 200'000U})
		EXPECT_NEAR(correlation(numbers, numbers, shift), 0.0, bound);
	EXPECT_NEAR(correlation(numbers, gaussian(noiseKey(2, 1), kCount), 0), 0.0, bound) << "neighbouring seed";
	EXPECT_NEAR(correlation(numbers, gaussian(noiseKey(1, 2), kCount), 0), 0.0, bound) << "neighbouring stream";
}

TEST(NoiseRandom, PiecesGiveTheSameNumbersAsTheWhole)
{
	const NoiseKey key = noiseKey(3, 9);
	std::vector<float> whole(100), part(20);
	fillGaussian(key, 10, whole);
	fillGaussian(key, 20, part);
	for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(part[i], whole[10 + i]);
}

TEST(NoiseRandom, BlobsAreUniformOverallAndAlikeWithin)
{
	constexpr int kSide = 600;
	std::array<int, 10> tenth{};
	int alike = 0;
	for (int v = 0; v < kSide; ++v)
		for (int u = 0; u < kSide; ++u)
		{
			const float value = noiseOfBlob(noiseKey(5, 5), u, v, 6.0F);
			ASSERT_GT(value, 0.0F);
			ASSERT_LT(value, 1.0F);
			++tenth[static_cast<std::size_t>(value * 10.0F)];
			alike += noiseOfBlob(noiseKey(5, 5), u + 1, v, 6.0F) == value ? 1 : 0;
		}
	for (const int count : tenth) EXPECT_NEAR(count / (1.0 * kSide * kSide), 0.1, 0.02);
	EXPECT_GT(alike / (1.0 * kSide * kSide), 0.75);
	EXPECT_LT(alike / (1.0 * kSide * kSide), 0.95);
}
}  // namespace
}  // namespace explore::simulation

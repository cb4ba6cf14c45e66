#include <explore/simulation/noise_random.h>
#include <explore/simulation/speckle_pattern.h>

#include <cmath>
#include <cstddef>

namespace explore::simulation
{
namespace
{
constexpr int kFiner = 4;  ///< samples a pixel along a row
constexpr int kSamples = SpecklePattern::kColumns_px * kFiner;
constexpr int kCellColumns = 160, kCellRows = 40;  ///< at most one dot in each: about one dot on ten pixels
constexpr float kFilled = 0.9F;
constexpr float kDotSigma_px = 0.75F;
constexpr std::uint64_t kFactorySeed = 0x51ec41e5;

int wrapped(int i, int period)
{
	const int rest = i % period;
	return rest < 0 ? rest + period : rest;
}
}  // namespace

SpecklePattern::SpecklePattern() : m_samples(static_cast<std::size_t>(kSamples) * kRows_px)
{
	const NoiseKey present = noiseKey(kFactorySeed, 0), across = noiseKey(kFactorySeed, 1);
	const NoiseKey down = noiseKey(kFactorySeed, 2), bright = noiseKey(kFactorySeed, 3);
	for (int i = 0; i < kCellColumns * kCellRows; ++i)
	{
		const auto cell = static_cast<std::uint32_t>(i);
		if (noiseUniform(present, cell) > kFilled) continue;
		const int cell_column = i % kCellColumns, cell_row = i / kCellColumns;
		const float column = (static_cast<float>(cell_column) + noiseUniform(across, cell)) / kCellColumns;
		const float row = (static_cast<float>(cell_row) + noiseUniform(down, cell)) / kCellRows;
		addDot(column * kColumns_px, row * kRows_px, 0.6F + 0.4F * noiseUniform(bright, cell));
	}
}

void SpecklePattern::addDot(float column_px, float row_px, float peak)
{
	constexpr int kReach_px = 4;
	const int middle = static_cast<int>(column_px * kFiner), row = static_cast<int>(row_px);
	for (int v = row - kReach_px; v <= row + kReach_px; ++v)
		for (int s = middle - kReach_px * kFiner; s <= middle + kReach_px * kFiner; ++s)
		{
			const double du = static_cast<double>(s) / kFiner - static_cast<double>(column_px);
			const double dv = v - static_cast<double>(row_px);
			const double fall = std::exp(-(du * du + dv * dv) / (2.0 * kDotSigma_px * kDotSigma_px));
			m_samples[static_cast<std::size_t>(wrapped(v, kRows_px)) * kSamples +
			          static_cast<std::size_t>(wrapped(s, kSamples))] += peak * static_cast<float>(fall);
		}
}

float SpecklePattern::brightness(float column_px, int row_px) const
{
	const float at = column_px * kFiner, below = std::floor(at);
	const int sample = wrapped(static_cast<int>(below), kSamples);
	const float* row = &m_samples[static_cast<std::size_t>(wrapped(row_px, kRows_px)) * kSamples];
	const float first = row[sample], second = row[sample + 1 == kSamples ? 0 : sample + 1];
	return first + (at - below) * (second - first);
}

const SpecklePattern& specklePattern()
{
	static const SpecklePattern pattern;
	return pattern;
}
}  // namespace explore::simulation

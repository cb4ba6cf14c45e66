#include <explore/core/vector_code.h>
#include <explore/simulation/noise_random.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace explore::simulation
{
namespace
{
std::uint64_t splitMix(std::uint64_t x)
{
	x += 0x9e3779b97f4a7c15ULL;
	x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
	x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
	return x ^ (x >> 31);
}

/** ln(x) for a normal x > 0, within 2e-7 of its value: 2 artanh((m − 1)/(m + 1)) of the mantissa m in [√½, √2). */
[[gnu::always_inline]] inline float fastLog(float x)
{
	constexpr std::int32_t kRootHalf = 0x3f3504f3;
	const auto bits = std::bit_cast<std::int32_t>(x);
	const std::int32_t exponent = (bits - kRootHalf) >> 23;
	const auto m = std::bit_cast<float>(bits - (exponent << 23));
	const float s = (m - 1.0F) / (m + 1.0F), q = s * s;
	const float series = s * (2.0F + q * (0.66666667F + q * (0.4F + q * 0.28571429F)));
	return static_cast<float>(exponent) * 0.69314718F + series;
}

/** sin(2πx) for x in [−¼, ¼], within 1e-7. */
[[gnu::always_inline]] inline float sineOfTurns(float x)
{
	const float a = 6.2831853F * x, q = a * a;
	return a * (1.0F +
	            q * (-1.0F / 6 + q * (1.0F / 120 + q * (-1.0F / 5040 + q * (1.0F / 362880 - q * (1.0F / 39916800))))));
}

[[gnu::always_inline]] inline void boxMuller(NoiseKey key, std::uint32_t first, std::size_t pairs, float* cosines,
                                             float* sines)
{
	for (std::size_t i = 0; i < pairs; ++i)
	{
		const std::uint32_t counter = (first + static_cast<std::uint32_t>(i)) * 2U;
		const float radius = std::sqrt(-2.0F * fastLog(noiseUniform(key, counter)));
		const float turn = noiseUniform(key, counter + 1U) - 0.5F, folded = std::abs(turn);
		cosines[i] = radius * sineOfTurns(0.25F - folded);
		sines[i] = radius * sineOfTurns(folded > 0.25F ? std::copysign(0.5F - folded, turn) : turn);
	}
}

EXPLORE_VECTOR_CODE(boxMullerRows, boxMuller,
                    (NoiseKey key, std::uint32_t first, std::size_t pairs, float* cosines, float* sines),
                    (key, first, pairs, cosines, sines))
}  // namespace

NoiseKey noiseKey(std::uint64_t seed, std::uint64_t stream)
{
	const std::uint64_t key = splitMix(splitMix(seed) ^ stream);
	return {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)};
}

void fillGaussian(NoiseKey key, std::uint32_t first, std::span<float> out)
{
	const std::size_t pairs = out.size() / 2;
	boxMullerRows(key, first, pairs, out.data(), out.data() + pairs);
	if (out.size() % 2 == 0) return;
	float unused = 0.0F;
	boxMullerRows(key, first + static_cast<std::uint32_t>(pairs), 1, &out.back(), &unused);
}

float noiseOfBlob(NoiseKey key, int u_px, int v_px, float size_px)
{
	const float u = static_cast<float>(u_px) / size_px, v = static_cast<float>(v_px) / size_px;
	const int column = static_cast<int>(u), row = static_cast<int>(v);
	float nearest = std::numeric_limits<float>::infinity();
	std::uint32_t owner = 0;
	for (int j = row - 1; j <= row + 1; ++j)
		for (int i = column - 1; i <= column + 1; ++i)
		{
			// One point somewhere in each cell of a grid; a pixel belongs to the nearest.
			const std::uint32_t cell = (static_cast<std::uint32_t>(j + 1) << 16) + static_cast<std::uint32_t>(i + 1);
			const std::uint32_t place = noiseBits(key, cell);
			const float du = static_cast<float>(i) + static_cast<float>(place & 0xffffU) * 0x1p-16F - u;
			const float dv = static_cast<float>(j) + static_cast<float>(place >> 16) * 0x1p-16F - v;
			const float distance = du * du + dv * dv;
			if (distance >= nearest) continue;
			nearest = distance;
			owner = cell;
		}
	return noiseUniform({key.b, ~key.a}, owner);
}
}  // namespace explore::simulation

// Random numbers for images: each is a function of a key and a counter, so that pixels may be worked on in any order.
#pragma once

#include <cstdint>
#include <span>

namespace explore::simulation
{
/** One independent sequence. */
struct NoiseKey
{
	std::uint32_t a = 0, b = 0;
};

/** The sequence `stream` of the shot with `seed`. */
NoiseKey noiseKey(std::uint64_t seed, std::uint64_t stream);

/** 32 random bits. */
[[gnu::always_inline]] inline std::uint32_t noiseBits(NoiseKey key, std::uint32_t counter)
{
	// Twice an integer finaliser (xor-shift and odd multipliers), keyed before and between.
	std::uint32_t x = counter ^ key.a;
	x = (x ^ (x >> 16)) * 0x7feb352dU;
	x = (x ^ (x >> 15)) * 0x846ca68bU;
	x = (x ^ (x >> 16)) + key.b;
	x = (x ^ (x >> 16)) * 0x7feb352dU;
	x = (x ^ (x >> 15)) * 0x846ca68bU;
	return x ^ (x >> 16);
}

/** Uniform in (0, 1). */
[[gnu::always_inline]] inline float noiseUniform(NoiseKey key, std::uint32_t counter)
{
	return (static_cast<float>(static_cast<std::int32_t>(noiseBits(key, counter) >> 9)) + 0.5F) * 0x1p-23F;
}

/** Fills `out` with numbers of mean 0 and sigma 1 (|x| < 5.8) from counters first … first + ⌈size/2⌉ − 1, by Box and
 *  Muller's method with polynomials for the logarithm and the sine. The same bits on every processor that adds and
 *  multiplies floats as IEEE 754 says. */
void fillGaussian(NoiseKey key, std::uint32_t first, std::span<float> out);

/** Uniform in (0, 1), the same for all pixels of a cell of about `size_px` × `size_px` with a random outline. */
float noiseOfBlob(NoiseKey key, int u_px, int v_px, float size_px);
}  // namespace explore::simulation

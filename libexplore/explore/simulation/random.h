// Random numbers that are the same with every compiler, library and machine.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace explore::simulation
{
/** One well-mixed number of several; their order counts. */
[[nodiscard]] std::uint64_t mixed(std::initializer_list<std::uint64_t> numbers);
/** FNV-1a. */
[[nodiscard]] std::uint64_t hashOf(std::string_view text);

/** splitmix64 (Steele, Lea, Flood 2014): a counter and a mixer, so that every seed is as good as any other. */
class Random
{
public:
	explicit Random(std::uint64_t seed) : m_state(seed) {}

	std::uint64_t next();
	/** In [low, high). */
	double uniform(double low, double high);
	/** In low … high, both included. */
	int integer(int low, int high);
	bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
	/** −1 or 1. */
	double sign() { return chance(0.5) ? 1.0 : -1.0; }
	/** Mean 0, within ±6 sigma: the sum of twelve uniform numbers, which needs no library function. */
	double gaussian(double sigma);

private:
	std::uint64_t m_state;
};
}  // namespace explore::simulation

#include "random.h"

namespace explore::simulation
{
namespace
{
constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ULL;

std::uint64_t mix(std::uint64_t value)
{
	value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
	value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
	return value ^ (value >> 31);
}
}  // namespace

std::uint64_t mixed(std::initializer_list<std::uint64_t> numbers)
{
	std::uint64_t state = 0;
	for (const std::uint64_t number : numbers) state = mix(state + kStep + mix(number + kStep));
	return state;
}

std::uint64_t hashOf(std::string_view text)
{
	std::uint64_t hash = 0xcbf29ce484222325ULL;
	for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
	return hash;
}

std::uint64_t Random::next()
{
	m_state += kStep;
	return mix(m_state);
}

double Random::uniform(double low, double high)
{
	return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1.0p-53);
}

int Random::integer(int low, int high)
{
	const auto count = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
	return low + static_cast<int>(next() % count);
}

double Random::gaussian(double sigma)
{
	double sum = -6.0;
	for (int i = 0; i < 12; ++i) sum += uniform(0.0, 1.0);
	return sigma * sum;
}
}  // namespace explore::simulation

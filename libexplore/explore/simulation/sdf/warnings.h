// Collects what was left out or mended while a world is loaded.
#pragma once

#include <string>
#include <vector>

namespace explore::simulation
{
/** Equal warnings are counted, and very many different ones are cut off, so that a broken world stays readable. */
class Warnings
{
public:
	void add(const std::string& message);
	/** In the order of their first occurrence, "… (3 times)". */
	[[nodiscard]] std::vector<std::string> list() const;

private:
	struct Entry
	{
		std::string message;
		std::size_t count = 1;
	};
	std::vector<Entry> m_entries;
	std::size_t m_left_out = 0;
};
}  // namespace explore::simulation

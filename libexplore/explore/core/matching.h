// One-to-one matching of what was seen with what is known: the pairs that are the least apart as a whole.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace explore
{
/** Distances between rows and columns; no value: the two must not be paired. */
class DistanceTable
{
public:
	DistanceTable(std::size_t rows, std::size_t columns) : m_columns(columns), m_rows(rows), m_values(rows * columns) {}

	[[nodiscard]] std::size_t rows() const { return m_rows; }
	[[nodiscard]] std::size_t columns() const { return m_columns; }
	[[nodiscard]] const std::optional<double>& at(std::size_t row, std::size_t column) const
	{
		return m_values[row * m_columns + column];
	}
	/** `distance` from 0 to 100. */
	void allow(std::size_t row, std::size_t column, double distance) { m_values[row * m_columns + column] = distance; }

private:
	std::size_t m_columns, m_rows;
	std::vector<std::optional<double>> m_values;
};

/** Dearer than all allowed pairs together, so that one more pair is always worth it. */
inline constexpr double kAsManyPairsAsCanBe = 1e6;

/** The column of each row, or no value, such that the sum of the pairs' distances, and of `unpaired` for each pair
 * fewer than there are rows or columns, is the least (the Hungarian method). By default the number of pairs is the
 * largest possible and, among those, the sum of distances the least. With a smaller value a near pair is not broken up
 * to make two that are farther. */
std::vector<std::optional<std::size_t>> bestMatching(const DistanceTable& distances,
                                                     double unpaired = kAsManyPairsAsCanBe);
}  // namespace explore

// One-to-one matching of reports with true doors: as many pairs as can be, then the nearest.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace explore::evaluation
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

/** The column of each row, or no value, such that the number of pairs is the largest possible and, among those, the
 *  sum of distances the least (the Hungarian method). */
std::vector<std::optional<std::size_t>> bestMatching(const DistanceTable& distances);
}  // namespace explore::evaluation

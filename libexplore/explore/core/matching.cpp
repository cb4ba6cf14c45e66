#include <explore/core/matching.h>

#include <algorithm>
#include <limits>

namespace explore
{
namespace
{
constexpr std::size_t kNone = 0;

/** Kuhn–Munkres with potentials on the square table, rows and columns counted from 1, 0 = none. */
class Hungarian
{
public:
	Hungarian(const DistanceTable& distances, double unpaired)
	    : m_distances(distances),
	      m_unpaired(unpaired),
	      m_size(std::max(distances.rows(), distances.columns())),
	      m_row_potential(m_size + 1),
	      m_column_potential(m_size + 1),
	      m_row_of(m_size + 1, kNone)
	{
		for (std::size_t row = 1; row <= m_size; ++row) place(row);
	}
	[[nodiscard]] std::size_t rowOf(std::size_t column) const { return m_row_of[column]; }
	[[nodiscard]] std::size_t size() const { return m_size; }

private:
	[[nodiscard]] double costOf(std::size_t row, std::size_t column) const
	{
		if (row >= m_distances.rows() || column >= m_distances.columns()) return m_unpaired;
		return std::min(m_distances.at(row, column).value_or(m_unpaired), m_unpaired);
	}

	/** Gives `row` a column along the cheapest chain of changes. */
	void place(std::size_t row)
	{
		m_row_of[0] = row;
		m_slack.assign(m_size + 1, std::numeric_limits<double>::infinity());
		m_from.assign(m_size + 1, 0);
		m_seen.assign(m_size + 1, false);
		std::size_t column = 0;
		do column = nextColumn(column);
		while (m_row_of[column] != kNone);
		for (; column != 0; column = m_from[column]) m_row_of[column] = m_row_of[m_from[column]];
	}

	std::size_t nextColumn(std::size_t column)
	{
		m_seen[column] = true;
		const std::size_t row = m_row_of[column];
		std::size_t nearest = 0;
		for (std::size_t j = 1; j <= m_size; ++j)
		{
			if (m_seen[j]) continue;
			const double cost = costOf(row - 1, j - 1) - m_row_potential[row] - m_column_potential[j];
			if (cost < m_slack[j])
			{
				m_slack[j] = cost;
				m_from[j] = column;
			}
			if (nearest == 0 || m_slack[j] < m_slack[nearest]) nearest = j;
		}
		shiftPotentials(m_slack[nearest]);
		return nearest;
	}

	void shiftPotentials(double by)
	{
		for (std::size_t j = 0; j <= m_size; ++j)
			if (m_seen[j])
			{
				m_row_potential[m_row_of[j]] += by;
				m_column_potential[j] -= by;
			}
			else
				m_slack[j] -= by;
	}

	const DistanceTable& m_distances;
	double m_unpaired;
	std::size_t m_size;
	std::vector<double> m_row_potential, m_column_potential;
	std::vector<std::size_t> m_row_of;  ///< by column
	std::vector<double> m_slack;
	std::vector<std::size_t> m_from;
	std::vector<bool> m_seen;
};
}  // namespace

std::vector<std::optional<std::size_t>> bestMatching(const DistanceTable& distances, double unpaired)
{
	std::vector<std::optional<std::size_t>> columns(distances.rows());
	if (distances.rows() == 0 || distances.columns() == 0) return columns;
	const Hungarian matching(distances, unpaired);
	for (std::size_t column = 0; column < distances.columns(); ++column)
	{
		const std::size_t row = matching.rowOf(column + 1) - 1;
		if (row < distances.rows() && distances.at(row, column).value_or(unpaired) < unpaired) columns[row] = column;
	}
	return columns;
}
}  // namespace explore

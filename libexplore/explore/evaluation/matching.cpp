#include <explore/evaluation/matching.h>

#include <algorithm>
#include <limits>

namespace explore::evaluation
{
namespace
{
/** Dearer than all allowed pairs together, so that one more pair is always worth it. */
constexpr double kUnpaired = 1e6;
constexpr std::size_t kNone = 0;

double costOf(const DistanceTable& distances, std::size_t row, std::size_t column)
{
	if (row >= distances.rows() || column >= distances.columns()) return kUnpaired;
	return distances.at(row, column).value_or(kUnpaired);
}

/** Kuhn–Munkres with potentials on the square table, rows and columns counted from 1, 0 = none. */
class Hungarian
{
public:
	explicit Hungarian(const DistanceTable& distances)
	    : m_distances(distances),
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
			const double cost = costOf(m_distances, row - 1, j - 1) - m_row_potential[row] - m_column_potential[j];
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
	std::size_t m_size;
	std::vector<double> m_row_potential, m_column_potential;
	std::vector<std::size_t> m_row_of;  ///< by column
	std::vector<double> m_slack;
	std::vector<std::size_t> m_from;
	std::vector<bool> m_seen;
};
}  // namespace

std::vector<std::optional<std::size_t>> bestMatching(const DistanceTable& distances)
{
	std::vector<std::optional<std::size_t>> columns(distances.rows());
	if (distances.rows() == 0 || distances.columns() == 0) return columns;
	const Hungarian matching(distances);
	for (std::size_t column = 0; column < distances.columns(); ++column)
	{
		const std::size_t row = matching.rowOf(column + 1) - 1;
		if (row < distances.rows() && distances.at(row, column)) columns[row] = column;
	}
	return columns;
}
}  // namespace explore::evaluation

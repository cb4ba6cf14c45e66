#include <explore/core/vector_code.h>
#include <explore/simulation/parallel_rows.h>
#include <explore/simulation/speckle_contrast.h>
#include <explore/simulation/speckle_match.h>
#include <explore/simulation/speckle_pattern.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <limits>

namespace explore::simulation
{
namespace
{
constexpr float kLeastSigma = 4.5F;  ///< counts: a block without projected light shows the sensor's noise only
constexpr float kUnrelated = 2.0F * kLevelsPerSigma * kLevelsPerSigma * kBlock_px * kBlock_px;  ///< mean cost by chance
constexpr float kWorstFit = 0.45F;                                                              ///< of kUnrelated
constexpr float kUniqueness = 0.75F;  ///< the best cost is at most this share of the next best elsewhere
constexpr int kBeside_px = 2;         ///< disparities that near belong to the same minimum
constexpr std::uint16_t kWorst = std::numeric_limits<std::uint16_t>::max();

/** Adds to the sums of columns what the row entering the block differs, and takes away what the row leaving it does. */
[[gnu::always_inline]] inline void rollColumns(std::size_t count, const std::uint8_t* seen_in,
                                               const std::uint8_t* pattern_in, const std::uint8_t* seen_out,
                                               const std::uint8_t* pattern_out, std::uint16_t* sums)
{
	for (std::size_t u = 0; u < count; ++u)
	{
		const auto in = static_cast<std::int16_t>(seen_in[u] - pattern_in[u]);
		const auto out = static_cast<std::int16_t>(seen_out[u] - pattern_out[u]);
		sums[u] = static_cast<std::uint16_t>(sums[u] + in * in - out * out);
	}
}

EXPLORE_VECTOR_CODE(rollColumnSums, rollColumns,
                    (std::size_t count, const std::uint8_t* seen_in, const std::uint8_t* pattern_in,
                     const std::uint8_t* seen_out, const std::uint8_t* pattern_out, std::uint16_t* sums),
                    (count, seen_in, pattern_in, seen_out, pattern_out, sums))

[[gnu::always_inline]] inline void addBlocks(std::size_t count, const std::uint16_t* sums, std::uint16_t* cost)
{
	static_assert(kBlock_px == 9);
	for (std::size_t u = 0; u < count; ++u)
		cost[u] = static_cast<std::uint16_t>(sums[u] + sums[u + 1] + sums[u + 2] + sums[u + 3] + sums[u + 4] +
		                                     sums[u + 5] + sums[u + 6] + sums[u + 7] + sums[u + 8]);
}

EXPLORE_VECTOR_CODE(addBlockCosts, addBlocks, (std::size_t count, const std::uint16_t* sums, std::uint16_t* cost),
                    (count, sums, cost))

[[gnu::always_inline]] inline void keepBest(std::size_t count, std::uint16_t disparity, const std::uint16_t* cost,
                                            std::uint16_t* best, std::uint16_t* where)
{
	for (std::size_t u = 0; u < count; ++u)
	{
		const bool better = cost[u] < best[u];
		best[u] = better ? cost[u] : best[u];
		where[u] = better ? disparity : where[u];
	}
}

EXPLORE_VECTOR_CODE(keepBestCost, keepBest,
                    (std::size_t count, std::uint16_t disparity, const std::uint16_t* cost, std::uint16_t* best,
                     std::uint16_t* where),
                    (count, disparity, cost, best, where))

/** The best cost farther than kBeside_px from the best place. */
[[gnu::always_inline]] inline void keepNext(std::size_t count, std::uint16_t disparity, const std::uint16_t* cost,
                                            const std::uint16_t* where, std::uint16_t* next)
{
	for (std::size_t u = 0; u < count; ++u)
	{
		const auto apart = static_cast<std::uint16_t>(disparity - where[u] + kBeside_px);
		const std::uint16_t candidate = apart > 2 * kBeside_px ? cost[u] : kWorst;
		next[u] = candidate < next[u] ? candidate : next[u];
	}
}

EXPLORE_VECTOR_CODE(keepNextCost, keepNext,
                    (std::size_t count, std::uint16_t disparity, const std::uint16_t* cost, const std::uint16_t* where,
                     std::uint16_t* next),
                    (count, disparity, cost, where, next))

/** The contrast of the pattern: row r (of the tile) at columns −most … width − 1 − least. */
std::vector<std::uint8_t> referenceRows(const SpeckleSearch& search)
{
	constexpr int kMargin_px = kHalfBlock_px;
	const int columns = search.width_px + search.most_px, rows = SpecklePattern::kRows_px;
	const int width = columns + 2 * kMargin_px, height = rows + 2 * kMargin_px;
	std::vector<std::uint16_t> picture;
	picture.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
	for (int v = 0; v < height; ++v)
		for (int u = 0; u < width; ++u)
			picture.push_back(static_cast<std::uint16_t>(
			    1000.0F *
			    specklePattern().brightness(static_cast<float>(u - kMargin_px - search.most_px), v - kMargin_px)));
	const ContrastImage contrast = contrastOf(picture, width, height, search.threads);
	std::vector<std::uint8_t> reference;
	reference.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
	for (int v = 0; v < rows; ++v)
	{
		const auto row = contrast.level.begin() + (v + kMargin_px) * width + kMargin_px;
		reference.insert(reference.end(), row, row + columns);
	}
	return reference;
}

class Matcher
{
public:
	Matcher(const ContrastImage& seen, const SpeckleSearch& search)
	    : m_seen(seen),
	      m_search(search),
	      m_width(static_cast<std::size_t>(search.width_px)),
	      m_reference_width(static_cast<std::size_t>(search.width_px + search.most_px)),
	      m_reference(referenceRows(search))
	{
	}

	void matchRows(int first, int last, std::vector<float>& disparity) const;

private:
	struct Costs;
	void roll(Costs& costs, int v) const;
	void decide(Costs& costs, int v, std::vector<float>& disparity) const;
	/** The pattern's row `v` such that index u is column u − `disparity`. */
	[[nodiscard]] const std::uint8_t* pattern(int v, int disparity) const
	{
		return &m_reference[static_cast<std::size_t>(v % SpecklePattern::kRows_px) * m_reference_width +
		                    static_cast<std::size_t>(m_search.most_px - disparity)];
	}

	const ContrastImage& m_seen;
	const SpeckleSearch& m_search;
	std::size_t m_width, m_reference_width;
	std::vector<std::uint8_t> m_reference;
};

/** Of one row: for each disparity a row of sums over columns of the block, and of whole blocks. */
struct Matcher::Costs
{
	Costs(std::size_t disparities, std::size_t the_width)
	    : width(the_width),
	      sums(disparities * the_width),
	      block(disparities * the_width),
	      best(the_width),
	      where(the_width),
	      next(the_width)
	{
	}
	[[nodiscard]] std::uint16_t* sumsOf(std::size_t d) { return &sums[d * width]; }
	[[nodiscard]] std::uint16_t* blockOf(std::size_t d) { return &block[d * width]; }

	std::size_t width;
	std::vector<std::uint16_t> sums, block, best, where, next;
	int rows_in = 0;
};

/** Lets row `v` into the block, and out the one a block's height above it. */
void Matcher::roll(Costs& costs, int v) const
{
	const bool full = costs.rows_in == kBlock_px;
	const int leaving = v - kBlock_px;
	const std::vector<std::uint8_t> nothing(m_width, 0);
	for (int d = m_search.least_px; d <= m_search.most_px; ++d)
		rollColumnSums(m_width, &m_seen.level[static_cast<std::size_t>(v) * m_width], pattern(v, d),
		               full ? &m_seen.level[static_cast<std::size_t>(leaving) * m_width] : nothing.data(),
		               full ? pattern(leaving, d) : nothing.data(),
		               costs.sumsOf(static_cast<std::size_t>(d - m_search.least_px)));
	if (!full) ++costs.rows_in;
}

/** Index i of the cost rows is the block whose first column is i. */
void Matcher::decide(Costs& costs, int v, std::vector<float>& disparity) const
{
	const std::size_t blocks = m_width - kBlock_px + 1;
	const auto last = static_cast<std::size_t>(m_search.most_px - m_search.least_px);
	std::fill(costs.best.begin(), costs.best.end(), kWorst);
	std::fill(costs.next.begin(), costs.next.end(), kWorst);
	for (std::size_t d = 0; d <= last; ++d)
	{
		addBlockCosts(blocks, costs.sumsOf(d), costs.blockOf(d));
		keepBestCost(blocks, static_cast<std::uint16_t>(d), costs.blockOf(d), costs.best.data(), costs.where.data());
	}
	for (std::size_t d = 0; d <= last; ++d)
		keepNextCost(blocks, static_cast<std::uint16_t>(d), costs.blockOf(d), costs.where.data(), costs.next.data());

	const std::size_t row = static_cast<std::size_t>(v) * m_width + kHalfBlock_px;
	for (std::size_t i = 0; i < blocks; ++i)
	{
		const std::size_t d = costs.where[i];
		const float best = costs.best[i];
		if (m_seen.sigma[row + i] < kLeastSigma || d == 0 || d == last) continue;
		if (best > kWorstFit * kUnrelated || best > kUniqueness * static_cast<float>(costs.next[i])) continue;
		const float before = costs.blockOf(d - 1)[i], after = costs.blockOf(d + 1)[i];
		const float bend = before - 2.0F * best + after;
		const float fraction = bend > 0.0F ? 0.5F * (before - after) / bend : 0.0F;
		disparity[row + i] = static_cast<float>(static_cast<int>(d) + m_search.least_px) + fraction;
	}
}

void Matcher::matchRows(int first, int last, std::vector<float>& disparity) const
{
	Costs costs(static_cast<std::size_t>(m_search.most_px - m_search.least_px + 1), m_width);
	for (int v = first - kHalfBlock_px; v < first + kHalfBlock_px; ++v) roll(costs, v);
	for (int v = first; v < last; ++v)
	{
		roll(costs, v + kHalfBlock_px);
		decide(costs, v, disparity);
	}
}
}  // namespace

std::vector<float> matchSpeckles(const std::vector<std::uint16_t>& infrared, const SpeckleSearch& search)
{
	std::vector<float> disparity(infrared.size());
	if (search.width_px < kBlock_px || search.height_px < kBlock_px) return disparity;
	const ContrastImage seen = contrastOf(infrared, search.width_px, search.height_px, search.threads);
	const Matcher matcher(seen, search);
	parallelRows(search.height_px - 2 * kHalfBlock_px, 16, search.threads,
	             [&](int first, int last)
	             { matcher.matchRows(first + kHalfBlock_px, last + kHalfBlock_px, disparity); });
	return disparity;
}
}  // namespace explore::simulation

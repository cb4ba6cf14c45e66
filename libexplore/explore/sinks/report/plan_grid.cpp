#include <explore/sinks/report/plan_grid.h>

#include <algorithm>
#include <stdexcept>

namespace explore
{
namespace
{
PlanCell planCellOf(const FrontierMemory& memory, std::size_t cell)
{
	switch (memory.layers.cells()[cell])
	{
		case CellState::free:
			return memory.frontiers.isFrontier(cell) ? PlanCell::frontier : PlanCell::free;
		case CellState::occupied:
			return PlanCell::occupied;
		case CellState::drop:
			return PlanCell::drop;
		case CellState::unknown:
			break;
	}
	return PlanCell::unknown;
}

int rankOf(PlanCell cell)
{
	switch (cell)
	{
		case PlanCell::frontier:
			return 4;
		case PlanCell::free:
			return 3;
		case PlanCell::drop:
			return 2;
		case PlanCell::occupied:
			return 1;
		case PlanCell::unknown:
			break;
	}
	return 0;
}

/** `from` in the place and size of `to`. */
PlanGrid movedInto(const PlanGrid& from, const PlanGrid& to)
{
	PlanGrid moved = to;
	moved.cells.assign(static_cast<std::size_t>(to.columns) * static_cast<std::size_t>(to.rows), PlanCell::unknown);
	const int right = from.first_x - to.first_x, up = from.first_y - to.first_y;
	if (from.cells.empty()) return moved;
	if (right < 0 || up < 0 || right + from.columns > to.columns || up + from.rows > to.rows)
		throw std::invalid_argument("a plan that does not cover the one before it");
	for (int row = 0; row < from.rows; ++row)
		std::copy_n(from.cells.begin() + static_cast<std::ptrdiff_t>(row) * from.columns, from.columns,
		            moved.cells.begin() + static_cast<std::ptrdiff_t>(row + up) * to.columns + right);
	return moved;
}

void append(std::string& bytes, std::size_t number)
{
	for (; number >= 128; number >>= 7U) bytes += static_cast<char>((number & 127U) | 128U);
	bytes += static_cast<char>(number);
}

std::size_t take(const std::string& bytes, std::size_t& at)
{
	std::size_t number = 0;
	for (unsigned shift = 0; at < bytes.size() && shift < 56; shift += 7)
	{
		const auto byte = static_cast<unsigned char>(bytes[at++]);
		number |= static_cast<std::size_t>(byte & 127U) << shift;
		if (byte < 128) return number;
	}
	throw std::invalid_argument("changes of a plan that break off");
}
}  // namespace

PlanGrid planGridOf(const FrontierMemory& memory)
{
	const LayerFrame& frame = memory.layers.frame();
	PlanGrid grid{frame.resolution_m, frame.first.x(), frame.first.y(), frame.columns, frame.rows, {}};
	const std::size_t in_layer = frame.cellsInLayer(), all = memory.layers.cells().size();
	grid.cells.assign(in_layer, PlanCell::unknown);
	for (std::size_t begin = 0; begin + in_layer <= all && in_layer > 0; begin += in_layer)
		for (std::size_t cell = 0; cell < in_layer; ++cell)
		{
			const PlanCell found = planCellOf(memory, begin + cell);
			if (rankOf(found) > rankOf(grid.cells[cell])) grid.cells[cell] = found;
		}
	return grid;
}

std::string planChanges(const PlanGrid& from, const PlanGrid& to)
{
	const PlanGrid before = movedInto(from, to);
	std::string changes;
	std::size_t same_since = 0;
	for (std::size_t cell = 0; cell < to.cells.size();)
	{
		if (to.cells[cell] == before.cells[cell])
		{
			++cell;
			continue;
		}
		const std::size_t begin = cell;
		while (cell < to.cells.size() && to.cells[cell] == to.cells[begin] && to.cells[cell] != before.cells[cell])
			++cell;
		append(changes, begin - same_since);
		append(changes, 8 * (cell - begin) + static_cast<std::size_t>(to.cells[begin]));
		same_since = cell;
	}
	return changes;
}

void applyPlanChanges(const PlanGrid& from, const std::string& changes, PlanGrid& to)
{
	to.cells = movedInto(from, to).cells;
	std::size_t cell = 0;
	for (std::size_t at = 0; at < changes.size();)
	{
		cell += take(changes, at);
		const std::size_t next = take(changes, at), count = next / 8, state = next % 8;
		if (state > static_cast<std::size_t>(PlanCell::frontier) || cell > to.cells.size() ||
		    count > to.cells.size() - cell)
			throw std::invalid_argument("changes beyond a plan's edge");
		std::fill_n(to.cells.begin() + static_cast<std::ptrdiff_t>(cell), count, static_cast<PlanCell>(state));
		cell += count;
	}
}
}  // namespace explore

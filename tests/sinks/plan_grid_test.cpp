#include <explore/sinks/report/plan_grid.h>
#include <explore/sinks/report/plan_record.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

using namespace explore;

namespace
{
PlanGrid gridOf(int first_x, int first_y, int columns, int rows)
{
	return {0.05,    first_x,
	        first_y, columns,
	        rows,    std::vector<PlanCell>(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))};
}

/** Draws some rectangles into it. */
void scribble(PlanGrid& grid, std::mt19937& random)
{
	const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
	for (int i = 0; i < 5; ++i)
	{
		const int left = below(grid.columns), right = left + below(grid.columns - left);
		const int low = below(grid.rows), high = low + below(grid.rows - low);
		const auto state = static_cast<PlanCell>(below(5));
		for (int row = low; row <= high; ++row)
			for (int column = left; column <= right; ++column)
				grid.cells[static_cast<std::size_t>(row * grid.columns + column)] = state;
	}
}
}  // namespace

TEST(PlanGrid, ChangesLeadFromAnyGridToALaterOne)
{
	std::mt19937 random(5);
	PlanGrid before;
	for (int round = 0; round < 60; ++round)
	{
		const int grow = static_cast<int>(random() % 3);
		PlanGrid after = gridOf(before.first_x - grow, before.first_y - 2 * grow, before.columns + 3 * grow + 1,
		                        before.rows + 2 * grow + 1);
		applyPlanChanges(before, "", after);
		scribble(after, random);
		PlanGrid told = gridOf(after.first_x, after.first_y, after.columns, after.rows);
		applyPlanChanges(before, planChanges(before, after), told);
		ASSERT_EQ(told, after) << round;
		EXPECT_EQ(planChanges(after, after), "");
		before = after;
	}
}

TEST(PlanGrid, OneThatDoesNotCoverTheOneBeforeIsRefused)
{
	EXPECT_THROW(planChanges(gridOf(0, 0, 3, 3), gridOf(1, 0, 3, 3)), std::invalid_argument);
	EXPECT_THROW(planChanges(gridOf(0, 0, 3, 3), gridOf(0, 0, 3, 2)), std::invalid_argument);
}

TEST(PlanGrid, DamagedChangesAreRefused)
{
	const PlanGrid from = gridOf(0, 0, 4, 4);
	for (const std::string& damaged : {std::string("\x80"), std::string("\x01"), std::string("\x11\x09"),
	                                   std::string("\x02\x7F\x01"), std::string(1, '\0') + "\x0F"})
	{
		PlanGrid to = gridOf(0, 0, 4, 4);
		EXPECT_THROW(applyPlanChanges(from, damaged, to), std::invalid_argument);
	}
}

TEST(PlanRecord, TakesASnapshotOn)
{
	PlanSnapshot before, after;
	before.grid = gridOf(-2, -2, 4, 4);
	before.doors[1] = Json::array({0.5, 1.0, 0.1, 0.9, "open", 0.8, false});
	before.doors[2] = Json::array({2.5, 1.0, 0.1, 0.9, "closed", 0.1, false});
	before.corridors[1] = Json::array({0, 0, 5, 0, nullptr});
	after = before;
	after.grid.cells[5] = PlanCell::free;
	after.doors[1][6] = true;
	after.doors.erase(2);
	after.doors[7] = Json::array({9.5, 1.0, 0.1, 0.9, "ajar", 0.5, false});
	after.corridors.clear();
	after.known_free_m2 = 12.25;
	after.coverage = 0.5;
	const std::string record = planRecord(before, after, {40, 4.0});
	PlanSnapshot told = before;
	const PlanTime time = applyPlanRecord(record, told);
	EXPECT_EQ(time.frame, 40U);
	EXPECT_EQ(time.t_s, 4.0);
	EXPECT_EQ(told.grid, after.grid);
	EXPECT_EQ(told.doors, after.doors);
	EXPECT_TRUE(told.corridors.empty());
	EXPECT_EQ(told.known_free_m2, 12.25);
	EXPECT_EQ(told.coverage, 0.5);
	EXPECT_EQ(record.find("\"closed\""), std::string::npos) << "what is gone is not told again";
}

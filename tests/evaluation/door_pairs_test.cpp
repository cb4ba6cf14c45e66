#include "evaluation/truth_maker.h"

#include <explore/evaluation/door_pairs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace explore;
using namespace explore::evaluation;

namespace
{
Door reported(double x_m, double y_m, double width_m, Verdict verdict = Verdict::open)
{
	Door door;
	door.center = {x_m, y_m, 1.0};
	door.normal = -Eigen::Vector3d::UnitX();
	door.width_m = door.clear_width_m = width_m;
	door.verdict = verdict;
	return door;
}

struct Counts
{
	int hits, misses, false_alarms, ignored;
	bool operator==(const Counts&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Counts& c)
{
	return out << c.hits << " hits, " << c.misses << " misses, " << c.false_alarms << " false alarms, " << c.ignored
	           << " ignored";
}

Counts count(const std::vector<Door>& doors, const std::vector<TruthDoor>& truth, double tolerance_m = 0.30)
{
	const auto reports = reportsOf(doors, {}, RobotConfig());
	const auto pairs = pairDoors(reports, truth, tolerance_m);
	std::multiset<std::size_t> report_places, truth_places;
	Counts counts{};
	for (const DoorPair& pair : pairs)
	{
		if (pair.report) report_places.insert(*pair.report);
		if (pair.truth) truth_places.insert(*pair.truth);
		counts.hits += pair.outcome == Outcome::hit ? 1 : 0;
		counts.misses += pair.outcome == Outcome::miss ? 1 : 0;
		counts.false_alarms += pair.outcome == Outcome::false_alarm ? 1 : 0;
		counts.ignored += pair.outcome == Outcome::ignored ? 1 : 0;
	}
	EXPECT_EQ(report_places.size(), doors.size()) << "each report is in one pair";
	EXPECT_EQ(truth_places.size(), truth.size()) << "each true door is in one pair";
	EXPECT_EQ(std::set(report_places.begin(), report_places.end()).size(), doors.size());
	EXPECT_EQ(std::set(truth_places.begin(), truth_places.end()).size(), truth.size());
	return counts;
}

TruthDoor withVerdict(TruthDoor door, Verdict verdict, bool passable)
{
	door.verdict = verdict;
	door.passable = passable;
	return door;
}

TruthDoor withVisibility(TruthDoor door, Visibility visibility)
{
	door.visibility = visibility;
	return door;
}

const TruthDoor kDoor = test::openDoor("a", 3, 0, 0.9);
}  // namespace

TEST(DoorPairs, CentreAndWidthMustAgree)
{
	EXPECT_EQ(count({reported(3.0, 0.29, 0.9)}, {kDoor}), (Counts{1, 0, 0, 0}));
	EXPECT_EQ(count({reported(3.0, 0.31, 0.9)}, {kDoor}), (Counts{0, 1, 1, 0}));
	EXPECT_EQ(count({reported(3.0, 0.31, 0.9)}, {kDoor}, 0.45), (Counts{1, 0, 0, 0}));
	EXPECT_EQ(count({reported(3.0, 0.0, 1.14)}, {kDoor}), (Counts{1, 0, 0, 0}));
	EXPECT_EQ(count({reported(3.0, 0.0, 1.16)}, {kDoor}), (Counts{0, 1, 1, 0}));
}

TEST(DoorPairs, HeightsDoNotMatter)
{
	auto high = reported(3, 0, 0.9);
	high.center.z() = 2.5;
	EXPECT_EQ(count({high}, {kDoor}), (Counts{1, 0, 0, 0}));
}

TEST(DoorPairs, ADoorIsFoundOnce)
{
	EXPECT_EQ(count({reported(3, 0.05, 0.9), reported(3, -0.1, 0.9)}, {kDoor}), (Counts{1, 0, 1, 0}));
	const auto reports = reportsOf({reported(3, 0.15, 0.9), reported(3, -0.1, 0.9)}, {}, RobotConfig());
	const auto pairs = pairDoors(reports, {kDoor}, 0.30);
	EXPECT_EQ(pairs[0].report, 1U) << "the nearer one";
}

TEST(DoorPairs, TwoDoorsNearEachOtherBothFindTheirs)
{
	const auto other = test::openDoor("b", 3, 0.4, 0.9);
	EXPECT_EQ(count({reported(3, 0.2, 0.9), reported(3, 0.45, 0.9)}, {kDoor, other}), (Counts{2, 0, 0, 0}));
}

TEST(DoorPairs, PartlyVisibleDoorsCountNeitherWay)
{
	const auto ignored = withVisibility(kDoor, Visibility::ignored);
	EXPECT_EQ(count({reported(3, 0.4, 0.6)}, {ignored}), (Counts{0, 0, 0, 1}));
	EXPECT_EQ(count({}, {ignored}), (Counts{0, 0, 0, 0}));
	EXPECT_EQ(count({reported(3, 0.5, 0.9)}, {ignored}), (Counts{0, 0, 1, 0}));
	const auto hidden = withVisibility(kDoor, Visibility::hidden);
	EXPECT_EQ(count({reported(3, 0, 0.9)}, {hidden}), (Counts{0, 0, 1, 0}));
	EXPECT_EQ(count({}, {hidden}), (Counts{0, 0, 0, 0}));
}

TEST(DoorPairs, DoorsThatCannotBePassedAreFalseAlarmsWhenReportedOpen)
{
	const auto closed = withVerdict(kDoor, Verdict::closed, false);
	EXPECT_EQ(count({reported(3, 0, 0.9)}, {closed}), (Counts{0, 0, 1, 0}));
	EXPECT_EQ(count({reported(3, 0, 0.9, Verdict::closed)}, {closed}), (Counts{0, 0, 0, 0}));
	EXPECT_EQ(count({reported(3, 0, 0.9, Verdict::closed)}, {kDoor}), (Counts{0, 1, 0, 0}));
	EXPECT_EQ(count({reported(3, 0, 0.9)}, {withVisibility(closed, Visibility::ignored)}), (Counts{0, 0, 1, 0}))
	    << "partly in view, it is still closed";
	EXPECT_EQ(count({reported(3, 0, 0.9)}, {withVerdict(kDoor, Verdict::open, false)}), (Counts{0, 0, 1, 0}))
	    << "too narrow for the robot";
	EXPECT_EQ(count({reported(3, 0, 0.9)}, {withVerdict(kDoor, Verdict::passage, true)}), (Counts{1, 0, 0, 0}));
	EXPECT_EQ(count({reported(3, 0, 0.9)}, {withVerdict(kDoor, Verdict::blocked, true)}), (Counts{0, 0, 0, 1}))
	    << "a MAV may fly over what blocks others";
}

TEST(DoorPairs, AReportThatTheRobotDoesNotFitThroughIsNotPositive)
{
	EXPECT_EQ(count({reported(3, 0, 0.5)}, {test::openDoor("a", 3, 0, 0.7)}), (Counts{0, 1, 0, 0}));
}

TEST(DoorPairs, AjarDoorsAreComparedByWhatIsLeft)
{
	auto ajar = withVerdict(kDoor, Verdict::ajar, true);
	ajar.clear_width_m = 0.6;
	auto report = reported(3, 0, 0.6, Verdict::ajar);
	EXPECT_EQ(count({report}, {ajar}), (Counts{1, 0, 0, 0}));
	report.clear_width_m = 0.9;
	EXPECT_EQ(count({report}, {ajar}), (Counts{0, 1, 1, 0}));
}

TEST(DoorPairs, ReportsArePlacedByTheTruePose)
{
	const mrpt::poses::CPose3D map_from_robot(1, 2, 0, 1.5707963267948966, 0, 0);
	const auto reports = reportsOf({reported(3, 0.5, 0.9)}, map_from_robot, RobotConfig());
	EXPECT_NEAR(reports[0].center_in_map.x(), 0.5, 1e-12);
	EXPECT_NEAR(reports[0].center_in_map.y(), 5.0, 1e-12);
	EXPECT_NEAR(reports[0].normal_in_map.y(), -1.0, 1e-12);
}

TEST(Confusion, VerdictsOfVisibleDoorsAreCompared)
{
	const auto open = static_cast<std::size_t>(Verdict::open), closed = static_cast<std::size_t>(Verdict::closed),
	           passage = static_cast<std::size_t>(Verdict::passage),
	           blocked = static_cast<std::size_t>(Verdict::blocked);
	const auto table = [](const std::vector<Door>& doors, const std::vector<TruthDoor>& truth)
	{ return confusionOf(reportsOf(doors, {}, RobotConfig()), truth); };
	const auto shut = withVerdict(kDoor, Verdict::closed, false);
	EXPECT_EQ(table({reported(3, 0, 0.9)}, {shut})[closed][open], 1U);
	EXPECT_EQ(table({}, {shut})[closed][kVerdicts], 1U);
	EXPECT_EQ(table({reported(5, 0, 0.9)}, {shut})[kVerdicts][open], 1U);
	EXPECT_EQ(table({reported(3, 0, 0.9)}, {withVisibility(kDoor, Visibility::ignored)}), Confusion{});
	EXPECT_EQ(table({reported(3, 0, 1.6)}, {kDoor})[open][open], 1U) << "widths do not matter here";

	auto out_of_view = kDoor;
	EXPECT_EQ(table({reported(3, 0, 0.9, Verdict::passage)}, {out_of_view})[open][passage], 1U);
	out_of_view.lintel_in_view = false;
	EXPECT_EQ(table({reported(3, 0, 0.9, Verdict::passage)}, {out_of_view})[open][open], 1U);
	const auto flown_over = withVerdict(kDoor, Verdict::blocked, true);
	EXPECT_EQ(table({reported(3, 0, 0.9)}, {flown_over})[blocked][blocked], 1U);
}

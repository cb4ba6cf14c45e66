#include <explore/navigation/goal_kind.h>
#include <gtest/gtest.h>

#include "support/drawn_map.h"

namespace explore
{
namespace
{
/** Two rooms side by side with a doorway between them at (2.1, 0.7); 0.2 m a character. */
const test::DrawnMap kRooms({"#####################",  //
                             "#.........#.........?",  //
                             "#.........#.........?",  //
                             "#...................?",  //
                             "#..a............b...?",  //
                             "#...................?",  //
                             "#.........#.........?",  //
                             "#####################"},
                            0.2);

DoorTrack doorway(bool confirmed = true)
{
	DoorTrack door;
	door.number = 7;
	door.place.center_in_map = {2.1, 0.7};
	door.place.normal_rad = 3.14159;
	door.place.width_m = 0.9;
	door.existence.confirmed = confirmed;
	addOpinion(door.belief, {Verdict::open, 0.9, 0.9, 1.0}, 0.8);
	return door;
}

CorridorTrack corridorAlong(double y_m)
{
	CorridorTrack corridor;
	corridor.number = 3;
	corridor.point_in_map = {2.0, y_m};
	corridor.from_m = -1.0;
	corridor.to_m = 3.0;
	corridor.width_m = 1.5;
	corridor.existence.confirmed = true;
	return corridor;
}

class GoalNames : public testing::Test
{
protected:
	/** What a look from `stand` at `frontier` is called; the robot is at `a`. */
	GoalName named(const Eigen::Vector3d& stand, const Eigen::Vector3d& frontier, const RobotConfig& robot = {})
	{
		const AllowedArea everywhere;
		const PlanMap map = planMap({m_memory.layers, everywhere, m_robot_in_map, {}, {}}, {}, {});
		const TravelField field = travelFrom(map, map.cellOf(m_robot_in_map), {}, {});
		LookTarget target;
		target.look.cell = map.cellOf(stand);
		target.stand_in_map = stand;
		target.frontier_in_map = frontier;
		target.travel_m = field.costTo(target.look.cell);
		return nameOf(target, field.wayTo(target.look.cell), map, m_memory, robot);
	}

	Eigen::Vector3d m_robot_in_map = kRooms.at('a');
	FrontierMemory m_memory = test::memoryOf(kRooms);
};
const Eigen::Vector3d kBeyond(3.9, 0.7, 0), kThisSide(1.3, 0.7, 0);

TEST_F(GoalNames, AFrontierIsOneUnlessMoreIsKnown)
{
	const GoalName name = named(kRooms.at('b'), kBeyond);
	EXPECT_EQ(name.kind, GoalKind::frontier);
	EXPECT_FALSE(name.track);
}

TEST_F(GoalNames, AWayOrALookThroughAConfirmedDoorIsTheDoor)
{
	m_memory.doors.tracks = {doorway()};
	for (const Eigen::Vector3d& stand : {kRooms.at('b'), kThisSide})
	{
		const GoalName name = named(stand, kBeyond);
		EXPECT_EQ(name.kind, GoalKind::door);
		EXPECT_EQ(name.track, 7);
	}
	EXPECT_EQ(named(kThisSide, {1.3, 1.1, 0}).kind, GoalKind::frontier) << "it stays on this side";
}

TEST_F(GoalNames, ADoorThatIsNotSureOrWasPassedOrIsTooNarrowIsNone)
{
	m_memory.doors.tracks = {doorway(false)};
	EXPECT_EQ(named(kRooms.at('b'), kBeyond).kind, GoalKind::frontier);
	m_memory.doors.tracks = {doorway()};
	m_memory.doors.tracks[0].visited = true;
	EXPECT_EQ(named(kRooms.at('b'), kBeyond).kind, GoalKind::frontier);
	m_memory.doors.tracks[0].visited = false;
	RobotConfig wide;
	wide.radius_m = 0.45;
	EXPECT_EQ(named(kRooms.at('b'), kBeyond, wide).kind, GoalKind::frontier);
}

TEST_F(GoalNames, TheFirstDoorOnTheWayIsTheOne)
{
	DoorTrack second = doorway();
	second.number = 4;
	second.place.center_in_map = {3.0, 0.7};
	m_memory.doors.tracks = {second, doorway()};
	EXPECT_EQ(named(kRooms.at('b'), kBeyond).track, 7);
}

TEST_F(GoalNames, AFrontierInAConfirmedCorridorIsTheCorridor)
{
	m_memory.corridors.tracks = {corridorAlong(0.7)};
	const GoalName name = named(kRooms.at('b'), kBeyond);
	EXPECT_EQ(name.kind, GoalKind::corridor);
	EXPECT_EQ(name.track, 3);
	m_memory.corridors.tracks[0].existence.confirmed = false;
	EXPECT_EQ(named(kRooms.at('b'), kBeyond).kind, GoalKind::frontier);
	m_memory.corridors.tracks = {corridorAlong(2.7)};
	EXPECT_EQ(named(kRooms.at('b'), kBeyond).kind, GoalKind::frontier) << "2 m beside its axis";
	m_memory.corridors.tracks = {corridorAlong(0.7)};
	m_memory.corridors.tracks[0].to_m = -0.9;
	m_memory.corridors.tracks[0].from_m = -5.0;
	EXPECT_EQ(named(kRooms.at('b'), {4.5, 0.7, 0}).kind, GoalKind::frontier) << "beyond its end";
}

TEST_F(GoalNames, ATurnWhereTheRobotStandsIsALook)
{
	EXPECT_EQ(named(kRooms.at('a'), {0.9, 1.1, 0}).kind, GoalKind::look);
	EXPECT_EQ(named(kRooms.at('a') + Eigen::Vector3d(0.6, 0, 0), {1.3, 1.1, 0}).kind, GoalKind::frontier);
}
}  // namespace
}  // namespace explore

// The families: that all are there, vary as buildings do, and show what they promise.
#include <explore/core/geometry.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "scene_support.h"
#include "support/test_files.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using testing::Each;
using testing::Gt;
using testing::Lt;

namespace
{
Eigen::Vector3d cameraOf(const TruthFrame& frame)
{
	return isometryOf(frame.map_from_robot + *frame.robot_from_camera).translation();
}

struct DoorView
{
	double distance_m, offset_deg, width_m;
};

/** How the first door is seen, on the floor plan. */
DoorView viewOf(const Scene& scene)
{
	const TruthDoor& door = firstLook(scene).doors.front();
	const Eigen::Vector2d to_camera = (cameraOf(firstLook(scene)) - door.center_in_map).head<2>();
	const double cosine = to_camera.normalized().dot(door.normal_in_map.head<2>());
	return {to_camera.norm(), std::acos(std::clamp(cosine, -1.0, 1.0)) / kDegree_rad, door.width_m};
}

std::vector<std::string_view> namesWhere(const std::function<bool(const SceneFamily&)>& wanted)
{
	std::vector<std::string_view> names;
	for (const SceneFamily& family : sceneFamilies())
		if (wanted(family)) names.push_back(family.name);
	return names;
}

int visibleDoors(const TruthFrame& frame)
{
	return static_cast<int>(std::ranges::count(frame.doors, Visibility::visible, &TruthDoor::visibility));
}
}  // namespace

TEST(SceneFamilies, HaveNamesOfTheirOwnAndADescription)
{
	std::set<std::string_view> names;
	for (const SceneFamily& family : sceneFamilies())
	{
		EXPECT_TRUE(names.insert(family.name).second) << family.name;
		EXPECT_TRUE(std::ranges::all_of(family.name,
		                                [](unsigned char c) { return std::islower(c) || std::isdigit(c) || c == '_'; }))
		    << family.name;
		EXPECT_FALSE(family.description.empty()) << family.name;
		EXPECT_EQ(sceneFamilyNamed(family.name), &family);
	}
	EXPECT_EQ(sceneFamilyNamed("no_such_family"), nullptr);
}

TEST(SceneFamilies, AreDocumented)
{
	const std::string text = readFile(std::filesystem::path(EXPLORE_SOURCE_DIR) / "doc" / "scenes.md");
	for (const SceneFamily& family : sceneFamilies())
		EXPECT_THAT(text,
		            testing::HasSubstr("| `" + std::string(family.name) + "` | " + std::string(family.description)));
}

TEST(SceneFamilies, AreThoseThatADetectorIsTriedOn)
{
	for (const char* name : {"frontal_door",
	                         "oblique_door",
	                         "corridor_side_doors",
	                         "two_doors",
	                         "far_door",
	                         "corner_door",
	                         "tilted_view",
	                         "floor_unseen",
	                         "narrow_door",
	                         "person_in_doorway",
	                         "box_hiding_jamb",
	                         "cabinet_before_wall",
	                         "person_before_wall",
	                         "window",
	                         "alcove",
	                         "black_patch",
	                         "wardrobe_gap",
	                         "stairwell",
	                         "pillar_row",
	                         "recessed_closed_door",
	                         "counter",
	                         "ajar_30",
	                         "ajar_60",
	                         "leaf_toward_us",
	                         "jamb_out_of_view",
	                         "glass_door",
	                         "mirror",
	                         "passage_no_lintel",
	                         "wide_passage",
	                         "under_table",
	                         "threshold_low",
	                         "threshold_high",
	                         "curtain",
	                         "dark_deep_room",
	                         "split_wall_door",
	                         "corridor_end"})
		EXPECT_NE(sceneFamilyNamed(name), nullptr) << name;
	EXPECT_THAT(
	    namesWhere([](const SceneFamily& family) { return !family.configuration.empty(); }),
	    testing::ElementsAre("single_wall_single_door", "single_wall_multiple_doors", "multiple_walls_multiple_doors"));
	EXPECT_THAT(
	    namesWhere([](const SceneFamily& family) { return family.hazard; }),
	    testing::UnorderedElementsAre("glass_door", "mirror", "black_patch", "stairwell", "recessed_closed_door"));
	EXPECT_EQ(sceneFamilyNamed("mirror")->scenesForAClaim(), 1000);
	EXPECT_EQ(sceneFamilyNamed("frontal_door")->scenesForAClaim(), 500);
}

TEST(SceneFamilies, ShowADoorThatCanBePassedUnlessTheyAreNegative)
{
	const std::set<std::string_view> not_always = {"jamb_out_of_view", "ajar_30", "ajar_60"};
	for (const SceneFamily& family : sceneFamilies())
		for (const RobotKind kind : {RobotKind::ground, RobotKind::mav})
			for (int index = 0; index < 8; ++index)
			{
				const Scene scene = sceneOf(family.name, index, kind);
				// Some doors are too narrow for the MAV, which is 60 cm wide.
				const bool visible = std::ranges::any_of(
				    firstLook(scene).doors, [kind](const TruthDoor& door)
				    { return door.visibility == Visibility::visible && (door.passable || kind == RobotKind::mav); });
				const bool passable = std::ranges::any_of(firstLook(scene).doors, &TruthDoor::passable);
				EXPECT_FALSE(passable && family.negativeFor(kind)) << family.name << ' ' << index;
				if (family.negativeFor(kind) || not_always.contains(family.name)) continue;
				EXPECT_TRUE(visible || family.name.starts_with("obstacle")) << family.name << ' ' << index;
			}
}

TEST(SceneFamilies, PaperConfigurationsCoverTheirOffsetsDistancesAndWidths)
{
	std::vector<double> offsets, distances, widths;
	for (int index = 0; index < 300; ++index)
	{
		const DoorView view = viewOf(sceneOf("single_wall_single_door", index));
		offsets.push_back(view.offset_deg), distances.push_back(view.distance_m), widths.push_back(view.width_m);
	}
	for (auto* values : {&offsets, &distances, &widths}) std::ranges::sort(*values);
	EXPECT_LT(offsets[15], 6);
	EXPECT_GT(offsets[284], 65);
	EXPECT_LE(offsets.back(), 76);
	EXPECT_NEAR(offsets[150], 37, 8);
	EXPECT_LT(distances[30], 1.9);
	EXPECT_GT(distances[270], 4.2);
	EXPECT_LE(distances.back(), 5);
	EXPECT_GE(widths.front(), 0.8);
	EXPECT_LE(widths.back(), 1.2);
	EXPECT_NEAR(widths[150], 1.0, 0.06);
}

TEST(SceneFamilies, DoorsVaryInWidthHeightAndLeaf)
{
	std::vector<double> widths, heights;
	std::array<int, 3> leaves{};  // none, folded back, opened
	for (int index = 0; index < 200; ++index)
	{
		const Scene scene = sceneOf("frontal_door", index);
		const DoorLabel& label = scene.world->doors.front();
		widths.push_back(label.width_m), heights.push_back(label.height_m.value());
		const bool leaf = std::ranges::count(scene.world->bodies, "door_1_leaf", &simulation::Body::name) > 0;
		++leaves.at(!leaf                                                                                  ? 0
		            : std::ranges::count(scene.world->bodies, "door_1_leaf", &simulation::Body::name) == 1 ? 1
		                                                                                                   : 2);
		EXPECT_LE(viewOf(scene).offset_deg, 16);
	}
	EXPECT_GE(*std::ranges::min_element(widths), 0.7);
	EXPECT_LT(*std::ranges::min_element(widths), 0.75);
	EXPECT_LE(*std::ranges::max_element(widths), 1.3);
	EXPECT_GT(*std::ranges::max_element(widths), 1.22);
	EXPECT_GE(*std::ranges::min_element(heights), 1.9);
	EXPECT_LE(*std::ranges::max_element(heights), 2.1);
	EXPECT_THAT(leaves, Each(Gt(25)));
}

TEST(SceneFamilies, SeveralDoorsAreSeenWhereTheFamilySaysSo)
{
	for (int index = 0; index < 20; ++index)
		for (const RobotKind kind : {RobotKind::ground, RobotKind::mav})
		{
			EXPECT_EQ(visibleDoors(firstLook(sceneOf("two_doors", index, kind))), 2);
			EXPECT_GE(visibleDoors(firstLook(sceneOf("single_wall_multiple_doors", index, kind))), 2);
			const Scene corridor = sceneOf("multiple_walls_multiple_doors", index, kind);
			std::vector<Eigen::Vector3d> normals;
			for (const TruthDoor& door : firstLook(corridor).doors)
				if (door.visibility == Visibility::visible) normals.push_back(door.normal_in_map);
			ASSERT_GE(normals.size(), 2U);
			EXPECT_TRUE(std::ranges::any_of(
			    normals, [&](const Eigen::Vector3d& normal) { return normal.dot(normals.front()) < 0.5; }))
			    << "all in one wall";
		}
}

TEST(SceneFamilies, OfOneJambShowExactlyOne)
{
	for (int index = 0; index < 20; ++index)
	{
		const Scene scene = sceneOf("jamb_out_of_view", index);
		const TruthDoor& door = firstLook(scene).doors.front();
		EXPECT_EQ(door.verdict, Verdict::partial);
		EXPECT_EQ(door.visibility, Visibility::ignored);
		EXPECT_EQ(std::min(door.jamb_share[0], door.jamb_share[1]), 0);
		EXPECT_GT(std::max(door.jamb_share[0], door.jamb_share[1]), 0.2);
	}
}

TEST(SceneFamilies, CorridorsHaveADirectionAndRoomsHaveNone)
{
	int corridors = 0;
	for (int index = 0; index < 60; ++index)
	{
		EXPECT_EQ(firstLook(sceneOf("room_no_corridor", index)).corridor.state, CorridorState::none);
		const Scene scene = sceneOf("corridor_no_doors", index);
		EXPECT_TRUE(scene.world->doors.empty());
		const TruthCorridor corridor = firstLook(scene).corridor;
		if (corridor.state != CorridorState::corridor) continue;
		++corridors;
		// The robot looks along x, at most 20° off the axis.
		EXPECT_GT(std::abs(corridor.direction_in_map.x()), std::cos(21 * kDegree_rad));
	}
	EXPECT_GT(corridors, 25);
}

TEST(SceneFamilies, ObstaclesStandAheadOfTheRobotInAllThreePlaces)
{
	std::vector<double> room_sizes;
	for (const char* kind : {"pedestrian", "box", "swivel_chair", "four_legged_chair", "armchair", "stool"})
		for (int index = 0; index < 15; ++index)
		{
			const Scene scene = sceneOf(std::string("obstacle_").append(kind), index);
			const auto ahead = [kind](const TruthObstacle& obstacle)
			{
				return obstacle.kind == kind && obstacle.center_in_map.x() > 0.8 && obstacle.center_in_map.x() < 4.5 &&
				       std::abs(obstacle.center_in_map.y()) < 0.5;
			};
			EXPECT_TRUE(std::ranges::any_of(firstLook(scene).obstacles, ahead)) << kind << ' ' << index;
			const auto& room = scene.room_in_map;
			room_sizes.push_back(std::min((room[1] - room[0]).norm(), (room[2] - room[1]).norm()));
		}
	const auto between = [&](double low, double high)
	{ return std::ranges::count_if(room_sizes, [=](double size) { return size >= low && size < high; }); };
	EXPECT_GT(between(1.5, 3.01), 15);  // corridors
	EXPECT_GT(between(4.2, 5.9), 10);   // offices
	EXPECT_GT(between(6.5, 12.0), 10);  // conference rooms
}

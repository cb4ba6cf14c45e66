// Labels of random scenes against rays in their geometry.
#include <explore/simulation/random.h>

#include <gmock/gmock.h>

#include <cmath>

#include "scene_support.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using Eigen::Vector3d;

namespace
{
/** Directions and places of a labelled opening. */
struct Opening
{
	explicit Opening(const DoorLabel& door) : label(door), normal(door.normal_in_map.normalized())
	{
		across = Vector3d::UnitZ().cross(normal);
		// The robot stands at the origin.
		if (normal.dot(-door.floor_center_in_map) < 0) normal *= -1;
	}
	/** `along` from the middle, `behind` the face on the robot's side, at that height. */
	[[nodiscard]] Vector3d at(double along, double behind, double z) const
	{
		return label.floor_center_in_map + along * across + (0.5 * label.depth_m - behind) * normal +
		       z * Vector3d::UnitZ();
	}

	const DoorLabel& label;
	Vector3d normal, across;
};

double lengthTo(const RayScene& scene, const Vector3d& origin, const Vector3d& direction)
{
	const auto hit = scene.cast(origin, direction, 30.0);
	return hit ? hit->distance : HUGE_VAL;
}

const std::string& materialAt(const RayScene& scene, const Vector3d& origin, const Vector3d& direction)
{
	static const std::string kNothing = "nothing";
	const auto hit = scene.cast(origin, direction, 30.0);
	return hit ? scene.world().materials[hit->material].name : kNothing;
}

const DoorLabel& onlyLabel(const Scene& scene)
{
	EXPECT_EQ(scene.world->doors.size(), 1U);
	return scene.world->doors.at(0);
}
}  // namespace

TEST(SceneLabels, GiveWidthHeightAndDepthOfTheHole)
{
	for (const char* family :
	     {"single_wall_single_door", "single_wall_multiple_doors", "multiple_walls_multiple_doors", "frontal_door",
	      "corner_door", "narrow_door", "passage_no_lintel", "wide_passage", "threshold_low", "split_wall_door",
	      "ajar_30", "ajar_60", "leaf_toward_us", "stairwell", "corridor_side_doors", "corridor_end", "counter"})
		for (int index = 0; index < 12; ++index)
		{
			const Scene scene = sceneOf(family, index);
			SCOPED_TRACE(std::string(family) + " " + std::to_string(index));
			for (const DoorLabel& label : scene.world->doors)
			{
				const Opening opening(label);
				const Vector3d middle = opening.at(0, 0.5 * label.depth_m, 1.5);
				const double left_m = lengthTo(*scene.rays, middle, opening.across);
				const double right_m = lengthTo(*scene.rays, middle, -opening.across);
				EXPECT_NEAR(left_m, right_m, 0.01);
				EXPECT_NEAR(left_m + right_m, label.width_m, 0.01);
				const double up_m = lengthTo(*scene.rays, middle, Vector3d::UnitZ());
				// Without a lintel: the ceiling, or the sky.
				EXPECT_TRUE(label.height_m ? std::abs(1.5 + up_m - *label.height_m) < 0.01 : 1.5 + up_m > 2.25) << up_m;
			}
		}
}

TEST(SceneLabels, OpenDoorsAreOpenAllTheWay)
{
	for (const char* family : {"single_wall_single_door", "oblique_door", "far_door", "tilted_view", "floor_unseen",
	                           "box_hiding_jamb", "passage_no_lintel", "wide_passage", "corridor_end"})
		for (int index = 0; index < 12; ++index)
		{
			const Scene scene = sceneOf(family, index);
			const Opening opening(onlyLabel(scene));
			for (const double along : {-0.2, 0.0, 0.2})
				for (const double z : {0.15, 0.6, 1.2, 1.8})
				{
					const double free_m = lengthTo(*scene.rays, opening.at(along, 0, z), -opening.normal);
					EXPECT_GT(free_m, opening.label.depth_m + 1.0)
					    << family << ' ' << index << ' ' << along << ' ' << z;
				}
			EXPECT_NEAR(lengthTo(*scene.rays, opening.at(0, opening.label.depth_m + 0.4, 1.0), -Vector3d::UnitZ()), 1.0,
			            0.01)
			    << "a floor behind";
		}
}

TEST(SceneLabels, ClosedLeavesAreFiveToTenCentimetresBack)
{
	for (int index = 0; index < 25; ++index)
	{
		const Scene scene = sceneOf("recessed_closed_door", index);
		const Opening opening(onlyLabel(scene));
		EXPECT_EQ(opening.label.verdict, Verdict::closed);
		EXPECT_EQ(opening.label.clear_width_m, 0);
		for (const double along : {-0.45, 0.0, 0.3})
			for (const double z : {0.1, 0.7, 1.8})
			{
				const double back_m =
				    lengthTo(*scene.rays, opening.at(along * opening.label.width_m, -0.2, z), -opening.normal) - 0.2;
				EXPECT_GE(back_m, 0.049);
				EXPECT_LE(back_m, 0.101);
			}
	}
}

TEST(SceneLabels, SillsAreAsHighAsLabelled)
{
	for (const auto& [family, low_m, high_m, verdict] : {std::tuple{"threshold_low", 0.02, 0.04, Verdict::open},
	                                                     {"threshold_high", 0.15, 0.25, Verdict::blocked},
	                                                     {"counter", 0.85, 1.1, Verdict::blocked}})
		for (int index = 0; index < 15; ++index)
		{
			const Scene scene = sceneOf(family, index);
			const Opening opening(onlyLabel(scene));
			EXPECT_EQ(opening.label.verdict, verdict);
			const double down_m =
			    lengthTo(*scene.rays, opening.at(0, 0.5 * opening.label.depth_m, 1.6), -Vector3d::UnitZ());
			EXPECT_NEAR(1.6 - down_m, opening.label.sill_m, 0.005);
			EXPECT_GE(opening.label.sill_m, low_m);
			EXPECT_LE(opening.label.sill_m, high_m);
		}
}

TEST(SceneLabels, UnknownOnesAreOfTheMaterialThatHidesThem)
{
	for (const auto& [family, material] : {std::pair{"glass_door", "glass"},
	                                       {"mirror", "mirror"},
	                                       {"black_patch", "black_felt"},
	                                       {"dark_deep_room", "black_felt"}})
		for (int index = 0; index < 20; ++index)
		{
			const Scene scene = sceneOf(family, index);
			const Opening opening(onlyLabel(scene));
			EXPECT_EQ(opening.label.verdict, Verdict::unknown);
			for (const double along : {-0.3, 0.01, 0.3})
				for (const double z : {0.4, 0.8, 1.6})
				{
					const Vector3d before = opening.at(along * opening.label.width_m, -0.1, z);
					EXPECT_EQ(materialAt(*scene.rays, before, -opening.normal), material) << family << ' ' << index;
				}
		}
}

TEST(SceneLabels, NothingReturnsFromADarkRoom)
{
	for (int index = 0; index < 15; ++index)
	{
		const Scene scene = sceneOf("dark_deep_room", index);
		const Opening opening(onlyLabel(scene));
		simulation::Random random(7);
		for (int ray = 0; ray < 200; ++ray)
		{
			const Vector3d through = opening.at(random.uniform(-0.45, 0.45) * opening.label.width_m,
			                                    opening.label.depth_m, random.uniform(0.05, 1.85));
			const Vector3d camera_place(0.1, 0, 0.6);
			const Vector3d direction = (through - camera_place).normalized();
			const std::string& material = materialAt(*scene.rays, through + 0.01 * direction, direction);
			EXPECT_EQ(surfaceOf(material), Surface::black) << material;
		}
	}
}

TEST(SceneLabels, NoFloorIsWithinReachBehindADrop)
{
	for (int index = 0; index < 25; ++index)
	{
		const Scene scene = sceneOf("stairwell", index);
		const Opening opening(onlyLabel(scene));
		EXPECT_EQ(opening.label.verdict, Verdict::drop);
		for (const double behind : {0.25, 0.5, 0.7})
		{
			const double down_m =
			    lengthTo(*scene.rays, opening.at(0, opening.label.depth_m + behind, 0.5), -Vector3d::UnitZ());
			EXPECT_GT(down_m - 0.5, 0.15) << index << ' ' << behind;
		}
	}
}

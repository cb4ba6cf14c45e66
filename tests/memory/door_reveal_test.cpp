#include <explore/core/geometry.h>
#include <explore/memory/door_reveal.h>
#include <gtest/gtest.h>
#include <support/analytic_scene.h>

#include "door_looks.h"

namespace explore::test
{
namespace
{
constexpr double kThickness_m = 0.12;

/** A wall whose face is at x = 3 with an opening of 1 m in its middle, and the room behind. */
Scene wallOf(double thickness_m)
{
	Scene scene;
	scene.floor(-2, -4, 8, 4).wall({6, -12}, {6, 12}, 4);
	if (thickness_m > 0)
		scene.box({3 + 0.5 * thickness_m, 2, 1.25}, {thickness_m, 3, 2.5})
		    .box({3 + 0.5 * thickness_m, -2, 1.25}, {thickness_m, 3, 2.5});
	else
		scene.wall({3, -3.5}, {3, 3.5}, 2.5, {{3, 1, 2.5}});
	return scene;
}

RevealRows seen(const Scene& scene, double x_m, double y_m, double yaw_rad, double noise = 1)
{
	const DepthFrame frame =
	    renderFrame(scene, mrpt::poses::CPose3D(x_m, y_m, 0, yaw_rad, 0, 0), mrpt::poses::CPose3D(0, 0, 0.5, 0, 0, 0),
	                xtionIntrinsics(640, 480), {.axial_scale = noise, .dropout_share = 0.01 * noise});
	const KnownDoor door{{3 + 0.5 * kThickness_m, 0}, std::numbers::pi, 1.0};
	return revealOf(frame, placeOf(door));
}

TEST(DoorReveal, AWallHasAThicknessAndAMirrorHasNone)
{
	Dice dice(1);
	int compared = 0;
	for (int round = 0; round < 25; ++round)
	{
		const double x_m = dice.uniform(-0.5, 1.5), y_m = dice.uniform(-0.8, 0.8);
		const double yaw_rad = std::atan2(-y_m, 3 - x_m) + dice.uniform(-0.1, 0.1);
		const RevealRows wall = seen(wallOf(kThickness_m), x_m, y_m, yaw_rad),
		                 mirror = seen(wallOf(0), x_m, y_m, yaw_rad);
		if (wall.flat + wall.thick < 10 || mirror.flat + mirror.thick < 10) continue;
		++compared;
		EXPECT_LT(wall.flatShare(), 0.3) << "from " << x_m << ", " << y_m;
		EXPECT_GT(mirror.flatShare(), 0.9) << "from " << x_m << ", " << y_m;
	}
	EXPECT_GT(compared, 10);
}

TEST(DoorReveal, FromTheSideTheFarJambShowsItAll)
{
	const RevealRows wall = seen(wallOf(kThickness_m), 1.8, 1.2, -45 * kDegree_rad, 0);
	EXPECT_GT(wall.thick, 10);
	EXPECT_EQ(wall.flat, 0);
}

TEST(DoorReveal, NothingIsSaidOutOfViewBehindSomeoneOrWithoutAnImage)
{
	EXPECT_EQ(seen(wallOf(0), 0, 0, 180 * kDegree_rad).flat, 0);
	Scene hidden = wallOf(0);
	hidden.box({2.0, 0.45, 0.9}, {0.3, 0.5, 2.4}).box({2.0, -0.45, 0.9}, {0.3, 0.5, 2.4});
	EXPECT_EQ(seen(hidden, 0, 0, 0, 0).flat, 0);
	EXPECT_EQ(revealOf(DepthFrame(), placeOf(KnownDoor{{3, 0}, std::numbers::pi})).flat, 0);
	EXPECT_EQ(RevealRows().flatShare(), 0);
}
}  // namespace
}  // namespace explore::test

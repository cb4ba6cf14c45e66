// What passes for a wall in a simulated hall must not make a good camera look bad.
#include <explore-mrpt/depth_check.h>
#include <explore/simulation/load_world.h>
#include <explore/simulation/ray_scene.h>
#include <explore/simulation/recorder.h>

#include <gtest/gtest.h>

#include <numbers>

using namespace explore;
using namespace explore::simulation;

namespace
{
/** The first remark while the robot drives 10 m along an aisle of the warehouse, between its west wall and the fronts
 *  of its racks, whose loads stand back and forth; depths z are measured as z + curvature · z². */
std::optional<std::string> remarkInTheAisle(double curvature_per_m)
{
	const World world = loadWorld(std::string(EXPLORE_SOURCE_DIR) + "/rawlogs/worlds/warehouse.sdf", usualWorldPaths());
	const RayScene scene(world);
	RecorderConfig recorder;
	recorder.camera = depthCamera("xtion", 320);
	recorder.robot_from_camera = usualMount(RobotKind::ground);
	recorder.start = mrpt::Clock::fromDouble(kUsualStart_s);
	const ExplorerConfig config;
	app::DepthCheck check(config);
	for (std::size_t i = 0; i < 40; ++i)
	{
		DepthFrame frame;
		frame.map_from_robot =
		    mrpt::poses::CPose3D(1.05, 3.5 + 0.25 * static_cast<double>(i), 0, 0.5 * std::numbers::pi, 0, 0);
		frame.pose_origin = PoseOrigin::robot_pose;
		frame.robot_from_camera = recorder.robot_from_camera;
		frame.timestamp = timeOf(recorder, 0.5 * static_cast<double>(i));
		frame.image = takeFrame(scene, recorder, frame.map_from_robot, i).depth;
		for (float& z : frame.image.depth_m) z += static_cast<float>(curvature_per_m) * z * z;
		if (auto remark = check.look(frame)) return remark;
	}
	return std::nullopt;
}
}  // namespace

TEST(DepthCheckWorlds, FrontsOfRacksAreNoWalls)
{
	EXPECT_EQ(remarkInTheAisle(0.0), std::nullopt);
}

#include <explore/navigation/level_frame.h>
#include <gtest/gtest.h>

#include <cmath>

namespace explore
{
namespace
{
TEST(LevelFrame, IsTheRobotFrameWithoutAFloor)
{
	const LevelFrame level = levelFrame(std::nullopt);
	EXPECT_TRUE(level.level_from_robot.isIdentity());
	EXPECT_EQ(level.altitude_m, 0.0);
}

TEST(LevelFrame, UndoesThePitchOfACameraThatIsTakenForTheRobot)
{
	// Camera 1 m above the floor, looking 0.3 rad down: in its frame the floor's normal leans backward.
	const double pitch = 0.3;
	const Eigen::Vector3d up(-std::sin(pitch), 0.0, std::cos(pitch));
	const LevelFrame level = levelFrame(Plane{up, 1.0});
	EXPECT_DOUBLE_EQ(level.altitude_m, 1.0);
	// A point on the floor straight ahead: 1 m below and 2 m in front, seen along the tilted axes.
	const Eigen::Vector3d point(2.0 * std::cos(pitch) + std::sin(pitch), 0.0, 2.0 * std::sin(pitch) - std::cos(pitch));
	EXPECT_TRUE((level.level_from_robot * point).isApprox(Eigen::Vector3d(2.0, 0.0, -1.0), 1e-12));
}

TEST(LevelFrame, RollKeepsTheForwardAxisAndIsARotation)
{
	const double roll = -0.2;
	const Eigen::Vector3d up(0.0, std::sin(roll), std::cos(roll));
	const Eigen::Matrix3d rotation = levelFrame(Plane{up, 0.0}).level_from_robot;
	EXPECT_TRUE((rotation * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitX(), 1e-12));
	EXPECT_TRUE((rotation * up).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
	EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
}

TEST(LevelFrame, LookingAlongTheNormalIsNoDivisionByZero)
{
	const LevelFrame level = levelFrame(Plane{Eigen::Vector3d::UnitX(), 0.5});
	EXPECT_TRUE(level.level_from_robot.allFinite());
	EXPECT_DOUBLE_EQ(level.altitude_m, 0.5);
}
}  // namespace
}  // namespace explore

#include <explore/core/geometry.h>
#include <explore/sinks/trajectory.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <sstream>

using namespace explore;

TEST(Trajectory, AQuarterTurnToTheLeft)
{
	DepthFrame frame;
	frame.timestamp = mrpt::Clock::fromDouble(1416537600.125);
	frame.map_from_robot = mrpt::poses::CPose3D(1, -2, 0.5, 1.5707963267948966, 0, 0);
	EXPECT_EQ(trajectoryLine(frame),
	          "1416537600.125000 1.000000 -2.000000 0.500000 0.000000000 0.000000000 0.707106781 0.707106781\n");
}

TEST(Trajectory, QuaternionTurnsVectorsAsThePoseDoes)
{
	std::mt19937 random(5);
	std::uniform_real_distribution<double> angle(-3.1, 3.1), tilt(-1.5, 1.5);
	for (int i = 0; i < 100; ++i)
	{
		DepthFrame frame;
		frame.map_from_robot = mrpt::poses::CPose3D(0, 0, 0, angle(random), tilt(random), angle(random));
		std::istringstream line(trajectoryLine(frame));
		double t = 0, x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 0;
		line >> t >> x >> y >> z >> qx >> qy >> qz >> qw;
		ASSERT_TRUE(line);
		EXPECT_GE(qw, 0.0);
		for (int axis = 0; axis < 3; ++axis)
		{
			const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
			double gx = 0, gy = 0, gz = 0;
			frame.map_from_robot.composePoint(unit.x(), unit.y(), unit.z(), gx, gy, gz);
			EXPECT_LT((Eigen::Quaterniond(qw, qx, qy, qz) * unit - Eigen::Vector3d(gx, gy, gz)).norm(), 1e-7);
		}
	}
}

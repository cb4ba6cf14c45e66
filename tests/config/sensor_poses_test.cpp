// Sensor poses out of rawlog-grabber files as they are found in the field.
#include <explore/config/sensor_poses.h>
#include <explore/core/errors.h>
#include <gmock/gmock.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "support/test_files.h"

namespace explore
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

class SensorPosesFile : public testing::Test
{
protected:
	SensorPoses load(const std::string& text)
	{
		std::ofstream(m_path, std::ios::binary) << text;
		return loadSensorPoses(m_path);
	}
	std::string refusal(const std::string& text)
	{
		try
		{
			load(text);
			return "";
		}
		catch (const ConfigError& error)
		{
			return error.what();
		}
	}

	std::filesystem::path m_path = test::freshFolder() / "explore_grabber.ini";
};

void expectPose(const mrpt::poses::CPose3D& pose, const std::array<double, 6>& expected)
{
	EXPECT_NEAR(pose.x(), expected[0], 1e-12);
	EXPECT_NEAR(pose.y(), expected[1], 1e-12);
	EXPECT_NEAR(pose.z(), expected[2], 1e-12);
	EXPECT_NEAR(pose.yaw(), expected[3], 1e-12);
	EXPECT_NEAR(pose.pitch(), expected[4], 1e-12);
	EXPECT_NEAR(pose.roll(), expected[5], 1e-12);
}

TEST_F(SensorPosesFile, aGrabberFileWithForeignKeys)
{
	const auto poses = load(
	    "# ------ settings of the application \\\n"
	    "[global]\n"
	    "rawlog_prefix\t= D:\\datasets\\today   // the date is appended\n"
	    "use_sensoryframes\t= 0\n"
	    "a line that means nothing\n"
	    "[Kinect]\n"
	    "driver = CKinect      // class name\n"
	    "process_rate = 20 # Hz\n"
	    "sensorLabel = KINECT_FRONT\n"
	    "pose_x=0.25\t// position on the robot (meters)\n"
	    "pose_y=-0.1\n"
	    "pose_z=0.5\n"
	    "pose_yaw=90\t// Angles in degrees\n"
	    "pose_pitch=10\n"
	    "pose_roll=-5\n"
	    "[Laser]\n"
	    "pose_z = 0.2\n"
	    "[gps]\n"
	    "sensorLabel = GPS\n"
	    "COM_port_LIN = ttyUSB0\n");
	ASSERT_EQ(poses.size(), 2U);
	expectPose(poses.at("KINECT_FRONT"), {0.25, -0.1, 0.5, kPi / 2, kPi / 18, -kPi / 36});
	expectPose(poses.at("Laser"), {0, 0, 0.2, 0, 0, 0});
}

TEST_F(SensorPosesFile, commentsRightBehindTheNumber)
{
	expectPose(load("[cam]\npose_x=0.5// position on the robot (meters)\npose_yaw=90// degrees").at("cam"),
	           {0.5, 0, 0, kPi / 2, 0, 0});
}

TEST_F(SensorPosesFile, theFilesThatMrptShips)
{
	const std::filesystem::path folder = "/usr/share/mrpt/config_files/rawlog-grabber";
	if (!std::filesystem::exists(folder / "roadbot-all.ini")) GTEST_SKIP() << "needs the package mrpt-common";
	expectPose(loadSensorPoses(folder / "roadbot-all.ini").at("LMS_FRONT"), {0.095, 0, 0.31, 0, 0, 0});
	expectPose(loadSensorPoses(folder / "dataset_pid_gps.ini").at("RAE_PID"), {0.05, 0, 0.29, 0, 0, -kPi});
	EXPECT_EQ(loadSensorPoses(folder / "camera_opencv.ini").size(), 1U);
}

TEST_F(SensorPosesFile, macrosWork)
{
	expectPose(load("@define MAST 1.25\n[cam]\npose_z = ${MAST}\npose_pitch = $eval{10+5}\n").at("cam"),
	           {0, 0, 1.25, 0, kPi / 12, 0});
}

TEST_F(SensorPosesFile, aNumberThatIsNoneIsRefused)
{
	EXPECT_THAT(refusal("[cam]\npose_z = 0.5\npose_yaw = -90 # deg\n"),
	            AllOf(HasSubstr("explore_grabber.ini:3: [cam] pose_yaw = \"-90 # deg\""), HasSubstr("degrees"),
	                  HasSubstr("only a // comment")));
	EXPECT_THAT(refusal("[cam]\npose_x = 0,5\n"), AllOf(HasSubstr(":2: "), HasSubstr("metres")));
	EXPECT_THAT(refusal("[cam]\npose_x = nan\n"), HasSubstr("not a number"));
}

TEST_F(SensorPosesFile, ambiguousFilesAreRefused)
{
	EXPECT_THAT(refusal("[cam]\npose_x = 1\npose_x = 2\n"), HasSubstr("given before"));
	EXPECT_EQ(load("[a]\nsensorLabel=C\npose_x = 1\n[b]\nsensorLabel=C\npose_x = 1\n").size(), 1U);
	EXPECT_THAT(refusal("[a]\nsensorLabel=C\npose_x = 1\n[b]\nsensorLabel=C\npose_x = 2\n"), HasSubstr("\"C\""));
}

TEST_F(SensorPosesFile, aFileWithoutAnyPoseIsRefused)
{
	EXPECT_THAT(refusal("[cam]\nsensorLabel = C\nposx = 1\n"), HasSubstr("no section holds a sensor pose"));
	EXPECT_THAT(refusal(""), HasSubstr("no section holds a sensor pose"));
	EXPECT_THROW(loadSensorPoses("does/not/exist.ini"), ConfigError);
}
}  // namespace
}  // namespace explore

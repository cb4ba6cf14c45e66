// The TUM RGB-D layout: image list, poses of the optical frame.
#include <explore/core/errors.h>
#include <explore/core/geometry.h>

#include <Eigen/Geometry>
#include <fstream>

#include "import_fixture.h"

namespace explore::test
{
namespace
{
using mrpt::poses::CPose3D;

/** A TUM folder of three frames, with a camera that moves and looks down. */
CPose3D mapFromCamera(int i)
{
	return {0.5 * i, 0.1 * i, 1.0, 0.3 * i, 0.2, -0.1};
}

void writeTumFolder(const std::filesystem::path& folder)
{
	std::filesystem::create_directories(folder / "depth");
	std::ofstream list(folder / "depth.txt"), truth(folder / "groundtruth.txt");
	list << "# depth maps\n# timestamp filename\n" << std::fixed;
	truth << "# ground truth trajectory\n" << std::fixed;
	list.precision(6), truth.precision(9);
	// Columns of the rotation: the optical x (right), y (down) and z (forward) in camera axes.
	Eigen::Matrix3d camera_from_optical;
	camera_from_optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
	for (int i = 0; i < 3; ++i)
	{
		const double t = 1'305'031'102.25 + 0.5 * i;
		writePng(folder / "depth" / (std::to_string(i) + ".png"), sceneFrame(0.1 * i).image, 5000);
		list << t << " depth/" << i << ".png\n";
		const Eigen::Isometry3d pose = isometryOf(mapFromCamera(i));
		const Eigen::Quaterniond q(pose.linear() * camera_from_optical);
		truth << t << ' ' << pose.translation().x() << ' ' << pose.translation().y() << ' ' << pose.translation().z()
		      << ' ' << q.x() << ' ' << q.y() << ' ' << q.z() << ' ' << q.w() << '\n';
	}
}

TEST(TumFolder, RoundTripsDepthsTimesAndPoses)
{
	const auto folder = testFolder() / "tum", log = testFolder() / "log.rawlog";
	writeTumFolder(folder);
	ImportConfig config = importConfigOf(sceneFrame().image, 5000);
	config.robot_from_camera = CPose3D(0.2, 0, 0.5, 0, 0.2, 0);
	const auto poses = robotPosesOfOptical(readTumPoses(folder / "groundtruth.txt"), config.robot_from_camera);
	importTo(log, {listTumFolder(folder), poses}, config);
	const auto frames = replay(configFor(log));
	ASSERT_EQ(frames.size(), 3U);
	for (int i = 0; i < 3; ++i)
	{
		const DepthFrame& frame = frames[static_cast<std::size_t>(i)];
		// A fifth of a millimetre a count.
		expectSameDepths(frame.image, sceneFrame(0.1 * i).image, 1.1e-4);
		EXPECT_NEAR(mrpt::Clock::toDouble(frame.timestamp), 1'305'031'102.25 + 0.5 * i, 1e-6);
		EXPECT_EQ(frame.pose_origin, PoseOrigin::robot_pose);
		expectSamePose(frame.robot_from_camera, config.robot_from_camera);
		expectSamePose(frame.map_from_robot + frame.robot_from_camera, mapFromCamera(i), 1e-6);
	}
}

TEST(TumFolder, RefusesWhatDoesNotParseWithFileAndLine)
{
	const auto folder = testFolder() / "tum";
	writeTumFolder(folder);
	const auto refusal = [&](const std::string& list)
	{
		writeBytes(folder / "depth.txt", list);
		return messageOf<InputError>([&] { listTumFolder(folder); });
	};
	EXPECT_THAT(refusal("# only comments\n"), testing::HasSubstr("lists no image"));
	EXPECT_THAT(refusal("1.0 depth/0.png\nhello\n"), testing::HasSubstr("depth.txt:2: 'hello'"));
	EXPECT_THAT(refusal("2.0 depth/0.png\n1.0 depth/1.png\n"), testing::HasSubstr("depth.txt:2"));
	EXPECT_THAT(refusal("1.0 depth/77.png\n"), testing::HasSubstr("depth/77.png"));
	EXPECT_THAT(refusal("nan depth/0.png\n"), testing::HasSubstr("depth.txt:1"));
	std::filesystem::remove(folder / "depth.txt");
	EXPECT_THAT(messageOf<InputError>([&] { listTumFolder(folder); }), testing::HasSubstr("No such file"));

	for (const char* line :
	     {"1 2 3\n", "1 0 0 0 0 0 0 0\n", "1 0 0 0 nan 0 0 1\n", "x 0 0 0 0 0 0 1\n", "1 0 0 1e9 0 0 0 1\n"})
	{
		writeBytes(folder / "groundtruth.txt", std::string("# poses\n") + line);
		EXPECT_THAT(messageOf<InputError>([&] { readTumPoses(folder / "groundtruth.txt"); }),
		            testing::HasSubstr("groundtruth.txt:2"))
		    << line;
	}
}

}  // namespace
}  // namespace explore::test

#include "rawlog_fixture.h"

#include <explore/core/geometry.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "support/analytic_scene.h"

namespace explore::test
{
Listener::Listener()
{
	logging_enable_console_output = false;
	logging_enable_keep_record = false;
	setMinLoggingLevel(mrpt::system::LVL_DEBUG);
	logRegisterCallback([this](std::string_view text, const mrpt::system::VerbosityLevel level, std::string_view,
	                           const mrpt::Clock::time_point) { m_messages.emplace_back(level, std::string(text)); });
}

std::size_t Listener::warnings(const std::string& part) const
{
	return static_cast<std::size_t>(std::count_if(m_messages.begin(), m_messages.end(),
	                                              [&](const auto& message) {
		                                              return message.first >= mrpt::system::LVL_WARN &&
		                                                     message.second.find(part) != std::string::npos;
	                                              }));
}

bool Listener::said(const std::string& part) const
{
	return std::any_of(m_messages.begin(), m_messages.end(),
	                   [&](const auto& message) { return message.second.find(part) != std::string::npos; });
}

std::filesystem::path testFolder()
{
	const auto* info = testing::UnitTest::GetInstance()->current_test_info();
	std::string name = std::string("explore_") + info->test_suite_name() + "_" + info->name();
	std::replace(name.begin(), name.end(), '/', '_');
	std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / name;
	static std::filesystem::path made;
	if (made != folder)
	{
		std::filesystem::remove_all(folder);
		std::filesystem::create_directories(folder);
		made = folder;
	}
	return folder;
}

void writeRawlog(const std::filesystem::path& path, const Objects& objects, Packing packing)
{
	const auto write = [&](auto&& stream)
	{
		auto archive = mrpt::serialization::archiveFrom(stream);
		for (const auto& object : objects) archive << *object;
	};
	if (packing == Packing::gzipped)
		write(mrpt::io::CFileGZOutputStream(path.string()));
	else
		write(mrpt::io::CFileOutputStream(path.string()));
}

std::string readBytes(const std::filesystem::path& path)
{
	std::ifstream file(path, std::ios::binary);
	return {std::istreambuf_iterator<char>(file), {}};
}

void writeBytes(const std::filesystem::path& path, const std::string& bytes)
{
	std::ofstream(path, std::ios::binary) << bytes;
}

mrpt::Clock::time_point at(double seconds)
{
	return mrpt::Clock::fromDouble(1'500'000'000.0 + seconds);
}

DepthFrame sceneFrame(double x_in_map_m)
{
	static const Scene scene = corridorScene(6.0, {2.0}, {3.5});
	const mrpt::poses::CPose3D map_from_robot(x_in_map_m, 0.1, 0, 0.05, 0, 0),
	    robot_from_camera(0.1, -0.02, 0.6, 0, 0.1, 0);
	DepthFrame frame = renderFrame(scene, map_from_robot, robot_from_camera, xtionIntrinsics(80, 60));
	for (float& depth_m : frame.image.depth_m) depth_m = std::round(depth_m * 1000.0F) / 1000.0F;
	return frame;
}

mrpt::obs::CObservation3DRangeScan::Ptr scanOf(const DepthFrame& frame, double seconds)
{
	auto scan = mrpt::obs::CObservation3DRangeScan::Create();
	const CameraIntrinsics& camera = frame.image.intrinsics;
	scan->timestamp = at(seconds);
	scan->sensorLabel = "CAM";
	scan->sensorPose = frame.robot_from_camera;
	scan->hasRangeImage = true;
	scan->rangeUnits = 0.001F;
	scan->cameraParams.ncols = static_cast<std::uint32_t>(camera.width_px);
	scan->cameraParams.nrows = static_cast<std::uint32_t>(camera.height_px);
	scan->cameraParams.setIntrinsicParamsFromValues(camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px);
	scan->rangeImage.setSize(camera.height_px, camera.width_px);
	for (int v = 0; v < camera.height_px; ++v)
		for (int u = 0; u < camera.width_px; ++u)
			scan->rangeImage(v, u) = static_cast<std::uint16_t>(std::lround(frame.image.at(u, v) * 1000.0F));
	return scan;
}

Objects sampleLog()
{
	Objects objects;
	for (std::size_t i = 0; i < kSampleFrames; ++i)
	{
		const double time_s = 0.1 * static_cast<double>(i);
		auto odometry = mrpt::obs::CObservationOdometry::Create();
		odometry->timestamp = at(time_s);
		odometry->sensorLabel = "ODO";
		odometry->odometry = mrpt::poses::CPose2D(time_s, 0, 0);
		objects.push_back(odometry);
		objects.push_back(scanOf(sceneFrame(time_s), time_s));
	}
	return objects;
}

std::string sampleBytes(Packing packing)
{
	writeRawlog(testFolder() / "whole.rawlog", sampleLog(), packing);
	return readBytes(testFolder() / "whole.rawlog");
}

SourceConfig configFor(const std::filesystem::path& rawlog)
{
	SourceConfig config;
	config.rawlog = rawlog.string();
	return config;
}

std::vector<DepthFrame> replay(const SourceConfig& config, SourceReport* report, Listener* listener)
{
	Listener own;
	const auto source = makeSource(config, listener != nullptr ? *listener : own);
	std::vector<DepthFrame> frames;
	while (auto frame = source->next()) frames.push_back(std::move(*frame));
	if (report != nullptr) *report = source->report();
	return frames;
}

void expectSameDepths(const DepthImage& image, const DepthImage& truth, double tolerance_m)
{
	ASSERT_EQ(image.intrinsics, truth.intrinsics);
	ASSERT_EQ(image.depth_m.size(), truth.depth_m.size());
	for (std::size_t i = 0; i < truth.depth_m.size(); ++i)
		ASSERT_NEAR(image.depth_m[i], truth.depth_m[i], tolerance_m) << "pixel " << i;
}

void expectFinite(const DepthFrame& frame)
{
	for (const float depth_m : frame.image.depth_m) ASSERT_TRUE(std::isfinite(depth_m) && depth_m >= 0.0F);
	for (const auto* axis : {&frame.points_in_camera.x, &frame.points_in_camera.y, &frame.points_in_camera.z})
		for (const float value_m : *axis) ASSERT_TRUE(std::isfinite(value_m));
	ASSERT_TRUE(isometryOf(frame.robot_from_camera).matrix().allFinite());
	ASSERT_TRUE(isometryOf(frame.map_from_robot).matrix().allFinite());
	const CameraIntrinsics any{1, 1, 1, 1, 0, 0};
	ASSERT_TRUE(rayOfPixel(frame.image.empty() ? any : frame.image.intrinsics, 0, 0).allFinite());
}

void expectSamePose(const mrpt::poses::CPose3D& pose, const mrpt::poses::CPose3D& truth, double tolerance)
{
	EXPECT_TRUE(isometryOf(pose).isApprox(isometryOf(truth), tolerance))
	    << pose.asString() << " is not " << truth.asString();
}
}  // namespace explore::test

// The camera as a sensor of rawlog-grabber: loaded as it loads it, and run by the program itself.
#include "apps/program.h"
#include "openni2/virtual_camera.h"
#include "support/test_files.h"

#include <explore/core/errors.h>
#include <gmock/gmock.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/hwdrivers/CGenericSensor.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/system/os.h>

#include <chrono>
#include <numbers>

using namespace explore;
using namespace explore::test;
using namespace std::chrono_literals;
using mrpt::hwdrivers::CGenericSensor;
using mrpt::obs::CObservation3DRangeScan;
using std::chrono::steady_clock;
using testing::HasSubstr;

namespace
{
std::string iniOf(const std::string& more)
{
	return "[XTION]\ndriver = ExploreOpenNI2\nprocess_rate = 90\nsensorLabel = XTION\nwidth_px = 160\nheight_px = 120\n"
	       "pose_x = 0.1\npose_z = 0.5\npose_pitch = 10\n" +
	       more;
}

CGenericSensor::Ptr sensorWith(const std::string& more)
{
	static const bool kLoaded = mrpt::system::loadPluginModule(EXPLORE_GRABBER_PLUGIN);
	EXPECT_TRUE(kLoaded);
	auto sensor = CGenericSensor::createSensorPtr("ExploreOpenNI2");
	if (!sensor) throw std::runtime_error("the plugin has no such sensor");
	sensor->loadConfig(mrpt::config::CConfigFileMemory(iniOf(more)), "XTION");
	return sensor;
}

DepthImage depthOf(CObservation3DRangeScan& scan)
{
	scan.load();
	DepthImage depth;
	for (int v = 0; v < scan.rangeImage.rows(); ++v)
		for (int u = 0; u < scan.rangeImage.cols(); ++u)
			depth.depth_m.push_back(static_cast<float>(scan.rangeImage(v, u)) * scan.rangeUnits);
	return depth;
}

void expectAsServed(CObservation3DRangeScan& scan, const VirtualCamera& camera)
{
	EXPECT_EQ(scan.sensorLabel, "XTION");
	EXPECT_GE(camera.imageOf(depthOf(scan)), 0) << "none of the camera's images";
	EXPECT_NEAR(scan.sensorPose.x(), 0.1, 1e-9);
	EXPECT_NEAR(scan.sensorPose.z(), 0.5, 1e-9);
	EXPECT_NEAR(scan.sensorPose.pitch(), 10 * std::numbers::pi / 180, 1e-6);
}
}  // namespace

TEST(Grabber, TheSensorDeliversWhatTheCameraSees)
{
	const VirtualCamera camera;
	const auto sensor = sensorWith("");
	sensor->initialize();
	EXPECT_EQ(sensor->getState(), CGenericSensor::ssWorking);
	std::vector<CObservation3DRangeScan::Ptr> scans;
	const auto due = steady_clock::now() + 30s;
	while (scans.size() < 20 && steady_clock::now() < due)
	{
		sensor->doProcess();
		for (const auto& [time, entry] : sensor->getObservations())
			scans.push_back(std::dynamic_pointer_cast<CObservation3DRangeScan>(entry));
	}
	ASSERT_GE(scans.size(), 20U);
	for (const auto& scan : scans) expectAsServed(*scan, camera);
	for (std::size_t i = 1; i < scans.size(); ++i) EXPECT_GT(scans[i]->timestamp, scans[i - 1]->timestamp);
}

TEST(Grabber, TheDocumentedIniIsAccepted)
{
	sensorWith("");  // loads the plugin
	const auto sensor = CGenericSensor::createSensorPtr("ExploreOpenNI2");
	sensor->loadConfig(mrpt::config::CConfigFile(std::string(EXPLORE_SOURCE_DIR) + "/doc/examples/grabber.ini"),
	                   "XTION");
	EXPECT_EQ(sensor->getSensorLabel(), "XTION");
	EXPECT_EQ(sensor->getProcessRate(), 90);
}

TEST(Grabber, AWrongKeyIsNamedWithItsSection)
{
	for (const auto& [line, named] : {std::pair<const char*, const char*>{"widht_px = 320\n", "widht_px"},
	                                  {"rate_hz = 0\n", "rate_hz"},
	                                  {"pose_z = high\n", "pose_z"}})
		try
		{
			sensorWith(line);
			FAIL() << line;
		}
		catch (const std::exception& error)  // loadConfig() makes one of its own of it
		{
			EXPECT_THAT(error.what(), HasSubstr(named));
			EXPECT_THAT(error.what(), HasSubstr("XTION"));
		}
}

TEST(Grabber, WithoutACameraItSaysWhatToCheck)
{
	VirtualCamera camera;
	camera.set("plugged", "0");
	const auto sensor = sensorWith("");
	try
	{
		sensor->initialize();
		FAIL() << "opened nothing";
	}
	catch (const SensorLost& error)
	{
		EXPECT_THAT(error.what(), HasSubstr("udev"));
	}
	EXPECT_NE(sensor->getState(), CGenericSensor::ssWorking);
}

TEST(Grabber, RawlogGrabberWritesItsFrames)
{
	const std::string program = "/usr/bin/rawlog-grabber";
	if (!std::filesystem::exists(program)) GTEST_SKIP() << "without rawlog-grabber (package mrpt-apps)";
	const VirtualCamera camera;
	const auto folder = testFolder();
	std::filesystem::create_directories(folder);
	writeFile(folder / "grabber.ini", "[global]\nrawlog_prefix = " + (folder / "log").string() +
	                                      "\ntime_between_launches = 10\nuse_sensoryframes = 0\nGRABBER_PERIOD_MS = "
	                                      "200\nrawlog_GZ_compress_level = 1\n\n" +
	                                      iniOf(""));
	// It goes on until something can be read from its standard input, or that ends.
	const std::string command =
	    "sleep 4 | " + program + " -p " + EXPLORE_GRABBER_PLUGIN + " " + (folder / "grabber.ini").string();
	const ProgramResult result = Program("/bin/sh", {"-c", command}, {}).wait();
	std::filesystem::path log;
	for (const auto& file : std::filesystem::directory_iterator(folder))
		if (file.path().extension() == ".rawlog") log = file.path();
	mrpt::obs::CRawlog rawlog;
	ASSERT_TRUE(rawlog.loadFromRawLogFile(log.string())) << result.out << result.err;
	std::size_t scans = 0;
	for (std::size_t i = 0; i < rawlog.size(); ++i)
		if (const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(rawlog.getAsGeneric(i)))
		{
			expectAsServed(*scan, camera);
			++scans;
		}
	EXPECT_GE(scans, 30U) << "of about 100 in four seconds\n" << result.out << result.err;
}

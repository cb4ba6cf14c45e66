// Objects that are intact must never be refused, whatever their labels and sizes; absurd sizes must be.
#include <explore/core/errors.h>
#include <explore/sources/rawlog_info.h>
#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPosePDFGaussian.h>

#include <cstring>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
using mrpt::obs::CObservation;
using mrpt::obs::CObservation3DRangeScan;

template <class Map>
mrpt::obs::CObservationPointCloud::Ptr cloudIn(int points)
{
	auto map = Map::Create();
	for (int i = 0; i < points; ++i) map->insertPoint(1.0F, 2.0F, static_cast<float>(i));
	auto observation = mrpt::obs::CObservationPointCloud::Create();
	observation->pointcloud = map;
	return observation;
}

CObservation3DRangeScan::Ptr fullScan(const std::string& layer, bool points)
{
	auto scan = scanOf(sceneFrame(), 0);
	scan->rangeImageOtherLayers[layer] = scan->rangeImage;
	scan->hasIntensityImage = scan->hasConfidenceImage = true;
	scan->intensityImage.resize(20, 10, mrpt::img::CH_RGB);
	scan->confidenceImage.resize(20, 10, mrpt::img::CH_GRAY);
	scan->hasPoints3D = points;
	if (points) scan->resizePoints3DVectors(100);
	return scan;
}

std::vector<CObservation::Ptr> oneOfEach(const std::string& layer)
{
	auto laser = mrpt::obs::CObservation2DRangeScan::Create();
	laser->resizeScanAndAssign(361, 5.0F, true);
	auto rotating = mrpt::obs::CObservationRotatingScan::Create();
	rotating->rowCount = 16, rotating->columnCount = 300;
	rotating->rangeImage.setSize(16, 300);
	auto velodyne = mrpt::obs::CObservationVelodyneScan::Create();
	velodyne->scan_packets.resize(7);
	auto image = mrpt::obs::CObservationImage::Create();
	image->image.resize(30, 20, mrpt::img::CH_RGB);
	return {scanOf(sceneFrame(), 0),
	        fullScan(layer, false),
	        fullScan(layer, true),
	        laser,
	        rotating,
	        velodyne,
	        image,
	        cloudIn<mrpt::maps::CSimplePointsMap>(0),
	        cloudIn<mrpt::maps::CSimplePointsMap>(200),
	        cloudIn<mrpt::maps::CColouredPointsMap>(200),
	        cloudIn<mrpt::maps::CPointsMapXYZI>(200)};
}

TEST(GuardedArchive, AcceptsEveryIntactObjectWhateverItsLabel)
{
	// Labels of two, four and eight bytes look like numbers, and their letters like enormous ones.
	for (std::size_t length = 0; length <= 12; ++length)
	{
		const std::string label(length, '~');
		Objects objects;
		auto sensory_frame = mrpt::obs::CSensoryFrame::Create();
		for (const auto& observation : oneOfEach(label))
		{
			observation->sensorLabel = label;
			observation->timestamp = at(1);
			objects.push_back(observation);
			sensory_frame->insert(observation);
		}
		objects.push_back(sensory_frame);
		writeRawlog(testFolder() / "all.rawlog", objects);
		const RawlogInfo info = describeRawlog(testFolder() / "all.rawlog");
		EXPECT_FALSE(info.damage) << length << ": " << info.damage->what;
		EXPECT_EQ(info.objects, objects.size());
	}
}

/** The log of a first frame and `object`, with the bytes `before` (in the object) replaced by `after`. */
std::string damageOf(const mrpt::serialization::CSerializable::Ptr& object, const std::string& before,
                     const std::string& after)
{
	writeRawlog(testFolder() / "first.rawlog", {scanOf(sceneFrame(), 0)}, Packing::plain);
	writeRawlog(testFolder() / "two.rawlog", {scanOf(sceneFrame(), 0), object}, Packing::plain);
	std::string bytes = readBytes(testFolder() / "two.rawlog");
	const std::size_t place = bytes.find(before, std::filesystem::file_size(testFolder() / "first.rawlog"));
	EXPECT_NE(place, std::string::npos);
	bytes.replace(place, before.size(), after);
	writeBytes(testFolder() / "two.rawlog", bytes);
	const auto damage = describeRawlog(testFolder() / "two.rawlog").damage;
	return damage ? damage->what : "none";
}

std::string littleEndian(std::initializer_list<std::uint32_t> numbers)
{
	std::string text;
	for (const std::uint32_t number : numbers)
		for (unsigned shift = 0; shift < 32; shift += 8) text += static_cast<char>((number >> shift) & 0xffU);
	return text;
}

TEST(GuardedArchive, RefusesAbsurdSizes)
{
	constexpr std::uint32_t kHuge = 0x7fffffff, kTopBit = 0x80000000;
	const auto points = fullScan("layer", true);
	EXPECT_THAT(damageOf(points, littleEndian({60, 80}), littleEndian({60 | kTopBit, 80})),
	            testing::HasSubstr("more memory"));
	EXPECT_THAT(damageOf(points, littleEndian({60, 80}), littleEndian({60, 80 | kTopBit})),
	            testing::HasSubstr("more memory"));
	EXPECT_THAT(damageOf(points, littleEndian({60, 80}), littleEndian({kHuge, kHuge})),
	            testing::HasSubstr("more memory"));
	EXPECT_THAT(damageOf(points, "layer" + littleEndian({80, 60}), "layer" + littleEndian({80, kHuge})),
	            testing::HasSubstr("more memory"));
	EXPECT_THAT(damageOf(points, littleEndian({100}), littleEndian({kHuge})), testing::HasSubstr("more memory"));
	EXPECT_THAT(damageOf(cloudIn<mrpt::maps::CSimplePointsMap>(200), littleEndian({200}), littleEndian({kHuge})),
	            testing::HasSubstr("more memory"));
	auto laser = mrpt::obs::CObservation2DRangeScan::Create();
	laser->resizeScanAndAssign(361, 5.0F, true);
	EXPECT_THAT(damageOf(laser, littleEndian({361}), littleEndian({kHuge})), testing::HasSubstr("more memory"));
	EXPECT_THAT(damageOf(points, littleEndian({20, 10}), littleEndian({kHuge, 10})), testing::HasSubstr("more memory"));
	auto velodyne = mrpt::obs::CObservationVelodyneScan::Create();
	velodyne->scan_packets.resize(77);
	EXPECT_THAT(damageOf(velodyne, littleEndian({77}), littleEndian({kHuge})), testing::HasSubstr("more memory"));
}

TEST(GuardedArchive, RefusesFlagsThatAreNeitherTrueNorFalse)
{
	// Behind the range image: no intensity, no confidence, then the header of the camera's parameters.
	const auto scan = scanOf(sceneFrame(), 0);
	const std::string camera = static_cast<char>(0x80 | 18) + std::string("mrpt::img::TCamera");
	for (const unsigned char flag : {0x02, 0x09, 0x41, 0x80, 0x81, 0xff})
	{
		std::string before("\0\0", 2), after = {static_cast<char>(flag), '\0'};
		EXPECT_NE(damageOf(scan, before.append(camera), after.append(camera)), "none") << int{flag};
	}
}

TEST(GuardedArchive, RefusesSpoiltFlagsOfAnImu)
{
	auto imu = mrpt::obs::CObservationIMU::Create();
	for (const auto index : {mrpt::obs::IMU_X_ACC, mrpt::obs::IMU_Y_ACC, mrpt::obs::IMU_Z_ACC}) imu->set(index, 9.8);
	const std::string flags = std::string(3, '\1') + std::string(mrpt::obs::COUNT_IMU_DATA_FIELDS - 3, '\0');
	std::string spoilt = flags;
	spoilt[1] = '\x9';
	EXPECT_THAT(damageOf(imu, flags, spoilt), testing::HasSubstr("flags"));
	EXPECT_EQ(damageOf(imu, flags, flags), "none");
}

TEST(GuardedArchive, RefusesAMovementWhoseDensityIsNone)
{
	mrpt::obs::CActionRobotMovement2D movement;
	movement.computeFromOdometry(mrpt::poses::CPose2D(0.1, 0, 0), {});
	auto action = mrpt::obs::CActionCollection::Create();
	action->insert(movement);
	writeRawlog(testFolder() / "action.rawlog", {action}, Packing::plain);
	const std::string name = "CActionRobotMovement2D", bytes = readBytes(testFolder() / "action.rawlog");
	const std::string head = bytes.substr(bytes.find(name), name.size() + 1);  // and the version
	EXPECT_THAT(damageOf(action, head + littleEndian({0}), head + littleEndian({1})),
	            testing::HasSubstr("probability density"));

	movement.estimationMethod = mrpt::obs::CActionRobotMovement2D::emScan2DMatching;
	movement.poseChange = mrpt::poses::CPosePDFGaussian::Create(mrpt::poses::CPose2D(1, 2, 0.3));
	auto matched = mrpt::obs::CActionCollection::Create();
	matched->insert(movement);
	writeRawlog(testFolder() / "matched.rawlog", {scanOf(sceneFrame(), 0), matched, scanOf(sceneFrame(), 1)});
	EXPECT_FALSE(describeRawlog(testFolder() / "matched.rawlog").damage);
}
}  // namespace
}  // namespace explore::test

#include "apps/annotated_files.h"

#include "apps/rawlog_maker.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservation3DScene.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

namespace explore::test
{
using namespace mrpt::obs;
using nlohmann::json;
namespace fs = std::filesystem;

namespace
{
std::vector<std::uint8_t> bytesOf(const mrpt::serialization::CSerializable& object)
{
	std::vector<std::uint8_t> bytes;
	mrpt::serialization::ObjectToOctetVector(&object, bytes);
	return bytes;
}

}  // namespace

Objects objectsIn(const fs::path& file)
{
	mrpt::io::CFileGZInputStream stream(file.string());
	auto archive = mrpt::serialization::archiveFrom(stream);
	Objects objects;
	try
	{
		while (true) objects.push_back(archive.ReadObject());
	}
	catch (const std::exception&)
	{
		// MRPT's way of telling the end.
	}
	return objects;
}

bool isAnnotation(const CObservation& observation)
{
	return observation.sensorLabel.rfind("explore.", 0) == 0 || IS_CLASS(observation, CObservation3DScene);
}

ProgramResult annotate(const fs::path& log, const fs::path& out, const std::vector<std::string>& more,
                       const Program::Setup& setup)
{
	std::vector<std::string> arguments{"--ini", "corridor.ini", "--rawlog", log.string(),           "--quiet",
	                                   "--out", out.string(),   "--set",    "output.annotated=true"};
	arguments.insert(arguments.end(), more.begin(), more.end());
	return exploreMrpt(arguments, setup);
}

void writeManySensors(const fs::path& path, std::size_t frames)
{
	const fs::path plain = path.parent_path() / "plain.rawlog";
	writeCorridorRawlog(plain, {frames});
	mrpt::io::CFileGZOutputStream file(path.string());
	auto archive = mrpt::serialization::archiveFrom(file);
	CObservationComment comment;
	comment.text = "recorded on a Monday";
	archive << comment;
	for (const auto& object : objectsIn(plain))
	{
		const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(object);
		if (scan)
		{
			CObservation2DRangeScan laser;
			laser.timestamp = scan->timestamp - std::chrono::milliseconds(20);
			laser.sensorLabel = "LASER";
			laser.resizeScan(7);
			laser.setScanRange(3, 1.5F);
			archive << laser;
			CObservationIMU imu;
			imu.timestamp = scan->timestamp + std::chrono::milliseconds(5);
			imu.sensorLabel = "IMU";
			imu.set(IMU_X_ACC, 0.01), imu.set(IMU_Y_ACC, 0.0), imu.set(IMU_Z_ACC, 9.81);
			archive << imu;
		}
		archive << *object;
		if (!scan) continue;
		scan->sensorLabel = "OTHER_CAMERA";
		archive << *scan;
	}
}

std::vector<json> framesOf(const fs::path& out)
{
	std::vector<json> frames;
	for (const std::string& line : linesOf(readFile(out / "frames.jsonl"))) frames.push_back(json::parse(line));
	return frames;
}

void expectInputUnchanged(const fs::path& log, const fs::path& annotated)
{
	std::vector<CObservation::Ptr> expected;
	for (const auto& object : objectsIn(log))
	{
		if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object))
			expected.insert(expected.end(), frame->begin(), frame->end());
		else if (const auto one = std::dynamic_pointer_cast<CObservation>(object);
		         one && !std::dynamic_pointer_cast<CObservationComment>(object))
			expected.push_back(one);
	}
	std::size_t place = 0;
	for (const auto& object : objectsIn(annotated))
	{
		const auto one = std::dynamic_pointer_cast<CObservation>(object);
		ASSERT_TRUE(one) << "observations alone";
		if (isAnnotation(*one) || IS_CLASS(*one, CObservationComment)) continue;
		ASSERT_LT(place, expected.size());
		EXPECT_TRUE(bytesOf(*one) == bytesOf(*expected[place])) << place << " " << one->sensorLabel;
		++place;
	}
	EXPECT_EQ(place, expected.size());
}
}  // namespace explore::test
